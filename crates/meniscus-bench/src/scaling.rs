//! Cost of a step against the number of particles, on one thread.

use meniscus::rates::{Dimension, Space};
use serde::Serialize;

use crate::BenchError;
use crate::clock::Crew;
use crate::cost::Cost;
use crate::machine::{Machine, free_memory};
use crate::options::{Effort, Options};
use crate::state::{Flow, State};
use crate::steps;
use crate::variant::{Variant, VariantName};

/// Memory that is not tried without, B/particle: a flow, what it starts from,
/// and its particles once more for the yardstick.
const ROOM: f64 = 1100.0;
/// From here on a sample or two will do.
const LARGE: usize = 2_000_000;

/// Cost against size.
#[derive(Clone, Debug, Serialize)]
pub struct Scaling {
    /// The machine.
    pub machine: Machine,
    /// Curves.
    pub curves: Vec<ScalingCurve>,
    /// Sizes that there was no memory for.
    pub left_out: Vec<usize>,
}

/// Cost against size of one flow.
#[derive(Clone, Debug, Serialize)]
pub struct ScalingCurve {
    /// 2 or 3.
    pub dimension: usize,
    /// What is solved.
    pub flow: Flow,
    /// Way of the engine.
    pub variant: VariantName,
    /// By size.
    pub points: Vec<ScalingPoint>,
}

/// Cost of one size.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct ScalingPoint {
    /// How many particles.
    pub particles: usize,
    /// Of a step.
    pub cost: Cost,
}

/// Measures each size of `options` on a lattice.
///
/// # Errors
/// If a thread cannot be started, or a flow blows up.
pub fn measure(options: &Options, progress: &mut dyn FnMut(&str)) -> Result<Scaling, BenchError> {
    let room = free_memory().map_or(usize::MAX, |free| (free / ROOM) as usize);
    let (sizes, left_out): (Vec<_>, _) = options.sizes.iter().partition(|&&size| size <= room);
    let crew = [Crew::new(1)?];
    let mut curves = Vec::new();
    for &variant in &options.variants {
        for &dimension in &options.dimensions {
            for flow in Flow::SCALED {
                let mut points = Vec::new();
                for &size in &sizes {
                    progress(&format!("{dimension}D, {size} particles, {}", flow.name()));
                    let effort = match size >= LARGE {
                        true => Effort {
                            fewest: 2,
                            samples: 2,
                            ..options.effort
                        },
                        false => options.effort,
                    };
                    let cost = match dimension {
                        2 => cost::<2>(size, flow, variant, &crew, effort)?,
                        _ => cost::<3>(size, flow, variant, &crew, effort)?,
                    };
                    points.push(ScalingPoint {
                        particles: size,
                        cost,
                    });
                }
                curves.push(ScalingCurve {
                    dimension,
                    flow,
                    variant: variant.name(),
                    points,
                });
            }
        }
    }
    Ok(Scaling {
        machine: Machine::here(),
        curves,
        left_out,
    })
}

fn cost<const D: usize>(
    size: usize,
    flow: Flow,
    variant: Variant,
    crew: &[Crew; 1],
    effort: Effort,
) -> Result<Cost, BenchError>
where
    Space: Dimension<D>,
{
    let state = State::<D>::lattice(size);
    let steps = steps::measure(&state, flow, variant, crew, effort)?;
    Ok(steps[0].cost)
}
