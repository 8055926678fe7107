//! Memory that a running flow takes, as the system sees it: state, lists,
//! scratch, and what the allocator wastes. It is told only of the first flow
//! of the process: a later one may reuse what was given back.

use meniscus::rates::{Dimension, Space};
use serde::Serialize;

use crate::BenchError;
use crate::clock::Crew;
use crate::machine::resident;
use crate::state::{Flow, State};
use crate::variant::{Variant, VariantName};

/// New lists that grow buffers to their lasting size.
const LISTS: u64 = 3;
const MOST_STEPS: u64 = 30;

/// Bytes per particle.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Memory {
    /// 2 or 3.
    pub dimension: usize,
    /// What was solved.
    pub flow: Flow,
    /// Way of the engine.
    pub variant: VariantName,
    /// How many particles.
    pub particles: usize,
    /// Held while the flow runs.
    pub held: f64,
    /// At most, since the flow was set up.
    pub peak: f64,
    /// Of that held: neighbour lists and what sweeps pack.
    pub lists: f64,
}

/// Measures the full surface force on `count` particles of a lattice; nothing
/// where the system does not tell.
///
/// # Errors
/// If the flow blows up.
pub fn measure<const D: usize>(
    count: usize,
    variant: Variant,
    crew: &Crew,
) -> Result<Option<Memory>, BenchError>
where
    Space: Dimension<D>,
{
    let state = State::<D>::lattice(count);
    let Some((before, _)) = resident() else {
        return Ok(None);
    };
    let flow = Flow::Csf;
    let simulation = crew.work(|| -> Result<_, BenchError> {
        let mut simulation = state.simulation(flow, variant)?;
        while simulation.pairs().builds() < LISTS && simulation.steps() < MOST_STEPS {
            simulation.step()?;
        }
        Ok(simulation)
    })?;
    let particles = simulation.particles().len();
    let per_particle = |bytes: f64| bytes / particles as f64;
    Ok(resident().map(|(held, peak)| Memory {
        dimension: D,
        flow,
        variant: variant.name(),
        particles,
        held: per_particle(held - before),
        peak: per_particle(peak - before),
        lists: per_particle(simulation.pairs().bytes() as f64),
    }))
}
