//! The whole step of a running flow. A sample is the life of one set of
//! lists, from one build to the next, so that each carries its share.

use std::time::Instant;

use meniscus::Simulation;
use meniscus::rates::{Dimension, Space};
use serde::Serialize;

use crate::BenchError;
use crate::clock::{Crew, median};
use crate::cost::{Cost, Pace, Samples};
use crate::options::Effort;
use crate::state::{Flow, SOUND_SPEED, State, smoothing_length};
use crate::variant::Variant;
use crate::yardstick::Yardstick;

/// A flow starts anew after so many steps: what was a lattice is to stay one.
const LIFE: u64 = 24;
/// Lists that live longer are not waited for.
const LONGEST_LIST: u64 = 12;
/// More than any cache holds, in 3D, with their lists.
const YARDSTICK_ROWS: usize = 200_000;

/// Cost of a whole step.
#[derive(Clone, Debug, Serialize)]
pub struct StepCost {
    /// What was solved.
    pub flow: Flow,
    /// Threads.
    pub threads: usize,
    /// Per particle and step.
    pub cost: Cost,
    /// Particle-steps a second, by the median.
    pub rate: f64,
    /// Wall time on one thread over that on these, of samples side by side.
    pub speed_up: f64,
    /// Steps that lists lived for, the median.
    pub steps_per_list: f64,
    /// Share of particles that the surface force acts on.
    pub surface_active: f64,
    /// Fastest particle over the sound speed.
    pub mach_number: f64,
}

/// Measures `flow` from `state` on each crew.
///
/// # Errors
/// If the flow blows up.
pub fn measure<const D: usize>(
    state: &State<D>,
    flow: Flow,
    variant: Variant,
    crews: &[Crew],
    effort: Effort,
) -> Result<Vec<StepCost>, BenchError>
where
    Space: Dimension<D>,
{
    let Some(largest) = crews.last() else {
        return Err(BenchError::new("there is no thread to measure"));
    };
    let mut simulation = largest.work(|| start(state, flow, variant))?;
    // The yardstick stands still, on the particles as they are now.
    let particles = simulation.particles().clone();
    let rows = middle(particles.len());
    let h = smoothing_length(D);
    let yardstick = largest.work(|| Yardstick::new(&particles, rows, h, 0.1));
    let mut pace = Pace::new(&yardstick);
    // A floor is part of what the liquid costs.
    let n = particles.body.iter().filter(|&&body| body == 0).count() as f64;
    let mut samples = vec![Samples::default(); crews.len()];
    let mut lives = Vec::new();
    let begin = Instant::now();
    for round in 0..effort.samples {
        if round >= effort.fewest && begin.elapsed().as_secs_f64() > effort.budget {
            break;
        }
        for (crew, samples) in crews.iter().zip(&mut samples) {
            let beside = pace.sample(crew, effort.sample);
            let mut total = crate::clock::Spent::default();
            let mut steps = 0;
            while total.seconds < effort.sample {
                if simulation.steps() >= LIFE {
                    simulation = largest.work(|| start(state, flow, variant))?;
                }
                let mut life = Ok(0);
                let spent = crew.time(|| life = live(&mut simulation));
                let life = life?;
                lives.push(life as f64);
                steps += life;
                total.seconds += spent.seconds;
                total.wall += spent.wall;
            }
            samples.push(total, n * steps as f64, beside);
        }
    }
    let fastest = |s: &Simulation<D>| {
        let speeds = s.particles().velocity.iter().map(|v| v.norm());
        speeds.fold(0.0, f64::max)
    };
    Ok((crews.iter().zip(&samples))
        .map(|(crew, own)| {
            let cost = own.cost();
            StepCost {
                flow,
                threads: crew.threads,
                cost,
                rate: 1e9 / cost.nanoseconds,
                speed_up: samples[0].wall_over(own),
                steps_per_list: median(lives.iter().copied()),
                surface_active: simulation.surface().active() as f64 / n,
                mach_number: fastest(&simulation) / SOUND_SPEED,
            }
        })
        .collect())
}

/// Rows for the yardstick to go round in.
fn middle(particles: usize) -> std::ops::Range<usize> {
    let rows = particles.min(YARDSTICK_ROWS);
    let first = (particles - rows) / 2;
    first..first + rows
}

/// A flow with lists whose skin is chosen by its motion.
fn start<const D: usize>(
    state: &State<D>,
    flow: Flow,
    variant: Variant,
) -> Result<Simulation<D>, BenchError>
where
    Space: Dimension<D>,
{
    let mut simulation = state.simulation(flow, variant)?;
    live(&mut simulation)?;
    Ok(simulation)
}

/// Steps until lists are built; gives how many.
fn live<const D: usize>(simulation: &mut Simulation<D>) -> Result<u64, BenchError> {
    let (first, lists) = (simulation.steps(), simulation.pairs().builds());
    while simulation.pairs().builds() == lists && simulation.steps() < first + LONGEST_LIST {
        simulation.step()?;
    }
    Ok(simulation.steps() - first)
}
