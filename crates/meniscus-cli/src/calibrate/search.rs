//! The strength at which films show the surface tension asked for.

use meniscus::measure::Estimate;
use rayon::prelude::*;

use super::film::Film;
use crate::failure::Failure;

/// Films of the first guess, and of all that follow.
const FIRST: u64 = 2;
const FILMS: u64 = 10;
/// A factor is right when films show sigma to within this.
const NEAR: f64 = 0.03;
/// How often it is corrected.
const ROUNDS: usize = 4;

/// What was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found {
    /// Surface tension that films of the sharp surface's strength show, N/m.
    pub by_estimate: f64,
    /// The factor on that strength, with its uncertainty by what films differ.
    pub factor: Estimate,
    /// Surface tension shown at the last factor that was tried, N/m, and that factor.
    pub shown: (f64, f64),
}

/// Finds the factor of a film.
///
/// The tension grows all but in proportion to the strength, so each guess is the last one times what it
/// fell short by; the last films have very nearly the strength that they give.
///
/// # Errors
/// If films blow up, do not pull, or do not come near the tension asked for.
pub fn search(film: &Film) -> Result<Found, Failure> {
    let asked = film.fluid.surface_tension;
    let mut factor = 1.0;
    let mut by_estimate = 0.0;
    for round in 0..ROUNDS {
        let films = if round == 0 { FIRST } else { FILMS };
        let shown = (1..=films)
            .into_par_iter()
            .map(|seed| film.surface_tension(factor, seed))
            .collect::<Result<Vec<f64>, Failure>>()?;
        let mean = shown.iter().sum::<f64>() / shown.len() as f64;
        if round == 0 {
            by_estimate = mean;
        }
        if !(mean > 0.02 * asked && mean < 50.0 * asked) {
            return Err(Failure::new(format!(
                "films of {} show {mean:.3e} N/m where {asked:.3e} N/m is asked for: no strength of these forces makes that right",
                film.fluid.name
            )));
        }
        let ratio = mean / asked;
        let estimate = Estimate::of_independent(&shown);
        if let (Some(estimate), true) = (estimate, (ratio - 1.0).abs() < NEAR) {
            let share = estimate.half_width / estimate.value;
            factor /= ratio;
            return Ok(Found {
                by_estimate,
                factor: Estimate {
                    value: factor,
                    half_width: factor * share,
                },
                shown: (mean, factor * ratio),
            });
        }
        factor /= ratio;
    }
    Err(Failure::new(format!(
        "films of {} do not settle on a strength of forces: the particles set in another order each time",
        film.fluid.name
    )))
}
