//! Surface tension as the derivative of an energy on a mesh.

#[path = "../common/mod.rs"]
mod common;

mod drops;
mod symmetry;
mod wetting;

use common::{fluid, noise};
use meniscus::physics::surface_tension::total_variation::TotalVariation;
use meniscus::scheme::SurfaceTension;
use meniscus::{Domain, Particle, Setup, Vector};

/// Liquid of unit density and tension where `inside` says, out of a square lattice of spacing one within
/// `reach` of the origin, jittered by a part of a spacing.
pub fn liquid<const D: usize>(
    reach: f64,
    jitter: f64,
    viscosity: f64,
    inside: impl Fn(Vector<f64, D>) -> bool,
) -> Setup<D> {
    let half = reach.ceil() as i64 + 1;
    let side = 2 * half;
    let particles = (0..side.pow(D as u32)).filter_map(|k| {
        let place: Vector<f64, D> = Vector(std::array::from_fn(|d| {
            (k / side.pow(d as u32) % side - half) as f64 + 0.5
        }));
        let shift = Vector(std::array::from_fn(|d| {
            jitter * noise(7 * k + 31 * d as i64 + 1)
        }));
        inside(place).then_some(Particle {
            position: place + shift,
            velocity: Vector::ZERO,
            mass: 1.0,
            fluid: 0,
            body: 0,
        })
    });
    let particles = particles.collect();
    let mut scheme = common::scheme(1.0);
    scheme.surface_tension = Some(SurfaceTension::TotalVariation(TotalVariation));
    let mut liquid = fluid(viscosity, 1.0);
    // Ten times the capillary speed.
    liquid.sound_speed = 10.0 * (2.0 / reach).sqrt();
    Setup {
        scheme,
        fluids: vec![liquid],
        particles,
        spacing: 1.0,
        domain: Domain::default(),
    }
}
