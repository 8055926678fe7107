//! Columns of a first body that merges, breaks or mixes.

use meniscus::measure::{Bag, contacts, fragments, waist};
use meniscus::{Particles, Vector};
use meniscus_case::Case;
use meniscus_output::Column;

/// Particles nearer than this many spacings are of one piece.
const LINK: f64 = 1.6;

/// Thickness of a cut, in spacings: two layers, so that it never falls between them.
const CUT: f64 = 2.0;

const WAIST: (&str, &str) = ("waist", "m");
/// Of the largest piece, but for their number.
const BREAKUP: [(&str, &str); 6] = [
    ("pieces", ""),
    ("largest piece", ""),
    ("span", "m"),
    ("opening", ""),
    ("centre thickness", "m"),
    ("rim thickness", "m"),
];
const MIXING: (&str, &str) = ("contacts", "");

/// Names and units of the columns.
pub fn columns(case: &Case) -> Vec<Column> {
    let asked = &case.measure;
    let mut names = Vec::new();
    names.extend(asked.waist.is_some().then_some(WAIST));
    if asked.breakup.is_some() {
        names.extend(BREAKUP);
    }
    names.extend(asked.mixing.then_some(MIXING));
    (names.iter().map(|(name, unit)| Column::new(name, unit))).collect()
}

/// Their values, NaN where one does not exist.
pub fn row<const D: usize>(case: &Case, liquid: &Particles<D>) -> Vec<f64> {
    let asked = &case.measure;
    let mut row = Vec::new();
    if asked.waist.is_none() && asked.breakup.is_none() && !asked.mixing {
        return row;
    }
    let body = liquid.of_bodies(|body| body == 0);
    if let Some(plane) = &asked.waist {
        let (at, normal) = (Vector::from_3d(plane.at), Vector::from_3d(plane.normal));
        let found = waist(&body.position, at, normal, CUT * case.spacing);
        row.push(found.unwrap_or(0.0));
    }
    if let Some(direction) = asked.breakup {
        row.extend(breakup(case, &body, Vector::from_3d(direction)));
    }
    if asked.mixing {
        let others = liquid.of_bodies(|other| other != 0);
        let reach = LINK * case.spacing;
        row.push(contacts(&body.position, &others.position, reach) as f64);
    }
    row
}

fn breakup<const D: usize>(
    case: &Case,
    body: &Particles<D>,
    direction: Vector<f64, D>,
) -> [f64; BREAKUP.len()] {
    let pieces = fragments(&body.position, LINK * case.spacing);
    let count = pieces.iter().max().map_or(0, |last| last + 1);
    let largest: Vec<Vector<f64, D>> = (body.position.iter().zip(&pieces))
        .filter(|(_, piece)| **piece == 0)
        .map(|(x, _)| *x)
        .collect();
    let share = largest.len() as f64 / body.len().max(1) as f64;
    let volume = case.bodies.first().map_or(0.0, |body| body.volume) / body.len().max(1) as f64;
    let bag = Bag::measure(&largest, volume, direction);
    let of = |quantity: fn(&Bag) -> f64| bag.as_ref().map_or(f64::NAN, quantity);
    [
        count as f64,
        share,
        of(|bag| bag.span),
        of(|bag| bag.opening),
        of(|bag| bag.centre_thickness),
        of(|bag| bag.rim_thickness),
    ]
}
