//! The least-squares problem, in units in which times run from 0 to 1.

use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt, TerminationReason};
use nalgebra::storage::Owned;
use nalgebra::{DVector, Dyn, OMatrix, U5, Vector5};

/// y_0, C, S, b, omega of y = y_0 + exp(-b t) (C cos(omega t) - S sin(omega t)):
/// unlike amplitude and phase, C and S have no singular point.
type Parameters = Vector5<f64>;

/// The minimum, with what its uncertainty follows from.
pub(super) struct Solution {
    pub parameters: Parameters,
    /// Model less measurement.
    pub residuals: DVector<f64>,
    /// Derivatives of the residuals, a row for each sample.
    pub jacobian: OMatrix<f64, Dyn, U5>,
}

/// Minimises from a start; `None` if that fails.
pub(super) fn solve(times: &[f64], values: &[f64], start: Parameters) -> Option<Solution> {
    let problem = Problem {
        times,
        values,
        parameters: start,
    };
    let (problem, report) = LevenbergMarquardt::new().minimize(problem);
    // No further improvement in floating point is a minimum too.
    let found = report.termination.was_successful()
        || matches!(
            report.termination,
            TerminationReason::NoImprovementPossible(_)
        );
    let parameters = problem.parameters;
    (found && parameters.iter().all(|p| p.is_finite())).then(|| Solution {
        parameters,
        residuals: problem.evaluate(),
        jacobian: problem.derivatives(),
    })
}

struct Problem<'a> {
    times: &'a [f64],
    values: &'a [f64],
    parameters: Parameters,
}

impl Problem<'_> {
    /// exp(-b t) times cosine and sine, at every time.
    fn waves(&self) -> impl Iterator<Item = (f64, f64)> {
        let [b, omega] = [self.parameters[3], self.parameters[4]];
        self.times.iter().map(move |t| {
            let decay = (-b * t).exp();
            let (sin, cos) = (omega * t).sin_cos();
            (decay * cos, decay * sin)
        })
    }

    fn evaluate(&self) -> DVector<f64> {
        let [y0, c, s] = [self.parameters[0], self.parameters[1], self.parameters[2]];
        let model = self.waves().map(|(cos, sin)| y0 + c * cos - s * sin);
        let residuals = model.zip(self.values).map(|(model, y)| model - y);
        DVector::from_iterator(self.times.len(), residuals)
    }

    fn derivatives(&self) -> OMatrix<f64, Dyn, U5> {
        let [c, s] = [self.parameters[1], self.parameters[2]];
        let mut jacobian = OMatrix::<f64, Dyn, U5>::zeros(self.times.len());
        for (i, ((cos, sin), t)) in self.waves().zip(self.times).enumerate() {
            let row = [
                1.0,
                cos,
                -sin,
                -t * (c * cos - s * sin),
                -t * (c * sin + s * cos),
            ];
            jacobian.row_mut(i).copy_from_slice(&row);
        }
        jacobian
    }
}

impl LeastSquaresProblem<f64, Dyn, U5> for Problem<'_> {
    type ParameterStorage = Owned<f64, U5>;
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, U5>;

    fn set_params(&mut self, parameters: &Parameters) {
        self.parameters = *parameters;
    }
    fn params(&self) -> Parameters {
        self.parameters
    }
    fn residuals(&self) -> Option<DVector<f64>> {
        Some(self.evaluate())
    }
    fn jacobian(&self) -> Option<OMatrix<f64, Dyn, U5>> {
        Some(self.derivatives())
    }
}
