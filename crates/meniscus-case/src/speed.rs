//! The largest speed that a case is expected to show, and the sound speed for it.

use meniscus::scheme::{BodyForce, Fluid};
use meniscus::{Particle, Vector};

/// Speeds that a case shows before it is run, m/s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpeedScales {
    /// Largest speed of a particle at the start, or of one against another; or of a wall.
    pub initial: f64,
    /// sqrt(2 sigma / (rho R)) of the body where it is largest, R the radius
    /// of the disc or ball of the same volume: the pressure of surface tension
    /// sigma (D - 1) / R as a speed, or the Taylor-Culick speed of a sheet 2 R thick.
    pub capillary: f64,
    /// sqrt(g H), with the largest acceleration g of the body force, and the
    /// extent H of all bodies along it: hydrostatic pressure as a speed.
    pub gravity: f64,
    /// sqrt(p / rho), p what is left of the cohesion pressure of pairwise forces above the
    /// background pressure.
    pub cohesion: f64,
}

impl SpeedScales {
    /// The largest of them, m/s.
    pub fn largest(&self) -> f64 {
        let by_forces = self.capillary.max(self.gravity).max(self.cohesion);
        self.initial.max(by_forces)
    }

    /// From what there is at the start. `bodies` holds the fluid and the
    /// volume, m^3 (m^2 in 2D), of each.
    pub(crate) fn new(
        dimension: usize,
        particles: &[Particle<3>],
        fluids: &[Fluid],
        bodies: &[(usize, f64)],
        body_force: Option<&BodyForce>,
    ) -> Self {
        let fastest = particles
            .iter()
            .map(|p| p.velocity.norm())
            .fold(0.0, f64::max);
        let range: [f64; 3] = std::array::from_fn(|d| {
            let along = particles.iter().map(|p| p.velocity[d]);
            along.clone().fold(f64::NEG_INFINITY, f64::max) - along.fold(f64::INFINITY, f64::min)
        });
        let initial = fastest.max(Vector(range).norm());
        let capillary = bodies
            .iter()
            .filter_map(|&(fluid, volume)| {
                let fluid = fluids.get(fluid)?;
                let radius = meniscus::theory::equivalent_radius(volume, dimension);
                Some((2.0 * fluid.surface_tension / (fluid.density * radius)).sqrt())
            })
            .fold(0.0, f64::max);
        let gravity = body_force.map_or(0.0, |force| {
            let extents: [f64; 3] = std::array::from_fn(|d| {
                let along = particles.iter().map(|p| p.position[d]);
                along.clone().fold(f64::NEG_INFINITY, f64::max)
                    - along.fold(f64::INFINITY, f64::min)
            });
            let reach = |g: [f64; 3]| {
                (0..dimension)
                    .map(|d| (g[d] * extents[d]).abs())
                    .sum::<f64>()
            };
            match force {
                BodyForce::Constant(g) => reach(*g),
                BodyForce::Oscillating {
                    mean, amplitude, ..
                } => reach(*mean) + reach(*amplitude),
                BodyForce::Table(rows) => rows.iter().map(|(_, g)| reach(*g)).fold(0.0, f64::max),
            }
            .sqrt()
        });
        Self {
            initial,
            capillary,
            gravity,
            cohesion: 0.0,
        }
    }
}

/// Ten times the largest speed, m/s, so that density changes by about one per
/// cent (Monaghan 1994, J. Comput. Phys. 110, 399). One metre per second where
/// nothing moves and no force acts.
pub fn default_sound_speed(scales: &SpeedScales) -> f64 {
    let largest = scales.largest();
    if largest > 0.0 { 10.0 * largest } else { 1.0 }
}
