//! The ways of the engine that are measured beside one another.

use meniscus::Simulation;
use meniscus::pairs::{Instructions, Pairs};
use serde::Serialize;

/// Precision and instructions of the sweeps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Variant {
    /// Instructions.
    pub instructions: Instructions,
}

/// Its name in tables and JSON.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct VariantName {
    /// "double".
    pub precision: &'static str,
    /// "best", "avx2" or "portable".
    pub instructions: &'static str,
}

impl Variant {
    /// Its name.
    pub fn name(self) -> VariantName {
        VariantName {
            precision: "double",
            instructions: match self.instructions {
                Instructions::Best => "best",
                Instructions::Avx2 => "avx2",
                Instructions::Portable => "portable",
            },
        }
    }

    /// Sets pairs to it.
    pub fn apply<const D: usize>(self, pairs: &mut Pairs<D>) {
        pairs.set_instructions(self.instructions);
    }

    /// Sets a simulation to it.
    pub fn apply_to<const D: usize>(self, simulation: &mut Simulation<D>) {
        simulation.set_instructions(self.instructions);
    }
}
