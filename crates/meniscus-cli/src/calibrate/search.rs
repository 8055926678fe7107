//! The strength at which films show what is asked for.

use meniscus::measure::Estimate;
use rayon::prelude::*;

use super::film::{Film, Foot, Strength};
use crate::failure::Failure;

/// How many films are made.
#[derive(Clone, Copy, Debug)]
struct Films {
    /// Free ones for the first guess.
    first: u64,
    /// Free ones for all that follow.
    free: u64,
    /// On a wall, to come near by.
    nearer: u64,
    /// On a wall, to be sure.
    on_wall: u64,
}

/// One in space has as many surface particles as some in the plane, and costs as much.
const PLANE: Films = Films {
    first: 2,
    free: 10,
    nearer: 5,
    on_wall: 20,
};
const SPACE: Films = Films {
    first: 1,
    free: 5,
    nearer: 2,
    on_wall: 6,
};

/// Those of a van der Waals liquid, whose kernels hold many particles, differ by less.
const SMOOTH_PLANE: Films = Films { free: 5, ..PLANE };

fn films_of(film: &Film) -> Films {
    match (film.dimension, film.pairwise()) {
        (2, Some(_)) => PLANE,
        (2, None) => SMOOTH_PLANE,
        _ => SPACE,
    }
}

/// A strength is right when films show surface tension to within this share, and the cosine of the contact angle to
/// within twice as much: they differ by more than that.
const NEAR: f64 = 0.03;
/// How often it is corrected.
const ROUNDS: usize = 8;
/// The power of the strength of adhesion that 1 + cos(theta) grows with, about.
const POWER: f64 = 2.0;

/// What was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found {
    /// What films of the strength of sharp surfaces show: surface tension, N/m, or the contact angle, rad.
    pub by_estimate: f64,
    /// The factor on that strength, with its uncertainty by what films differ.
    pub factor: Estimate,
    /// Half of the interval of what films show at that factor, N/m or rad.
    pub half_width: f64,
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// The tensions of some films, N/m, less those that have left their wall.
fn tensions(film: &Film, strength: Strength, films: u64) -> Result<Vec<f64>, Failure> {
    (1..=films)
        .into_par_iter()
        .filter_map(|seed| film.tension(strength, seed).transpose())
        .collect()
}

/// Finds the factor on the cohesion of a film with two free surfaces.
///
/// The tension grows all but in proportion to the strength, so each guess is the last one times what it
/// fell short by; the last films have very nearly the strength that they give.
///
/// # Errors
/// If films blow up, do not pull, or do not come near the tension asked for.
pub fn cohesion(film: &Film) -> Result<Found, Failure> {
    let name = &film.fluid.name;
    let (some, asked) = (films_of(film), film.fluid.surface_tension);
    let (mut factor, mut by_estimate) = (1.0, None);
    for round in 0..ROUNDS {
        let strength = Strength {
            cohesion: factor,
            adhesion: 1.0,
        };
        let films = if round == 0 { some.first } else { some.free };
        let shown = tensions(film, strength, films)?;
        let shown: Vec<f64> = shown.iter().map(|tension| 0.5 * tension / asked).collect();
        let ratio = mean(&shown);
        if !(0.02..50.0).contains(&ratio) {
            return Err(Failure::new(format!(
                "films of {name} show {ratio:.3} times the surface tension asked for: no strength of these forces makes that right"
            )));
        }
        let by_estimate = *by_estimate.get_or_insert(ratio * asked);
        factor /= ratio;
        let Some(estimate) = Estimate::of_independent(&shown) else {
            continue;
        };
        if (ratio - 1.0).abs() < NEAR {
            let share = estimate.half_width / ratio;
            return Ok(Found {
                by_estimate,
                factor: Estimate {
                    value: factor,
                    half_width: factor * share,
                },
                half_width: share * asked,
            });
        }
    }
    Err(Failure::new(format!(
        "films of {name} do not settle on a strength of forces: their particles set in another order each time"
    )))
}

/// Finds the factor on the adhesion of the wall that a film of this cohesion stands on.
///
/// 1 + cos(theta), the work of adhesion over sigma, grows by more than the strength, about with its square: a stronger wall
/// also draws the liquid nearer. Each guess counts on that; the last films have very nearly the strength that they give.
///
/// Where films leave their wall, or do not come near the angle asked for, the factor stays one, of no certainty.
///
/// # Errors
/// If films blow up.
pub fn adhesion(film: &Film, foot: Foot, cohesion: f64) -> Result<Found, Failure> {
    let sigma = film.fluid.surface_tension;
    let (some, asked) = (films_of(film), foot.contact_angle.cos());
    let (mut factor, mut films) = (1.0, some.nearer);
    let mut by_estimate = None;
    for _ in 0..ROUNDS {
        let strength = Strength {
            cohesion,
            adhesion: factor,
        };
        let shown = tensions(film, strength, films)?;
        let cosines: Vec<f64> = shown.iter().map(|tension| 1.0 - tension / sigma).collect();
        let stay = cosines.len() as u64 * 2 > films;
        let cosine = if stay { mean(&cosines) } else { -1.0 };
        let by_estimate = *by_estimate.get_or_insert(angle(cosine));
        // A film that leaves its wall says only that this was too weak.
        let short = (1.0 + asked) / (1.0 + cosine).max(0.01);
        let next = factor * short.powf(1.0 / POWER).clamp(0.5, 1.5);
        if stay && (cosine - asked).abs() < 2.0 * NEAR {
            let estimate = Estimate::of_independent(&cosines);
            if let Some(estimate) = estimate.filter(|_| films == some.on_wall) {
                let half = estimate.half_width;
                return Ok(Found {
                    by_estimate,
                    factor: Estimate {
                        value: next,
                        half_width: half * next / (POWER * (1.0 + asked)),
                    },
                    half_width: 0.5 * (angle(asked - half) - angle(asked + half)),
                });
            }
            films = some.on_wall;
        }
        factor = next;
    }
    // No strength is better than another: most films leave the wall, or it draws them flat.
    Ok(Found {
        by_estimate: by_estimate.unwrap_or(f64::NAN),
        factor: Estimate {
            value: 1.0,
            half_width: f64::INFINITY,
        },
        half_width: f64::INFINITY,
    })
}

/// The angle of a cosine that noise may have put out of bounds, rad.
fn angle(cosine: f64) -> f64 {
    cosine.clamp(-1.0, 1.0).acos()
}
