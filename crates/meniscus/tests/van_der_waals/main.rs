//! What a van der Waals fluid promises, stated as physics.
//!
//! - `film`: its surface tension, and the density of its liquid
//! - `drop`: energy, momentum, a resumed run
//! - `wave`: conduction, viscosity and sound in a periodic box
//! - `setups`: what it refuses to start from

#[path = "../common/mod.rs"]
mod common;

mod drop;
mod film;
mod setups;
mod wave;

use meniscus::scheme::{Scheme, Substance, TimeStep, VanDerWaals};
use meniscus::{Domain, Fluid, Particle, Setup, Vector};

/// Sigalotti, Daza and Donoso's: critical at density 2/3, temperature 32/27.
pub const SUBSTANCE: Substance = Substance {
    gas_constant: 1.0,
    cohesion: 2.0,
    excluded_volume: 0.5,
    degrees_of_freedom: 2.0,
};

/// Their square of `n` by `n` (by `n`) particles of unit mass, 0.75 apart, T = 0.2, in a void,
/// that surface tension pulls round; steps of 0.005.
pub fn square<const D: usize>(n: usize, jitter: f64) -> Setup<D> {
    let spacing: f64 = 0.75;
    let mut fluid = Fluid::new("fluid", spacing.powi(-(D as i32)));
    fluid.viscosity = 1.0;
    let mut substance = SUBSTANCE;
    // In 3D as many molecules to a volume, as seen from the critical point.
    let crowding = spacing.powi(D as i32 - 2);
    substance.cohesion *= crowding;
    substance.excluded_volume *= crowding;
    let mut model = VanDerWaals::new(substance, 0.2);
    model.conductivity = 5.0;
    model.bulk_viscosity = 0.1;
    let mut scheme = Scheme::van_der_waals(3.0 * spacing, model);
    scheme.time_step = TimeStep::Fixed(0.005);
    let particles = (0..n.pow(D as u32)).map(|k| Particle {
        position: Vector(std::array::from_fn(|d| {
            let cell = (k / n.pow(d as u32) % n) as f64;
            (cell + jitter * common::noise(k as i64 * 7 + d as i64)) * spacing
        })),
        velocity: Vector::ZERO,
        mass: 1.0,
        fluid: 0,
        body: 0,
    });
    Setup {
        scheme,
        fluids: vec![fluid],
        particles: particles.collect(),
        spacing,
        domain: Domain::default(),
    }
}
