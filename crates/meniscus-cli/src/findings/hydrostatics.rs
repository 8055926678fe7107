//! How pressure grows with depth.

use meniscus_case::Case;
use meniscus_output::Series;

use super::{Findings, mean};
use crate::sample::hydrostatics::{PROFILE, TOTAL};

/// Means over the time that is asked for, beside the weight of the liquid.
pub fn measure(case: &Case, series: &Series, findings: &mut Findings) {
    let (Some(asked), Some(body)) = (&case.measure.hydrostatics, case.bodies.first()) else {
        return;
    };
    let force = case.scheme.body_force.as_ref();
    let upward = force.map_or(0.0, |force| force.at(asked.window.to)[case.dimension - 1]);
    let weight = Some(("rho g", -upward * case.fluids[body.fluid].density));
    let numbers = [
        (
            "hydrostatic-error",
            "largest error of pressure, of rho g H",
            Some(("exact", 0.0)),
        ),
        ("pressure-gradient", "growth of pressure with depth", weight),
        (
            "total-pressure-gradient",
            "the same with the virial pressure",
            weight,
        ),
        (
            "total-pressure-at-surface",
            "pressure and virial pressure, at the surface",
            Some(("exact", 0.0)),
        ),
    ];
    for ((column, unit), (id, name, exact)) in PROFILE.iter().chain(&TOTAL).zip(numbers) {
        if let Some(found) = mean(series, column, &asked.window) {
            findings.add(id, name, unit, exact, found);
        }
    }
}
