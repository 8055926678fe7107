//! What linear theory says of the oscillation that a case asks for.

use meniscus::theory::{self, ViscousOscillation};
use meniscus_case::Case;

use crate::numbers::effective_viscosity;

/// The first body's oscillation in theory.
pub struct Expected {
    /// Radius of the circle or sphere of the same volume, m.
    pub radius: f64,
    /// Period without viscosity, s: Rayleigh.
    pub period: f64,
    /// Frequency and damping with the laminar viscosity, the one that the
    /// artificial viscosity stands for, and the drag; none where it creeps back.
    pub viscous: Option<ViscousOscillation>,
}

/// None without an oscillation to measure, or without surface tension.
pub fn oscillation(case: &Case) -> Option<Expected> {
    let asked = case.measure.oscillation.as_ref()?;
    let body = case.bodies.first()?;
    let fluid = &case.fluids[body.fluid];
    let (sigma, rho, dimension) = (fluid.surface_tension, fluid.density, case.dimension);
    if sigma <= 0.0 || case.scheme.surface_tension.is_none() {
        return None;
    }
    let radius = theory::equivalent_radius(body.volume, dimension);
    let omega = theory::angular_frequency(asked.mode, sigma, rho, radius, dimension);
    let viscosity = effective_viscosity(case, body.fluid);
    let viscous = theory::viscous_oscillation(asked.mode, sigma, rho, viscosity, radius, dimension);
    // A drag d v damps an oscillator at half its rate.
    let viscous = viscous.map(|found| ViscousOscillation {
        damping_rate: found.damping_rate + 0.5 * case.scheme.damping,
        ..found
    });
    Some(Expected {
        radius,
        period: std::f64::consts::TAU / omega,
        viscous,
    })
}
