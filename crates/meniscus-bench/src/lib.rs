//! What the pair engine of Meniscus costs, beside what the machine can do.
//!
//! [`run`] measures in one go, so that its figures can be compared whatever
//! the machine is:
//!
//! - [`peak`]: fused multiply-adds and memory bandwidth of the machine
//! - [`sweeps`]: each sweep alone, and building lists
//! - [`steps`]: the whole step
//! - [`yardstick`]: a plain loop over lists of neighbours, timed in turn with
//!   all that is measured; [`cost`] is told in yardsticks too
//!
//! on the particles of [`state`], and [`memory`]; [`targets`] are set beside
//! that. [`scaling`] is cost against size. [`flops`] counts the operations of a pair
//! formula by running it, [`clock`] tells time on a busy machine.

#![deny(missing_docs)]

pub mod clock;
pub mod cost;
pub mod flops;
pub mod machine;
pub mod memory;
pub mod options;
pub mod peak;
pub mod scaling;
pub mod state;
pub mod steps;
pub mod sweeps;
pub mod targets;
pub mod variant;
pub mod yardstick;

use std::fmt;

use clock::Crew;
use machine::Machine;
use memory::Memory;
use meniscus::rates::{Dimension, Space};
use options::Options;
use peak::Peak;
use serde::Serialize;
use state::{Arrangement, State, Tile};
use steps::StepCost;
use sweeps::Still;
use targets::Target;
use variant::VariantName;

/// Everything that was measured.
#[derive(Clone, Debug, Serialize)]
pub struct Findings {
    /// The machine.
    pub machine: Machine,
    /// The best instructions of the processor that the engine knows.
    pub instructions: &'static str,
    /// Limits of the machine, for each number of threads.
    pub peaks: Vec<Peak>,
    /// How each splash came about.
    pub splashes: Vec<String>,
    /// Costs, one entry for each dimension, size, arrangement and variant.
    pub costs: Vec<Costs>,
    /// Memory, one entry where the system tells.
    pub memory: Vec<Memory>,
    /// What is to be reached.
    pub targets: Vec<Target>,
}

/// Costs on one set of particles.
#[derive(Clone, Debug, Serialize)]
pub struct Costs {
    /// 2 or 3.
    pub dimension: usize,
    /// How particles lie.
    pub arrangement: Arrangement,
    /// How many.
    pub particles: usize,
    /// Way of the engine.
    pub variant: VariantName,
    /// With the particles at rest.
    pub still: Still,
    /// Of whole steps.
    pub steps: Vec<StepCost>,
}

/// Why nothing was measured.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BenchError(String);

impl BenchError {
    fn new(message: &str) -> Self {
        Self(message.to_owned())
    }
}

impl fmt::Display for BenchError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for BenchError {}

macro_rules! from {
    ($($Error:ty),+) => {
        $(impl From<$Error> for BenchError {
            fn from(error: $Error) -> Self {
                Self(error.to_string())
            }
        })+
    };
}

from!(
    meniscus::setup::SetupError,
    meniscus::divergence::Diverged,
    meniscus::shape::FillError,
    rayon::ThreadPoolBuildError
);

/// Measures; `progress` hears what comes next.
///
/// # Errors
/// If a thread cannot be started, or a flow blows up.
pub fn run(options: &Options, progress: &mut dyn FnMut(&str)) -> Result<Findings, BenchError> {
    let crews = (options.threads.iter())
        .map(|&threads| Crew::new(threads))
        .collect::<Result<Vec<_>, _>>()?;
    let Some(largest) = crews.last() else {
        return Err(BenchError::new("there is no thread to measure"));
    };
    // First of all: what is given back later may be reused.
    progress("memory");
    let memory = memory(options, largest)?;
    progress("the machine's limits");
    let machine = Machine::here();
    let samples = options.effort.samples;
    let elements = peak::elements(options.effort.triad, &machine);
    let mut findings = Findings {
        machine,
        instructions: peak::instructions(),
        peaks: (crews.iter())
            .map(|crew| peak::measure(crew, samples, elements))
            .collect(),
        splashes: Vec::new(),
        costs: Vec::new(),
        memory,
        targets: Vec::new(),
    };
    for &dimension in &options.dimensions {
        match dimension {
            2 => costs::<2>(options, &crews, progress, &mut findings)?,
            _ => costs::<3>(options, &crews, progress, &mut findings)?,
        }
    }
    findings.targets = targets::all(&findings);
    Ok(findings)
}

/// Of the last dimension and the largest size.
fn memory(options: &Options, crew: &Crew) -> Result<Vec<Memory>, BenchError> {
    let asked = (options.dimensions.last(), options.sizes.iter().max());
    let (Some(&dimension), Some(&size), Some(&variant)) =
        (asked.0, asked.1, options.variants.first())
    else {
        return Ok(Vec::new());
    };
    let memory = match dimension {
        2 => memory::measure::<2>(size, variant, crew)?,
        _ => memory::measure::<3>(size, variant, crew)?,
    };
    Ok(memory.into_iter().collect())
}

fn costs<const D: usize>(
    options: &Options,
    crews: &[Crew],
    progress: &mut dyn FnMut(&str),
    findings: &mut Findings,
) -> Result<(), BenchError>
where
    Space: Dimension<D>,
{
    let Some(largest) = crews.last() else {
        return Err(BenchError::new("there is no thread to measure"));
    };
    let largest_size = options.sizes.iter().copied().max().unwrap_or(0);
    let tile_size = options.effort.splash.min(largest_size);
    progress(&format!("{D}D, marching a splash"));
    let tile = largest.work(|| Tile::<D>::march(tile_size))?;
    findings.splashes.push(format!("{D}D: {}", tile.story()));
    for &size in &options.sizes {
        for state in [State::lattice(size), State::splash(&tile, size)] {
            for &variant in &options.variants {
                let (name, precision) = (state.arrangement.name(), variant.name().precision);
                let what = format!("{D}D, {size} particles, {name}, {precision}");
                progress(&format!("{what}: sweeps"));
                let effort = options.effort;
                let still = sweeps::measure(&state, variant, crews, &findings.peaks, effort)?;
                let mut steps = Vec::new();
                for &flow in state.flows() {
                    progress(&format!("{what}: steps, {}", flow.name()));
                    steps.extend(steps::measure(&state, flow, variant, crews, effort)?);
                }
                findings.costs.push(Costs {
                    dimension: D,
                    arrangement: state.arrangement,
                    particles: size,
                    variant: variant.name(),
                    still,
                    steps,
                });
            }
        }
    }
    Ok(())
}
