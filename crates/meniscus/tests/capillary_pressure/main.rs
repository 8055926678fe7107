//! Surface tension as a pressure that is taken off the pressure gradient.

#[path = "../common/mod.rs"]
mod common;

mod drops;
mod momentum;
mod swing;
mod wetting;

use common::{fluid, strewn};
use meniscus::physics::surface_tension::capillary_pressure::CapillaryPressure;
use meniscus::scheme::{PressureForm, SurfaceTension, ViscosityForm};
use meniscus::{Domain, Setup, Vector};

/// Liquid of unit density and tension where `inside` says, out of a square lattice of spacing one within
/// `reach` of the origin, jittered by a part of a spacing.
pub fn liquid<const D: usize>(
    reach: f64,
    jitter: f64,
    viscosity: f64,
    inside: impl Fn(Vector<f64, D>) -> bool,
) -> Setup<D> {
    let particles = strewn(reach, jitter, inside);
    let mut scheme = common::scheme(1.0);
    scheme.surface_tension = Some(SurfaceTension::CapillaryPressure(CapillaryPressure));
    scheme.pressure = PressureForm::OverDensityProduct;
    scheme.viscosity = ViscosityForm::StressAndRest;
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
