//! The whole state of a simulation as plain data, from which it goes on bit
//! by bit as if it had never stopped.

use serde::{Deserialize, Serialize};

use crate::physics::surface_tension::SurfaceTension;
use crate::rates::{Dimension, Space};
use crate::setup::{Setup, SetupError};
use crate::simulation::Simulation;
use crate::time::work::Work;
use crate::vector::Vector;

/// State of a simulation. Vectors are stored component by component.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Snapshot {
    /// Dimension, 2 or 3.
    pub dimension: u8,
    /// Time, s.
    pub time: f64,
    /// Steps so far.
    pub steps: u64,
    /// Length of the next step, s.
    pub next_step: f64,
    /// Work done on the liquid so far.
    pub work: Work,
    /// Positions, m.
    pub position: Vec<f64>,
    /// Positions when the neighbour lists were built, m: the order of summation depends on them.
    pub reference: Vec<f64>,
    /// How far these lists reach beyond the kernel's support, m.
    pub skin: f64,
    /// Smoothing lengths, m; none where they are all the same.
    pub smoothing_length: Vec<f64>,
    /// Smoothing lengths when the neighbour lists were built, m.
    pub reference_smoothing_length: Vec<f64>,
    /// Velocities, m/s.
    pub velocity: Vec<f64>,
    /// Accelerations, m/s^2.
    pub acceleration: Vec<f64>,
    /// Densities, kg/m^3.
    pub density: Vec<f64>,
    /// Curvature that the balanced model of surface tension carries, 1/m; otherwise empty.
    pub curvature: Vec<f64>,
    /// Temperatures of a van der Waals fluid, K; otherwise empty.
    pub temperature: Vec<f64>,
    /// Their rates, K/s.
    pub heating: Vec<f64>,
    /// Their rates by acceleration, K/s^2.
    pub heating_gain: Vec<f64>,
    /// Number of the particle in each row.
    pub id: Vec<u32>,
}

impl Snapshot {
    pub(crate) fn of<const D: usize>(simulation: &Simulation<D>) -> Self {
        let particles = &simulation.particles;
        Self {
            dimension: D as u8,
            time: simulation.time,
            steps: simulation.steps,
            next_step: simulation.next_step,
            work: simulation.work,
            position: flatten(&particles.position),
            reference: flatten(simulation.rates.pairs.reference()),
            skin: simulation.rates.pairs.skin(),
            smoothing_length: if simulation.rates.pairs.smoothing_varies() {
                particles.smoothing_length.clone()
            } else {
                Vec::new()
            },
            reference_smoothing_length: (simulation.rates.pairs.reference_smoothing_length())
                .to_vec(),
            velocity: flatten(&particles.velocity),
            acceleration: flatten(&particles.acceleration),
            density: particles.density.clone(),
            curvature: particles.curvature.clone(),
            temperature: particles.temperature.clone(),
            heating: particles.heating.clone(),
            heating_gain: particles.heating_gain.clone(),
            id: particles.id.clone(),
        }
    }
}

impl<const D: usize> Simulation<D> {
    /// Goes on from `snapshot`, which a simulation of the same `setup` made.
    ///
    /// # Errors
    /// If the snapshot does not fit the setup.
    pub fn restore(setup: Setup<D>, snapshot: &Snapshot) -> Result<Self, SetupError>
    where
        Space: Dimension<D>,
    {
        let mut simulation = Self::assemble(setup)?;
        let particles = &mut simulation.particles;
        let rows = particles.len();
        let mut seen = vec![false; rows];
        let is_permutation = snapshot.id.len() == rows
            && snapshot.id.iter().all(|&id| {
                (seen.get_mut(id as usize)).is_some_and(|seen| !std::mem::replace(seen, true))
            });
        let heat = [
            &snapshot.temperature,
            &snapshot.heating,
            &snapshot.heating_gain,
        ];
        let vectors = [
            &snapshot.position,
            &snapshot.reference,
            &snapshot.velocity,
            &snapshot.acceleration,
        ];
        let varying = if simulation.rates.pairs.smoothing_varies() {
            rows
        } else {
            0
        };
        let lengths = [
            &snapshot.smoothing_length,
            &snapshot.reference_smoothing_length,
        ];
        let carries = matches!(
            simulation.rates.scheme.surface_tension,
            Some(SurfaceTension::Balanced(_))
        );
        if snapshot.dimension as usize != D
            || snapshot.curvature.len() != if carries { rows } else { 0 }
            || !is_permutation
            || lengths.iter().any(|column| column.len() != varying)
            || snapshot.density.len() != rows
            || heat
                .iter()
                .any(|column| column.len() != particles.temperature.len())
            || vectors.iter().any(|column| column.len() != rows * D)
        {
            return Err(SetupError(format!(
                "the saved state is of {} particles in {} dimensions, the case of {rows} in {D}",
                snapshot.id.len(),
                snapshot.dimension
            )));
        }
        particles.permute(&snapshot.id, &mut Default::default());
        particles.position = unflatten(&snapshot.reference);
        particles.velocity = unflatten(&snapshot.velocity);
        particles.acceleration = unflatten(&snapshot.acceleration);
        particles.density.copy_from_slice(&snapshot.density);
        particles.curvature.clone_from(&snapshot.curvature);
        particles.temperature.copy_from_slice(&snapshot.temperature);
        particles.heating.copy_from_slice(&snapshot.heating);
        (particles.heating_gain).copy_from_slice(&snapshot.heating_gain);
        if varying > 0 {
            (particles.smoothing_length).copy_from_slice(&snapshot.reference_smoothing_length);
        }
        simulation.rates.pairs.set_skin(snapshot.skin);
        if !simulation.rates.pairs.restore(particles) {
            return Err(SetupError(
                "the saved state is not in the order that this version sorts in".into(),
            ));
        }
        let particles = &mut simulation.particles;
        particles.position = unflatten(&snapshot.position);
        if varying > 0 {
            particles
                .smoothing_length
                .copy_from_slice(&snapshot.smoothing_length);
        }
        if simulation.rates.scheme.van_der_waals.is_some() {
            // Of the same places, so the same density as saved, and what else follows from places.
            (simulation.table.advance_density)(
                &mut simulation.rates,
                &mut simulation.particles,
                snapshot.time,
                0.0,
            );
        } else {
            simulation.rates.update_pressure(&mut simulation.particles);
        }
        simulation.time = snapshot.time;
        simulation.rates.walls.resume(snapshot.time);
        simulation.steps = snapshot.steps;
        simulation.work = snapshot.work;
        simulation.choose_step();
        simulation.next_step = snapshot.next_step;
        Ok(simulation)
    }
}

fn flatten<const D: usize>(vectors: &[Vector<f64, D>]) -> Vec<f64> {
    vectors.iter().flat_map(|v| v.0).collect()
}

fn unflatten<const D: usize>(components: &[f64]) -> Vec<Vector<f64, D>> {
    let (vectors, _) = components.as_chunks::<D>();
    vectors.iter().map(|&v| Vector(v)).collect()
}
