//! Columns of `hydrostatics`: pressure against depth.

use meniscus::measure::PressureProfile;
use meniscus::{Simulation, Vector};
use meniscus_case::Case;
use meniscus_output::Column;

/// Of the pressure that the equation of state gives.
pub const PROFILE: [(&str, &str); 2] = [("hydrostatic error", "%"), ("pressure gradient", "Pa/m")];
/// Of its sum with the virial pressure, where forces of pairs make one.
pub const TOTAL: [(&str, &str); 2] = [
    ("total pressure gradient", "Pa/m"),
    ("total pressure at the surface", "Pa"),
];

/// Names and units of the columns.
pub fn columns(case: &Case) -> Vec<Column> {
    let asked = case.measure.hydrostatics.iter();
    asked
        .flat_map(|_| PROFILE.iter().chain(&TOTAL))
        .map(|(name, unit)| Column::new(name, unit))
        .collect()
}

/// Their values; NaN where there is no virial pressure, or no weight.
pub fn row<const D: usize>(case: &Case, simulation: &Simulation<D>) -> Vec<f64> {
    let Some(asked) = &case.measure.hydrostatics else {
        return Vec::new();
    };
    let p = simulation.particles();
    let liquid: Vec<usize> = (0..p.len())
        .filter(|&i| !simulation.is_wall(p.body[i]))
        .collect();
    let positions: Vec<Vector<f64, D>> = liquid.iter().map(|&i| p.position[i]).collect();
    let force = case.scheme.body_force.as_ref();
    let upward = force.map_or(0.0, |force| force.at(simulation.time())[D - 1]);
    let fluid = case.bodies.first().map_or(0, |body| body.fluid);
    let weight = -upward * case.fluids[fluid].density;
    // Where surface and bottom have no part in a particle's sums.
    let reach = case.scheme.kernel.support() * case.scheme.smoothing_length;
    let profile = |pressures: Vec<f64>| {
        let inner = reach..asked.depth - reach;
        PressureProfile::measure(&positions, &pressures, weight, asked.level, inner)
    };
    let of_state = profile(liquid.iter().map(|&i| p.pressure[i]).collect());
    let mut row = vec![
        100.0 * of_state.largest_error / (weight * asked.depth),
        of_state.gradient,
    ];
    let virial = &simulation.surface().virial_pressure;
    if virial.len() == p.len() {
        let total = profile(liquid.iter().map(|&i| p.pressure[i] + virial[i]).collect());
        row.extend([total.gradient, total.at_surface]);
    } else {
        row.extend([f64::NAN; TOTAL.len()]);
    }
    row
}
