//! The ways of the engine that are measured beside one another.

use meniscus::pairs::{Instructions, Pairs, Precision};
use serde::Serialize;

/// Precision and instructions of the sweeps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Variant {
    /// Precision.
    pub precision: Precision,
    /// Instructions.
    pub instructions: Instructions,
}

/// Its name in tables and JSON.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct VariantName {
    /// "double" or "mixed".
    pub precision: &'static str,
    /// "best", "avx2" or "portable".
    pub instructions: &'static str,
}

impl Variant {
    /// Its name.
    pub fn name(self) -> VariantName {
        VariantName {
            precision: match self.precision {
                Precision::Double => "double",
                Precision::Mixed => "mixed",
            },
            instructions: match self.instructions {
                Instructions::Best => "best",
                Instructions::Avx2 => "avx2",
                Instructions::Portable => "portable",
            },
        }
    }

    /// Sets pairs to it.
    pub fn apply<const D: usize>(self, pairs: &mut Pairs<D>) {
        pairs.set_precision(self.precision);
        pairs.set_instructions(self.instructions);
    }
}
