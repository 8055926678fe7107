//! How well the parameters are known, when what is left over is no white noise.
//!
//! The parameters of a wave feel noise of about its own frequency only, the offset
//! noise of about none. So in the text-book covariance of least squares the variance of
//! white noise is replaced by the spectral density of the residuals, averaged over
//! the neighbouring frequencies that the fit leaves free (for sinusoids, plain least
//! squares is as sharp as weighted: Grenander and Rosenblatt 1957, Statistical
//! Analysis of Stationary Time Series, ch. 7). A wave that is no damped cosine leaves
//! its traces at these very frequencies, and widens the interval, however finely it is
//! sampled.

use std::f64::consts::TAU;

use nalgebra::{Matrix5, Vector5};

use super::least_squares::Solution;
use crate::measure::estimate::student_t;

/// So many periods per series to either side are averaged.
const NEIGHBOURS: i32 = 3;

/// What intervals of parameters and functions of them are computed from.
pub(super) struct Confidence {
    covariance: Matrix5<f64>,
    /// Deviation of the noise times the quantile, as the offset feels it.
    offset_factor: f64,
    /// The same as the other parameters feel it.
    wave_factor: f64,
    /// How many independent samples would tell the wave as sharply.
    pub effective_samples: f64,
}

impl Confidence {
    /// For times from 0 to 1; `None` if the series does not tell the parameters apart.
    pub(super) fn of(times: &[f64], solution: &Solution) -> Option<Self> {
        let n = times.len() as f64;
        let periods = solution.parameters[4].abs() / TAU;
        let density = |cycles: f64| {
            let (mut real, mut imaginary) = (0.0, 0.0);
            for (t, r) in times.iter().zip(&solution.residuals) {
                let (sin, cos) = (TAU * cycles * t).sin_cos();
                real += r * cos;
                imaginary += r * sin;
            }
            (real * real + imaginary * imaginary) / n
        };
        let around_wave = (-NEIGHBOURS..=NEIGHBOURS)
            .map(|k| periods + f64::from(k))
            .filter(|&cycles| cycles >= 0.9);
        // The four parameters of the wave take two frequencies' cosines and sines.
        let free_at_wave = around_wave.clone().count() as f64 - 2.0;
        let at_wave = around_wave.map(density).sum::<f64>() / free_at_wave;
        // Where the wave is slow it takes from these too: the noise is no less than there.
        let free_at_zero = f64::from(NEIGHBOURS);
        let at_zero = (1..=NEIGHBOURS).map(|k| density(f64::from(k))).sum::<f64>() / free_at_zero;
        let at_zero = at_zero.max(at_wave);
        let variance = solution.residuals.norm_squared() / n;
        let covariance = solution.jacobian.tr_mul(&solution.jacobian).try_inverse()?;
        Some(Confidence {
            covariance,
            offset_factor: at_zero.sqrt() * student_t(2.0 * free_at_zero),
            wave_factor: at_wave.sqrt() * student_t(2.0 * free_at_wave),
            effective_samples: n * (variance / at_wave).min(1.0),
        })
    }

    /// Half of the 95 % interval of a function with this gradient.
    pub(super) fn half_width(&self, gradient: [f64; 5]) -> f64 {
        let mut felt = Vector5::repeat(self.wave_factor);
        felt[0] = self.offset_factor;
        let gradient = felt.component_mul(&Vector5::from(gradient));
        gradient.dot(&(self.covariance * gradient)).max(0.0).sqrt()
    }
}
