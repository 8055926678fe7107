//! Why a series cannot be fitted.

use std::fmt;

/// Fewer samples than this leave too little over beside up to five parameters.
const NEEDED: usize = 12;

/// Why a series cannot be fitted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FitError {
    /// Times and values differ in number.
    Lengths {
        /// How many times.
        times: usize,
        /// How many values.
        values: usize,
    },
    /// Too few samples.
    TooFew {
        /// How many there are.
        found: usize,
        /// How many it takes.
        needed: usize,
    },
    /// A time or value is NaN or infinite.
    NotFinite {
        /// Its place in the series, from zero.
        index: usize,
    },
    /// A time is not later than the one before.
    NotRising {
        /// Its place in the series, from zero.
        index: usize,
    },
    /// A value, or the time since the start of a power law, is not above zero.
    NotPositive {
        /// Its place in the series, from zero.
        index: usize,
    },
    /// All values are the same.
    Constant {
        /// That value.
        value: f64,
    },
    /// The series is shorter than one period of the oscillation that fits best.
    TooShort {
        /// Length of the series, s.
        length: f64,
        /// That period, s.
        period: f64,
    },
    /// The least-squares iteration found no minimum.
    NotConverged,
}

impl fmt::Display for FitError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            FitError::Lengths { times, values } => write!(
                f,
                "{times} times stand beside {values} values; a fit needs one value to each time"
            ),
            FitError::TooFew { found, needed } => {
                write!(
                    f,
                    "a series of {found} samples is too short to fit; it takes {needed}"
                )
            }
            FitError::NotFinite { index } => {
                write!(f, "sample {index} is not finite; fit the series before it")
            }
            FitError::NotRising { index } => {
                write!(
                    f,
                    "the time of sample {index} is not later than that of the one before"
                )
            }
            FitError::NotPositive { index } => write!(
                f,
                "sample {index}, or its time since the start, is not above zero, as a power law \
                 is; fit a later part"
            ),
            FitError::Constant { value } => {
                write!(f, "all values are {value}; a body at rest has no frequency")
            }
            FitError::TooShort { length, period } => write!(
                f,
                "the series lasts {length:.3e} s, less than one period (about {period:.3e} s); \
                 simulate longer, best three periods or more"
            ),
            FitError::NotConverged => write!(
                f,
                "no damped oscillation fits the series; plot it, and fit a part where it swings"
            ),
        }
    }
}

impl std::error::Error for FitError {}

/// What can be said of a series before it is fitted.
pub(super) fn check(times: &[f64], values: &[f64]) -> Result<(), FitError> {
    if times.len() != values.len() {
        return Err(FitError::Lengths {
            times: times.len(),
            values: values.len(),
        });
    }
    if times.len() < NEEDED {
        return Err(FitError::TooFew {
            found: times.len(),
            needed: NEEDED,
        });
    }
    let finite = |(t, y): (&f64, &f64)| t.is_finite() && y.is_finite();
    if let Some(index) = times.iter().zip(values).position(|sample| !finite(sample)) {
        return Err(FitError::NotFinite { index });
    }
    match times.windows(2).position(|pair| pair[1] <= pair[0]) {
        Some(before) => Err(FitError::NotRising { index: before + 1 }),
        None => Ok(()),
    }
}
