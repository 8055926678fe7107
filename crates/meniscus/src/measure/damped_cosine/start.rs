//! Where the fit starts: the best of a grid of frequencies and damping rates.
//!
//! For a given frequency and damping rate the rest is linear least squares with three
//! unknowns, so that the best of them is found without a start of its own, and noise that
//! hides the zero crossings does no harm.

use std::f64::consts::TAU;

use nalgebra::{Matrix3, Vector3, Vector5};

/// More samples than this are averaged in groups before the scan.
const MOST_SAMPLES: usize = 1000;
/// Frequencies are a quarter of a period per series apart, within the width of a peak.
const PER_PERIOD: usize = 4;
/// Damping rates over the length of the series.
const DAMPING: [f64; 4] = [0.0, 1.0, 3.0, 10.0];

/// Starting parameters in the order of [`super::least_squares`], for times from 0 to 1.
pub(super) fn scan(times: &[f64], values: &[f64]) -> Vector5<f64> {
    let group = times.len().div_ceil(MOST_SAMPLES);
    let mean = |chunk: &[f64]| chunk.iter().sum::<f64>() / chunk.len() as f64;
    let times: Vec<f64> = times.chunks(group).map(mean).collect();
    let values: Vec<f64> = values.chunks(group).map(mean).collect();
    let decays = DAMPING.map(|b| times.iter().map(|t| (-b * t).exp()).collect::<Vec<_>>());

    // From half a period in the series to four samples in a period.
    let frequencies = PER_PERIOD / 2..=times.len() / 4 * PER_PERIOD;
    let mut waves = vec![(0.0, 0.0); times.len()];
    let mut best = (f64::NEG_INFINITY, Vector5::zeros());
    for frequency in frequencies {
        let omega = TAU * frequency as f64 / PER_PERIOD as f64;
        for (wave, t) in waves.iter_mut().zip(&times) {
            *wave = (omega * t).sin_cos();
        }
        for (b, decay) in DAMPING.iter().zip(&decays) {
            let (mut normal, mut right) = (Matrix3::zeros(), Vector3::zeros());
            for ((&(sin, cos), decay), &y) in waves.iter().zip(decay).zip(&values) {
                let row = Vector3::new(1.0, decay * cos, -decay * sin);
                normal += row * row.transpose();
                right += row * y;
            }
            let Some(linear) = normal.cholesky().map(|factor| factor.solve(&right)) else {
                continue;
            };
            // What the best linear part takes off the sum of squares.
            let explained = linear.dot(&right);
            if explained > best.0 {
                best = (
                    explained,
                    Vector5::new(linear[0], linear[1], linear[2], *b, omega),
                );
            }
        }
    }
    best.1
}
