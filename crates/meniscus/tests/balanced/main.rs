//! Surface tension in balance with the pressure gradient.

#[path = "../common/mod.rs"]
mod common;

mod drops;
mod momentum;
mod ripples;
mod wetting;

use common::{fluid, noise};
use meniscus::physics::surface_tension::balanced::Balanced;
use meniscus::scheme::{DensityForm, PressureForm, SurfaceTension};
use meniscus::{Domain, Particle, Setup, Vector};

/// A ball of unit density and tension, `radius` spacings of one, cut from a square lattice and
/// jittered by a part of a spacing; of this viscosity.
fn ball<const D: usize>(
    centre: Vector<f64, D>,
    radius: f64,
    jitter: f64,
    viscosity: f64,
) -> Setup<D> {
    let half = radius.ceil() as i64 + 1;
    let side = 2 * half;
    let particles = (0..side.pow(D as u32)).filter_map(|k| {
        let offset: Vector<f64, D> = Vector(std::array::from_fn(|d| {
            (k / side.pow(d as u32) % side - half) as f64 + 0.5
        }));
        let shift = Vector(std::array::from_fn(|d| {
            jitter * noise(7 * k + 31 * d as i64 + 1)
        }));
        (offset.norm() < radius).then_some(Particle {
            position: centre + offset + shift,
            velocity: Vector::ZERO,
            mass: 1.0,
            fluid: 0,
            body: 0,
        })
    });
    let particles = particles.collect();
    let mut scheme = common::scheme(1.0);
    scheme.density = DensityForm::Corrected;
    scheme.pressure = PressureForm::OverDensityProduct;
    scheme.surface_tension = Some(SurfaceTension::Balanced(Balanced));
    let mut liquid = fluid(viscosity, 1.0);
    // Ten times the capillary speed.
    liquid.sound_speed = 10.0 * (2.0 / radius).sqrt();
    Setup {
        scheme,
        fluids: vec![liquid],
        particles,
        spacing: 1.0,
        domain: Domain::default(),
    }
}
