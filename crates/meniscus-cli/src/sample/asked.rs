//! Columns that a case asks for under `[measure]`, each followed through the run.

use meniscus::measure::{Crown, Outline, Sensor, centre_of_mass};
use meniscus::{Particles, Vector, theory};
use meniscus_case::Case;
use meniscus_output::Column;

/// Columns of `roundness`, of the first body.
pub const ROUNDNESS: [(&str, &str); 6] = [
    ("circularity", "m"),
    ("outline radius", "m"),
    ("enclosing radius", "m"),
    ("equivalent radius", "m"),
    ("centre pressure", "Pa"),
    ("centre density", "kg/m^3"),
];

/// Columns of `crown`.
pub const CROWN: [(&str, &str); 3] = [
    ("crown base radius", "m"),
    ("crown rim radius", "m"),
    ("crown rim height", "m"),
];

/// Names and units of the columns.
pub fn columns(case: &Case) -> Vec<Column> {
    let mut columns = Vec::new();
    let mut add = |asked: bool, names: &[(&str, &str)]| {
        if asked {
            columns.extend(names.iter().map(|(name, unit)| Column::new(name, unit)));
        }
    };
    add(case.measure.roundness.is_some(), &ROUNDNESS);
    add(case.measure.crown.is_some(), &CROWN);
    columns
}

/// Their values for the liquid, NaN where one does not exist.
pub fn row<const D: usize>(case: &Case, liquid: &Particles<D>) -> Vec<f64> {
    let mut row = Vec::new();
    if case.measure.roundness.is_some() {
        row.extend(roundness(case, &liquid.of_bodies(|body| body == 0)));
    }
    if let Some(asked) = &case.measure.crown {
        let impact = Vector::from_3d(asked.impact);
        let found = Crown::measure(&liquid.position, impact, case.scheme.smoothing_length);
        row.extend(found.map_or([f64::NAN; CROWN.len()], |crown| {
            [crown.base_radius, crown.rim_radius, crown.rim_height]
        }));
    }
    row
}

fn roundness<const D: usize>(case: &Case, body: &Particles<D>) -> [f64; ROUNDNESS.len()] {
    let outline = Outline::measure(&body.position, &body.mass, case.spacing);
    let volume: f64 = (0..body.len()).map(|i| body.volume(i)).sum();
    let centre = centre_of_mass(&body.position, &body.mass).map(|position| Sensor {
        position,
        kernel: case.scheme.kernel,
        smoothing_length: case.scheme.smoothing_length,
    });
    let at_centre = |field: &[f64]| {
        let reading =
            centre.and_then(|sensor| sensor.read(&body.position, &body.mass, &body.density, field));
        reading.map_or(f64::NAN, |reading| reading.value)
    };
    let of_outline = |of: fn(Outline) -> f64| outline.map_or(f64::NAN, of);
    [
        of_outline(|outline| outline.deviation),
        of_outline(|outline| outline.mean_radius),
        of_outline(|outline| outline.enclosing_radius),
        theory::equivalent_radius(volume, D),
        at_centre(&body.pressure),
        at_centre(&body.density),
    ]
}
