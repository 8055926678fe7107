//! An axis: what it shows, and where a value lies on it.

use super::ticks::{self, Ticks};
use crate::number::{ScaledUnit, in_reach, scaled_unit};

/// How values are laid along an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Equal differences at equal distances.
    Linear,
    /// Equal ratios at equal distances; values not above zero are left out.
    Logarithmic,
}

/// What an axis shows.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    label: String,
    unit: String,
    scale: Scale,
    limits: Option<[f64; 2]>,
}

impl Axis {
    /// A linear axis that holds all data. The unit is the plain one (`s`, not
    /// `ms`), or empty for a plain number; the prefix follows from the data.
    pub fn new(label: &str, unit: &str) -> Self {
        Axis {
            label: label.to_owned(),
            unit: unit.to_owned(),
            scale: Scale::Linear,
            limits: None,
        }
    }

    /// The same with another scale.
    pub fn scale(self, scale: Scale) -> Self {
        Axis { scale, ..self }
    }

    /// The same from `low` to `high`, whatever the data; curves are cut off there.
    /// Limits that make no axis (not finite, in the wrong order) are passed over.
    pub fn limits(self, low: f64, high: f64) -> Self {
        Axis {
            limits: Some([low, high]),
            ..self
        }
    }

    /// Whether a value has a place on the axis.
    pub(crate) fn shows(&self, value: f64) -> bool {
        match self.scale {
            Scale::Linear => value == 0.0 || in_reach(value),
            Scale::Logarithmic => value > 0.0 && in_reach(value),
        }
    }

    /// The axis with its end values, from the limits or from the data with
    /// `margin` (a share of their range) around them.
    pub(crate) fn fit(&self, data: impl Iterator<Item = f64>, margin: f64) -> FittedAxis {
        let logarithmic = self.scale == Scale::Logarithmic;
        let limits = self
            .limits
            .filter(|&[low, high]| low < high && self.shows(low) && self.shows(high));
        let [low, high] = limits.unwrap_or_else(|| self.around(data, margin));
        let unit = scaled_unit(&self.unit, low.abs().max(high.abs()));
        FittedAxis {
            label: self.label.clone(),
            unit,
            logarithmic,
            low,
            high,
        }
    }

    fn around(&self, data: impl Iterator<Item = f64>, margin: f64) -> [f64; 2] {
        let inside = data.filter(|&x| self.shows(x));
        let (low, high) = inside.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
            (low.min(x), high.max(x))
        });
        if low > high {
            return if self.scale == Scale::Linear {
                [0.0, 1.0]
            } else {
                [1.0, 10.0]
            };
        }
        if self.scale == Scale::Logarithmic {
            let wide = if low == high { 2.0 } else { 1.0 };
            let factor = (high / low).powf(margin) * wide;
            return [low / factor, high * factor];
        }
        // A constant gets room on both sides, so that it is seen to be one.
        let range = if high - low > 1e-12 * high.abs().max(low.abs()) {
            margin * (high - low)
        } else if high == 0.0 {
            1.0
        } else {
            0.05 * high.abs()
        };
        // What is never negative does not get a negative piece of axis.
        let below = if low >= 0.0 && low < range {
            0.0
        } else {
            low - range
        };
        [below, high + range]
    }
}

/// An axis with its ends.
#[derive(Clone, Debug)]
pub(crate) struct FittedAxis {
    label: String,
    unit: ScaledUnit,
    logarithmic: bool,
    low: f64,
    high: f64,
}

impl FittedAxis {
    /// Where a value lies: 0 at the low end, 1 at the high one.
    pub fn share(&self, value: f64) -> f64 {
        if self.logarithmic {
            (value / self.low).ln() / (self.high / self.low).ln()
        } else {
            (value - self.low) / (self.high - self.low)
        }
    }

    /// The label with the unit.
    pub fn title(&self) -> String {
        if self.unit.unit.is_empty() {
            self.label.clone()
        } else {
            format!("{} ({})", self.label, self.unit.unit)
        }
    }

    /// Ticks, about `count`, their values in the plain unit.
    pub fn ticks(&self, count: f64) -> Ticks {
        let factor = self.unit.factor;
        let (low, high) = (self.low / factor, self.high / factor);
        let mut ticks = if self.logarithmic {
            ticks::logarithmic(low, high, count)
        } else {
            ticks::linear(low, high, count)
        };
        ticks.labelled.iter_mut().for_each(|(x, _)| *x *= factor);
        ticks.small.iter_mut().for_each(|x| *x *= factor);
        ticks
    }
}
