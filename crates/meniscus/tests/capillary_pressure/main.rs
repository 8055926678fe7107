//! Surface tension as a pressure that is taken off the pressure gradient.

#[path = "../common/mod.rs"]
mod common;

mod drops;
mod edge;
mod momentum;
mod swing;
mod wetting;

use common::{of_unit_tension, strewn};
use meniscus::physics::surface_tension::capillary_pressure::CapillaryPressure;
use meniscus::scheme::{PressureForm, SurfaceTension, ViscosityForm};
use meniscus::{Setup, Vector};

/// Liquid of unit density and tension where `inside` says, out of a square lattice of spacing one within
/// `reach` of the origin, jittered by a part of a spacing.
pub fn liquid<const D: usize>(
    reach: f64,
    jitter: f64,
    viscosity: f64,
    inside: impl Fn(Vector<f64, D>) -> bool,
) -> Setup<D> {
    let model = SurfaceTension::CapillaryPressure(CapillaryPressure);
    let mut setup = of_unit_tension(strewn(reach, jitter, inside), reach, viscosity, model);
    setup.scheme.pressure = PressureForm::OverDensityProduct;
    setup.scheme.viscosity = ViscosityForm::StressAndRest;
    setup
}
