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

/// Each test in a sentence.
pub const ABOUT: [(&str, &str); 13] = [
    (
        "laplace",
        "A disc or ball that a drag brings to rest; its pressure beside sigma (D - 1) / R.",
    ),
    (
        "parasitic currents",
        "A disc or ball left alone for twenty capillary times sqrt(rho D^3 / sigma): the largest \
         U sqrt(rho D / sigma), in the mean over the last quarter.",
    ),
    (
        "swing",
        "Four periods of mode 2, drawn out by 5 %, La = 1000, beside the exact viscous root.",
    ),
    (
        "square to round",
        "A square or cube with the volume of the disc or ball, La = 1200, left alone until t = 30.",
    ),
    (
        "cap",
        "Half a disc or ball on a plane of another contact angle, La = 120, without weight. Angle and first \
         radius are those of the circle or sphere fitted to all its surface, the second that of its foot alone.",
    ),
    (
        "cap on a round wall",
        "The same on a ball half as large again as the drop and, but not in the quick suite, in a vessel three \
         quarters larger.",
    ),
    (
        "cap under slight weight",
        "A cap that has come to rest gets a weight of rho g R^2 / sigma = 0.01. Allowed is the change by theory, and \
         95 % of the fluctuations before and after, up to 3 degrees and 2 %.",
    ),
    (
        "puddle",
        "Sixteen capillary lengths wide: height of its middle beside theory.",
    ),
    (
        "rise between plates",
        "Two plates that hang into a pool: rise, or fall, of the liquid between them beside Jurin's.",
    ),
    (
        "two drops merge",
        "Two drops that touch, La = 1200, until t = 10.",
    ),
    (
        "five drops apart",
        "Five drops of different sizes, stretched and on ways of their own: each keeps its momentum.",
    ),
    (
        "thread breaks",
        "A thread with the wave that grows fastest, until t = 25.",
    ),
    (
        "splash",
        "A drop that falls into a pool in a tank, We = 100, until t = 1.5.",
    ),
];

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

    /// The same, with one seed only.
    fn one_seed(self) -> &'static [Start] {
        let all = self.starts();
        &all[..all.len().min(3)]
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

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use meniscus_case::Coefficients;

    use super::*;
    use crate::appraise::model::MODELS;

    #[test]
    fn every_run_of_the_suite_is_a_case_with_a_name_of_its_own() {
        for effort in [Effort::Quick, Effort::Full] {
            let all: Vec<_> = (MODELS.iter())
                .flat_map(|&model| trials(model, effort))
                .collect();
            let names: BTreeSet<_> = all.iter().map(Trial::name).collect();
            assert_eq!(names.len(), all.len());
        }
        for trial in trials(MODELS[0], Effort::Full) {
            assert!(ABOUT.iter().any(|(test, _)| *test == trial.test));
            let case = trial.case(&Coefficients::default());
            let case = case.unwrap_or_else(|refused| panic!("{}", refused.message()));
            assert!(case.warnings.is_empty(), "{}: {}", case.name, case.warnings);
        }
    }

    #[test]
    fn the_full_suite_holds_all_that_the_quick_one_does() {
        let names = |effort| -> BTreeSet<String> {
            trials(MODELS[0], effort).iter().map(Trial::name).collect()
        };
        assert!(names(Effort::Quick).is_subset(&names(Effort::Full)));
    }
}
