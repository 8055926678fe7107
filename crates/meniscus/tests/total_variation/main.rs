//! Surface tension as the derivative of an energy on a mesh.

#[path = "../common/mod.rs"]
mod common;

mod drops;
mod symmetry;
mod wetting;

use common::{of_unit_tension, strewn};
use meniscus::physics::surface_tension::total_variation::TotalVariation;
use meniscus::scheme::SurfaceTension;
use meniscus::{Setup, Vector};

/// Liquid of unit density and tension where `inside` says, out of a square lattice of spacing one within
/// `reach` of the origin, jittered by a part of a spacing.
pub fn liquid<const D: usize>(
    reach: f64,
    jitter: f64,
    viscosity: f64,
    inside: impl Fn(Vector<f64, D>) -> bool,
) -> Setup<D> {
    let model = SurfaceTension::TotalVariation(TotalVariation);
    of_unit_tension(strewn(reach, jitter, inside), reach, viscosity, model)
}
