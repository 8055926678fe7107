//! Pairwise forces of the suite, as strong as flat films say.

use std::collections::BTreeSet;
use std::path::PathBuf;

use meniscus_case::{Case, Coefficients};

use super::trial::Trial;
use crate::calibrate;
use crate::failure::Failure;
use crate::terminal::{Voice, complain};

/// What was measured for the suite.
pub struct Calibrations {
    file: PathBuf,
    voice: Voice,
    /// Models that cannot be calibrated, by name and dimension: they run with the strength of a sharp surface.
    given_up: BTreeSet<(&'static str, usize)>,
}

impl Calibrations {
    /// Of the suite whose calibrations stand in this file.
    pub fn new(file: PathBuf, voice: Voice) -> Self {
        Self {
            file,
            voice,
            given_up: BTreeSet::new(),
        }
    }

    /// The case of a trial, calibrated where that can be done.
    ///
    /// # Errors
    /// If the model does not take it.
    pub fn case(&mut self, trial: &Trial) -> Result<Case, Failure> {
        let plain = trial.case(&Coefficients::default())?;
        let of = (trial.model.name, trial.dimension);
        if plain.given.is_complete() || self.given_up.contains(&of) {
            return Ok(plain);
        }
        let tell = |line: &str| {
            if !self.voice.quiet {
                complain(&format!("{} in {}D: {line}", of.0, of.1));
            }
        };
        match calibrate::coefficients(&plain, &self.file, &tell) {
            Ok(measured) => trial.case(&measured),
            Err(failure) => {
                tell(failure.message());
                self.given_up.insert(of);
                Ok(plain)
            }
        }
    }
}
