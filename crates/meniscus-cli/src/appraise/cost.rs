//! What a step with a model costs, beside one without: both in turn, so that a busy machine slows both.

use std::time::Instant;

use meniscus::rates::{Dimension, Space};
use meniscus::{Simulation, SurfaceTension};
use meniscus_case::Case;
use serde::Serialize;

use super::model::Model;
use super::trial::{Flow, Start, Trial};
use crate::failure::Failure;

/// Spacings in the radius of the drop, flat and solid.
const RESOLUTION: [u32; 2] = [30, 13];
/// Steps of each before the other's turn, and turns.
const STEPS: usize = 12;
const TURNS: usize = 9;

/// What a model costs on one thread.
#[derive(Clone, Debug, Serialize)]
pub struct Cost {
    /// The model.
    pub model: &'static str,
    /// 2 or 3.
    pub dimension: usize,
    /// Nanoseconds for a particle and step, the median.
    pub nanoseconds: f64,
    /// The same over that of a step without surface tension, the median of ratios.
    pub over_plain: f64,
}

/// Measures a model on a drop at rest, slightly jittered.
///
/// # Errors
/// If the case is refused, or blows up at once.
pub fn cost(model: Model, dimension: usize) -> Result<Cost, Failure> {
    let trial = Trial {
        test: "cost",
        model,
        dimension,
        resolution: RESOLUTION[dimension - 2],
        variant: String::new(),
        start: Start::Lattice,
        flow: Flow {
            viscosity: 0.05,
            end_time: 1.0,
            bodies: vec![(super::suite::ball(dimension, 0.0), String::new())],
            ..Flow::default()
        },
        readings: Vec::new(),
    };
    let case = trial.case(&meniscus_case::Coefficients::default())?;
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build()
        .map_err(|error| Failure::new(format!("cannot start a thread: {error}")))?;
    pool.install(|| match dimension {
        2 => measure::<2>(model, &case),
        _ => measure::<3>(model, &case),
    })
}

fn measure<const D: usize>(model: Model, case: &Case) -> Result<Cost, Failure>
where
    Space: Dimension<D>,
{
    let start = |surface_tension: Option<SurfaceTension>| {
        let mut setup = case.setup::<D>();
        setup.scheme.surface_tension = surface_tension;
        Simulation::<D>::new(setup).map_err(|error| Failure::new(error.to_string()))
    };
    let mut with = start(case.scheme.surface_tension)?;
    let mut without = start(None)?;
    let mut samples = Vec::new();
    for turn in 0..=TURNS {
        let pair = [time(&mut with)?, time(&mut without)?];
        // The first turn fills caches and grows buffers.
        if turn > 0 {
            samples.push(pair);
        }
    }
    Ok(Cost {
        model: model.name,
        dimension: D,
        nanoseconds: median(samples.iter().map(|[with, _]| *with)),
        over_plain: median(samples.iter().map(|[with, without]| with / without)),
    })
}

/// Nanoseconds for a particle and step.
fn time<const D: usize>(simulation: &mut Simulation<D>) -> Result<f64, Failure> {
    let begin = Instant::now();
    for _ in 0..STEPS {
        (simulation.step()).map_err(|diverged| Failure::new(diverged.to_string()))?;
    }
    let work = (STEPS * simulation.particles().len()) as f64;
    Ok(begin.elapsed().as_secs_f64() * 1e9 / work)
}

fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}
