//! What to measure, and how long.

use meniscus::pairs::{Instructions, Precision};

use crate::variant::Variant;

/// What to measure.
#[derive(Clone, Debug)]
pub struct Options {
    /// Dimensions, 2 and 3.
    pub dimensions: Vec<usize>,
    /// Numbers of particles.
    pub sizes: Vec<usize>,
    /// Numbers of threads; rises, and begins with 1.
    pub threads: Vec<usize>,
    /// Ways of the engine.
    pub variants: Vec<Variant>,
    /// How long.
    pub effort: Effort,
}

/// How long to measure.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    /// Least length of a sample, s.
    pub sample: f64,
    /// Most samples of one cost.
    pub samples: usize,
    /// Fewest samples, however long they take.
    pub fewest: usize,
    /// No new samples after this time on one set of costs, s.
    pub budget: f64,
    /// Elements of each array of the triad.
    pub triad: usize,
    /// Particles of the splash that is laid side by side.
    pub splash: usize,
}

impl Effort {
    /// For figures to keep.
    pub const FULL: Effort = Effort {
        sample: 0.01,
        samples: 9,
        fewest: 3,
        budget: 2.5,
        triad: 32 << 20,
        splash: 8000,
    };
    /// For a look.
    pub const QUICK: Effort = Effort {
        sample: 0.004,
        samples: 5,
        fewest: 3,
        budget: 0.4,
        triad: 16 << 20,
        splash: 3000,
    };
}

impl Options {
    /// Everything, in some minutes.
    pub fn full(threads: usize) -> Self {
        Self {
            dimensions: vec![2, 3],
            sizes: vec![10_000, 125_000, 1_000_000],
            threads: up_to(threads),
            variants: [Precision::Double, Precision::Mixed]
                .map(|precision| Variant {
                    precision,
                    instructions: Instructions::Best,
                })
                .to_vec(),
            effort: Effort::FULL,
        }
    }

    /// The smaller sizes, in less than a minute.
    pub fn quick(threads: usize) -> Self {
        Self {
            sizes: vec![10_000, 125_000],
            effort: Effort::QUICK,
            ..Self::full(threads)
        }
    }

    /// From a thousand particles to ten million, on one thread.
    pub fn scaling(effort: Effort) -> Self {
        Self {
            sizes: (3..6)
                .flat_map(|power| [1, 2, 5].map(|digit| digit * 10_usize.pow(power)))
                .chain([1_000_000, 3_000_000, 10_000_000])
                .collect(),
            effort,
            ..Self::full(1)
        }
    }
}

/// One thread, powers of two, and `most`.
fn up_to(most: usize) -> Vec<usize> {
    let most = most.max(1);
    let powers = (0..usize::BITS).map(|k| 1 << k);
    powers.take_while(|&n| n < most).chain([most]).collect()
}

/// Reads "10k", "125k", "1M" or a plain number of particles.
///
/// # Errors
/// If it is none of these, or less than 100.
pub fn particle_count(text: &str) -> Result<usize, String> {
    let (digits, factor) = match text.strip_suffix(['k', 'M']) {
        Some(digits) if text.ends_with('k') => (digits, 1_000),
        Some(digits) => (digits, 1_000_000),
        None => (text, 1),
    };
    let count = (digits.parse::<usize>().ok()).and_then(|count| count.checked_mul(factor));
    count.filter(|&count| count >= 100).ok_or_else(|| {
        format!("expected a number of particles from 100 on, such as 125k or 1M, found {text:?}")
    })
}
