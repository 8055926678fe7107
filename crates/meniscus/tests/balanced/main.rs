//! Surface tension in balance with the pressure gradient.

#[path = "../common/mod.rs"]
mod common;

mod drops;
mod momentum;
mod ripples;
mod wetting;

use common::{of_unit_tension, strewn};
use meniscus::physics::surface_tension::balanced::Balanced;
use meniscus::scheme::{DensityForm, PressureForm, SurfaceTension};
use meniscus::{Setup, Vector};

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
    let model = SurfaceTension::Balanced(Balanced);
    let mut setup = of_unit_tension(particles, radius, viscosity, model);
    setup.scheme.density = DensityForm::Corrected;
    setup.scheme.pressure = PressureForm::OverDensityProduct;
    setup
}
