//! Surface tension in balance with the pressure gradient.

#[path = "../common/mod.rs"]
mod common;

mod drops;
mod momentum;
mod ripples;
mod wetting;

use common::{fluid, strewn};
use meniscus::physics::surface_tension::balanced::Balanced;
use meniscus::scheme::{DensityForm, PressureForm, SurfaceTension};
use meniscus::{Domain, Setup, Vector};

/// A ball of unit density and tension, `radius` spacings of one, cut from a square lattice and
/// jittered by a part of a spacing; of this viscosity.
fn ball<const D: usize>(
    centre: Vector<f64, D>,
    radius: f64,
    jitter: f64,
    viscosity: f64,
) -> Setup<D> {
    let mut particles = strewn(radius, jitter, |x| x.norm() < radius);
    for particle in &mut particles {
        particle.position += centre;
    }
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
