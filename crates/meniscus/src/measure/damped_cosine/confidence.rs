//! How well the parameters are known, when what is left over is no white noise.
//!
//! The residuals are modelled as an autoregressive process, its coefficients by
//! Burg's method, its order by Akaike's criterion. Its whitening filter is applied to the
//! derivatives of the model; from there on the text-book formula of least squares
//! holds. The fit itself needs no whitening: for sinusoids, plain least squares is as
//! sharp as weighted (Grenander and Rosenblatt 1957, Statistical Analysis of
//! Stationary Time Series, ch. 7).

use nalgebra::{Matrix5, RowVector5, Vector5};

use super::least_squares::Solution;
use crate::measure::estimate::student_t;

/// Highest order of the autoregressive model.
const HIGHEST_ORDER: usize = 10;

/// What intervals of parameters and functions of them are computed from.
pub(super) struct Confidence {
    covariance: Matrix5<f64>,
    quantile: f64,
    /// How many independent samples would tell the mean as sharply.
    pub effective_samples: f64,
}

impl Confidence {
    pub(super) fn of(solution: &Solution) -> Self {
        let residuals = solution.residuals.as_slice();
        let n = residuals.len() as f64;
        let noise = Autoregression::fit(residuals);
        let order = noise.coefficients.len();

        let mut normal = Matrix5::zeros();
        let mut innovation = 0.0;
        for i in order..residuals.len() {
            let row: RowVector5<f64> = noise.whiten(i, |j| solution.jacobian.row(j).into_owned());
            normal += row.transpose() * row;
            innovation += noise.whiten(i, |j| residuals[j]).powi(2);
        }
        innovation /= n - 2.0 * order as f64 - 5.0;

        // The spectrum at zero frequency against the variance of the samples.
        let gain = 1.0 + noise.coefficients.iter().sum::<f64>();
        let variance = residuals.iter().map(|r| r * r).sum::<f64>() / n;
        let independence = variance * gain * gain / innovation;
        let effective_samples = if independence < 1.0 {
            n * independence
        } else {
            n
        };
        // Of few independent samples the fit itself swallows a part, which makes the
        // rest look smaller and less correlated than the noise is.
        let degrees = effective_samples - 5.0;
        let swallowed = effective_samples / degrees.max(1.0);
        let inverse = normal
            .try_inverse()
            .unwrap_or_else(|| Matrix5::repeat(f64::INFINITY));
        Confidence {
            covariance: inverse * (innovation * swallowed),
            quantile: student_t(degrees.max(4.0)),
            effective_samples,
        }
    }

    /// Half of the 95 % interval of a function with this gradient.
    pub(super) fn half_width(&self, gradient: [f64; 5]) -> f64 {
        let gradient = Vector5::from(gradient);
        self.quantile * gradient.dot(&(self.covariance * gradient)).max(0.0).sqrt()
    }
}

/// r_i + sum_k a_k r_(i-k) is white.
struct Autoregression {
    coefficients: Vec<f64>,
}

impl Autoregression {
    /// Burg's method; Akaike's criterion with its correction for short series.
    fn fit(series: &[f64]) -> Self {
        let n = series.len();
        let (mut forward, mut backward) = (series.to_vec(), series.to_vec());
        let mut power = series.iter().map(|r| r * r).sum::<f64>() / n as f64;
        let mut coefficients: Vec<f64> = vec![];
        let mut best = (f64::INFINITY, vec![]);
        loop {
            let order = coefficients.len();
            let parameters = order as f64 + 1.0;
            let penalty = 2.0 * parameters * n as f64 / (n as f64 - parameters - 1.0);
            let criterion = n as f64 * power.ln() + penalty;
            if criterion < best.0 {
                best = (criterion, coefficients.clone());
            }
            if order == HIGHEST_ORDER.min(n / 10) {
                return Autoregression {
                    coefficients: best.1,
                };
            }
            let (mut cross, mut sum) = (0.0, 0.0);
            for i in order + 1..n {
                cross += forward[i] * backward[i - 1];
                sum += forward[i].powi(2) + backward[i - 1].powi(2);
            }
            let reflection = if sum > 0.0 { -2.0 * cross / sum } else { 0.0 };
            for i in (order + 1..n).rev() {
                let (f, b) = (forward[i], backward[i - 1]);
                forward[i] = f + reflection * b;
                backward[i] = b + reflection * f;
            }
            let previous = coefficients.clone();
            for (a, b) in coefficients.iter_mut().zip(previous.iter().rev()) {
                *a += reflection * b;
            }
            coefficients.push(reflection);
            power *= 1.0 - reflection * reflection;
        }
    }

    /// The i-th entry of a series, numbers or rows, after the whitening filter.
    fn whiten<T>(&self, i: usize, series: impl Fn(usize) -> T) -> T
    where
        T: std::ops::Mul<f64, Output = T> + std::ops::Add<Output = T>,
    {
        let terms = self.coefficients.iter().enumerate();
        terms.fold(series(i), |sum, (k, &a)| sum + series(i - k - 1) * a)
    }
}
