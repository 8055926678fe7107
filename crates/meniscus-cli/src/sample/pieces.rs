//! Columns of liquid that merges, breaks, spreads or mixes.

use meniscus::measure::{Bag, contacts, fragments, waist, width_across};
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
const SPREAD: (&str, &str) = ("spread", "m");
const DROPS: [(&str, &str); 2] = [("drops", ""), ("liquid in drops", "")];
/// A drop holds at least this share of the liquid.
const DROP: f64 = 0.01;
const MIXING: (&str, &str) = ("contacts", "");

/// Names and units of the columns.
pub fn columns(case: &Case) -> Vec<Column> {
    let asked = &case.measure;
    let mut names = Vec::new();
    names.extend(asked.waist.is_some().then_some(WAIST));
    if asked.breakup.is_some() {
        names.extend(BREAKUP);
    }
    names.extend(asked.spreading.is_some().then_some(SPREAD));
    if asked.drops {
        names.extend(DROPS);
    }
    names.extend(asked.mixing.then_some(MIXING));
    (names.iter().map(|(name, unit)| Column::new(name, unit))).collect()
}

/// Their values, NaN where one does not exist.
pub fn row<const D: usize>(case: &Case, liquid: &Particles<D>) -> Vec<f64> {
    let asked = &case.measure;
    let mut row = Vec::new();
    let of_first = asked.waist.is_some() || asked.breakup.is_some() || asked.spreading.is_some();
    if !(of_first || asked.drops || asked.mixing) {
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
    if let Some(normal) = asked.spreading {
        let pieces = fragments(&body.position, LINK * case.spacing);
        let largest = largest(&body.position, &pieces);
        let found = width_across(&largest, Vector::from_3d(normal), case.spacing);
        row.push(found.unwrap_or(f64::NAN));
    }
    if asked.drops {
        row.extend(drops(case, &liquid.position));
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
    let largest = largest(&body.position, &pieces);
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

/// The particles of the largest piece.
fn largest<const D: usize>(position: &[Vector<f64, D>], pieces: &[usize]) -> Vec<Vector<f64, D>> {
    (position.iter().zip(pieces))
        .filter(|(_, piece)| **piece == 0)
        .map(|(x, _)| *x)
        .collect()
}

/// How many drops the liquid is in, and the share of it that they hold. Where it is periodic, a drop on
/// the seam is one.
fn drops<const D: usize>(case: &Case, position: &[Vector<f64, D>]) -> [f64; DROPS.len()] {
    let reach = LINK * case.spacing;
    let mut all = position.to_vec();
    let mut image_of: Vec<usize> = (0..position.len()).collect();
    for (d, box_) in case.periodic.iter().enumerate().take(D) {
        let Some((low, high)) = box_ else { continue };
        for k in 0..all.len() {
            if all[k][d] < low + reach {
                let mut image = all[k];
                image[d] += high - low;
                all.push(image);
                image_of.push(image_of[k]);
            }
        }
    }
    let pieces = fragments(&all, reach);
    let count = pieces.iter().max().map_or(0, |last| last + 1);
    // What an image is part of, its particle is part of.
    let mut whole: Vec<usize> = (0..count).collect();
    let root = |whole: &[usize], mut piece: usize| {
        while whole[piece] != piece {
            piece = whole[piece];
        }
        piece
    };
    for (piece, &of) in pieces.iter().zip(&image_of) {
        let (a, b) = (root(&whole, *piece), root(&whole, pieces[of]));
        whole[a.max(b)] = a.min(b);
    }
    let mut sizes = vec![0_usize; count];
    for &piece in &pieces[..position.len()] {
        sizes[root(&whole, piece)] += 1;
    }
    let least = DROP * position.len() as f64;
    let drops = || sizes.iter().filter(|size| **size as f64 >= least);
    let held = drops().sum::<usize>() as f64 / position.len().max(1) as f64;
    [drops().count() as f64, held]
}

#[cfg(test)]
mod tests {
    use meniscus::Vector;
    use meniscus_case::Case;

    use super::drops;

    #[test]
    fn a_drop_on_the_seam_is_one_and_a_lone_particle_none() {
        let text = "dimension = 2\nspacing = 1\nend_time = 1\n\
            [periodic]\nx = [0, 60]\n[fluid.water]\ndensity = 1000\n\
            [[body]]\nshape = { disc = { radius = 5, centre = [20, 0] } }\n";
        let case = Case::from_str("seam", text).unwrap();
        let square = |left: f64| {
            (0..144).map(move |k| {
                let x = (left + f64::from(k % 12)).rem_euclid(60.0);
                Vector([x, f64::from(k / 12)])
            })
        };
        let lone = [Vector([50.0, 30.0])];
        let positions: Vec<Vector<f64, 2>> = square(20.0).chain(square(54.5)).chain(lone).collect();
        assert_eq!(drops(&case, &positions), [2.0, 288.0 / 289.0]);
    }
}
