//! What the runs came to: one score for each number, and what many scores say together.

use meniscus_case::Case;
use meniscus_output::{RunFolder, Series};
use serde::Serialize;

use super::trial::{Evidence, Trial};
use crate::batch::Done;

/// One number of one run: zero is right.
#[derive(Clone, Debug, Serialize)]
pub struct Score {
    /// Name of the run.
    pub run: String,
    /// Test of the suite.
    pub test: &'static str,
    /// What was measured.
    pub quantity: &'static str,
    /// "%", "deg", or none.
    pub unit: &'static str,
    /// Model of surface tension.
    pub model: &'static str,
    /// 2 or 3.
    pub dimension: usize,
    /// Spacings in the radius.
    pub resolution: u32,
    /// What else sets the run apart.
    pub variant: String,
    /// How the particles lay at first.
    pub start: String,
    /// The number; none where the run, or the measurement, failed.
    pub value: Option<f64>,
    /// What its size should stay below.
    pub bar: Option<f64>,
    /// Why there is no number.
    pub failure: Option<String>,
    /// Particles of the run.
    pub particles: usize,
    /// Steps of the run.
    pub steps: u64,
}

impl Score {
    /// Whether it met its bar, where it has one.
    pub fn met(&self) -> Option<bool> {
        let bar = self.bar?;
        Some(self.value.is_some_and(|value| value.abs() <= bar))
    }
}

/// A run that came to its end.
pub struct Run<'a> {
    /// The case.
    pub case: &'a Case,
    /// What it gave.
    pub done: &'a Done,
    /// Its files.
    pub folder: RunFolder,
}

/// Reads all numbers of a run, or notes why there are none.
pub fn scores(trial: &Trial, run: Result<&Run<'_>, &str>) -> Vec<Score> {
    let series = run
        .ok()
        .and_then(|run| Series::read(&run.folder.series_file()).ok());
    (trial.readings.iter())
        .map(|reading| {
            let evidence = match (run, &series) {
                (Ok(run), Some(series)) => Some(Evidence {
                    case: run.case,
                    findings: &run.done.findings,
                    series,
                    folder: &run.folder,
                }),
                _ => None,
            };
            let value = (evidence.as_ref())
                .and_then(reading.read)
                .filter(|value| value.is_finite());
            let failure = match (run, value) {
                (_, Some(_)) => None,
                (Err(reason), None) => Some(short(reason)),
                (Ok(_), None) => Some("could not be measured".to_owned()),
            };
            Score {
                run: trial.name(),
                test: trial.test,
                quantity: reading.quantity,
                unit: reading.unit,
                model: trial.model.name,
                dimension: trial.dimension,
                resolution: trial.resolution,
                variant: trial.variant.clone(),
                start: trial.start.name(),
                value,
                bar: reading.bar,
                failure,
                particles: run.map_or(0, |run| run.done.record.particles),
                steps: run.map_or(0, |run| run.done.record.steps),
            }
        })
        .collect()
}

/// The first line of a failure.
fn short(reason: &str) -> String {
    reason.lines().next().unwrap_or(reason).to_owned()
}

/// The scores of one cell of a table: all starts of one model at one resolution.
pub struct Cell<'a>(pub Vec<&'a Score>);

impl Cell<'_> {
    /// The value farthest from zero; none if any run failed.
    pub fn worst(&self) -> Option<f64> {
        let values: Option<Vec<f64>> = self.0.iter().map(|score| score.value).collect();
        values?
            .into_iter()
            .max_by(|a, b| a.abs().total_cmp(&b.abs()))
    }

    /// Whether all met the bar.
    pub fn met(&self) -> Option<bool> {
        let met: Option<Vec<bool>> = self.0.iter().map(|score| score.met()).collect();
        met.filter(|met| !met.is_empty())
            .map(|met| met.into_iter().all(|met| met))
    }

    /// How many runs gave no number, of how many.
    pub fn failed(&self) -> (usize, usize) {
        let failed = self.0.iter().filter(|score| score.value.is_none()).count();
        (failed, self.0.len())
    }
}

/// The order p of errors that go as (dx / R)^p, by a straight line through their logarithms.
/// None of fewer than two.
pub fn order(errors: &[(u32, f64)]) -> Option<f64> {
    let points: Vec<(f64, f64)> = (errors.iter())
        .filter(|(_, error)| *error != 0.0)
        .map(|(resolution, error)| (f64::from(*resolution).ln(), error.abs().ln()))
        .collect();
    let count = points.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / count;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let spread: f64 = points.iter().map(|p| (p.0 - x).powi(2)).sum();
    let slope = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum::<f64>() / spread;
    (points.len() > 1 && spread > 0.0).then_some(-slope)
}

#[cfg(test)]
mod tests {
    use super::order;

    #[test]
    fn the_order_of_errors_is_that_of_their_power_law() {
        let errors = [7_u32, 10, 20].map(|n| (n, -3.0 / f64::from(n).powi(2)));
        assert!((order(&errors).unwrap() - 2.0).abs() < 1e-12);
        assert!(order(&errors[..1]).is_none());
        assert!(order(&[(7, 0.0), (10, 1.0)]).is_none());
    }
}
