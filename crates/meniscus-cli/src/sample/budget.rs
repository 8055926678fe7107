//! What body force and walls do on the liquid, beside its energies.

use meniscus::{Particles, Simulation, Vector};
use meniscus_case::Case;
use meniscus_output::Column;

/// Columns of a case with a body force or walls, J.
pub const BUDGET: [&str; 3] = [
    "potential energy",
    "work of the body force",
    "work of the walls",
];

/// Whether anything acts on the liquid from outside.
fn applies(case: &Case) -> bool {
    case.scheme.body_force.is_some() || !case.walls.is_empty()
}

/// Their names and units.
pub fn columns(case: &Case, unit: &str) -> Vec<Column> {
    let names = BUDGET.iter().filter(|_| applies(case));
    names.map(|name| Column::new(name, unit)).collect()
}

/// Their values.
pub fn row<const D: usize>(
    case: &Case,
    simulation: &Simulation<D>,
    liquid: &Particles<D>,
) -> Vec<f64> {
    if !applies(case) {
        return Vec::new();
    }
    let force = case.scheme.body_force.as_ref();
    let force = Vector::<f64, D>::from_3d(force.map_or([0.0; 3], |f| f.at(simulation.time())));
    let places = liquid.position.iter().zip(&liquid.mass);
    let potential = places.map(|(x, m)| -m * force.dot(x)).sum();
    let work = simulation.work();
    vec![potential, work.body_force, work.walls]
}
