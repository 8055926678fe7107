//! The tests that every model has to sit.

mod at_rest;
mod cap;
mod cap_on_ball;
mod encounters;
mod gravity;
mod relaxation;
mod slight_weight;
mod swing;

use super::model::Model;
use super::trial::{Start, Trial};

/// How much is run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effort {
    /// The coarser resolutions, a lattice and a jittered start.
    Quick,
    /// All of it.
    Full,
}

/// All runs of a model.
pub fn trials(model: Model, effort: Effort) -> Vec<Trial> {
    [
        at_rest::laplace(model, effort),
        at_rest::parasitic(model, effort),
        swing::trials(model, effort),
        relaxation::trials(model, effort),
        cap::trials(model, effort),
        cap_on_ball::trials(model, effort),
        slight_weight::trials(model, effort),
        gravity::trials(model, effort),
        encounters::trials(model, effort),
    ]
    .into_iter()
    .flatten()
    .collect()
}

impl Effort {
    /// How runs start.
    fn starts(self) -> &'static [Start] {
        match self {
            Effort::Quick => &[Start::Lattice, Start::Jittered(1)],
            Effort::Full => &[
                Start::Lattice,
                Start::Rotated,
                Start::Jittered(1),
                Start::Jittered(2),
                Start::Jittered(3),
            ],
        }
    }

    /// The first `quick` of some resolutions, or all.
    fn of<T>(self, all: &[T], quick: usize) -> &[T] {
        match self {
            Effort::Quick => &all[..quick.min(all.len())],
            Effort::Full => all,
        }
    }
}

/// The shape of a ball of radius one at a place along x.
pub fn ball(dimension: usize, x: f64) -> String {
    match dimension {
        2 => format!("{{ disc = {{ radius = 1, centre = [{x}, 0] }} }}"),
        _ => format!("{{ sphere = {{ radius = 1, centre = [{x}, 0, 0] }} }}"),
    }
}
