//! Columns of `jet`: what has left a nozzle.

use meniscus::measure::{FreeDrop, Jet};
use meniscus::{Particles, Vector};
use meniscus_case::Case;
use meniscus_output::Column;

/// Names of the columns.
pub const COLUMNS: [&str; 7] = [
    "jet speed",
    "jet length",
    "liquid beyond the nozzle",
    "free drops",
    "drop volume",
    "drop speed",
    "drop distance",
];

/// Names and units of the columns.
pub fn columns(case: &Case) -> Vec<Column> {
    if case.measure.jet.is_none() {
        return Vec::new();
    }
    let volume = if case.dimension == 2 { "m^2" } else { "m^3" };
    let units = ["m/s", "m", volume, "", volume, "m/s", "m"];
    (COLUMNS.iter().zip(units))
        .map(|(name, unit)| Column::new(name, unit))
        .collect()
}

/// Their values. Of the drops the foremost, which the jet began with, counts in their number alone.
pub fn row<const D: usize>(case: &Case, liquid: &Particles<D>) -> Vec<f64> {
    let Some(asked) = &case.measure.jet else {
        return Vec::new();
    };
    // At rest: what is compressed is not less.
    let at_rest = |i: usize| liquid.mass[i] / case.fluids[usize::from(liquid.fluid[i])].density;
    let volume: Vec<f64> = (0..liquid.len()).map(at_rest).collect();
    let (at, direction) = (Vector::from_3d(asked.at), Vector::from_3d(asked.direction));
    let (x, v) = (&liquid.position, &liquid.velocity);
    let jet = Jet::measure(x, v, &volume, case.spacing, at, direction);
    let behind = &jet.drops[..jet.drops.len().saturating_sub(1)];
    let mean = |of: fn(&FreeDrop) -> f64| {
        // None is not a number.
        behind.iter().map(of).sum::<f64>() / behind.len() as f64
    };
    let way = match behind {
        [first, .., last] => last.distance - first.distance,
        _ => f64::NAN,
    };
    vec![
        jet.speed,
        jet.length,
        jet.volume,
        jet.drops.len() as f64,
        mean(|drop| drop.volume),
        mean(|drop| drop.speed),
        way / behind.len().saturating_sub(1) as f64,
    ]
}
