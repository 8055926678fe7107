//! What linear theory says of the oscillation that a case asks for.

use meniscus::scheme::SurfaceTension;
use meniscus::theory::{self, Medium, ViscousOscillation};
use meniscus_case::Case;

use crate::numbers::effective_viscosity;

/// The first body's oscillation in theory.
pub struct Expected {
    /// Radius of the circle or sphere of the same volume, m.
    pub radius: f64,
    /// Period without viscosity, s.
    pub period: f64,
    /// Frequency and damping with the laminar viscosity, the one that the
    /// artificial viscosity stands for, and the drag; none where it creeps back.
    pub viscous: Option<ViscousOscillation>,
    /// Whether it swings in another fluid, and not in a void.
    pub immersed: bool,
}

/// None without an oscillation to measure, or without surface tension.
pub fn oscillation(case: &Case) -> Option<Expected> {
    let asked = case.measure.oscillation.as_ref()?;
    let body = case.bodies.first()?;
    let fluid = &case.fluids[body.fluid];
    let (sigma, rho, dimension) = (fluid.surface_tension, fluid.density, case.dimension);
    let scheme = &case.scheme;
    if sigma <= 0.0 || scheme.surface_tension.is_none() && scheme.van_der_waals.is_none() {
        return None;
    }
    let radius = theory::equivalent_radius(body.volume, dimension);
    let viscosity = effective_viscosity(case, body.fluid);
    let (omega, viscous) = match surroundings(case, body.fluid) {
        Some(outside) => {
            let inside = Medium {
                density: rho,
                viscosity: rho * viscosity,
            };
            let (mode, other) = (asked.mode, outside.density);
            (
                theory::immersed_angular_frequency(mode, sigma, rho, other, radius, dimension),
                (inside.viscosity > 0.0 && outside.viscosity > 0.0)
                    .then(|| {
                        theory::two_fluid_oscillation(
                            mode, sigma, inside, outside, radius, dimension,
                        )
                    })
                    .flatten(),
            )
        }
        None => (
            theory::angular_frequency(asked.mode, sigma, rho, radius, dimension),
            theory::viscous_oscillation(asked.mode, sigma, rho, viscosity, radius, dimension),
        ),
    };
    // A drag d v damps an oscillator at half its rate.
    let viscous = viscous.map(|found| ViscousOscillation {
        damping_rate: found.damping_rate + 0.5 * case.scheme.damping,
        ..found
    });
    Some(Expected {
        radius,
        period: std::f64::consts::TAU / omega,
        viscous,
        immersed: surroundings(case, body.fluid).is_some(),
    })
}

/// The other fluid, where there are two and surface tension is that between them.
fn surroundings(case: &Case, fluid: usize) -> Option<Medium> {
    let (2, Some(SurfaceTension::Continuum(_))) = (case.fluids.len(), &case.scheme.surface_tension)
    else {
        return None;
    };
    let other = 1 - fluid;
    let density = case.fluids[other].density;
    Some(Medium {
        density,
        viscosity: density * effective_viscosity(case, other),
    })
}
