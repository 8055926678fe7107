//! Smoothing lengths by adaptive density kernel estimation (Silverman 1986, "Density Estimation",
//! sec. 5.3; Sigalotti, Daza and Donoso 2006, eqs. 14 and 15). With the pilot density rho^, summed
//! with the one length h_0 of the scheme, and its geometric mean g over all N particles:
//!
//! - rho^_a = sum_b m_b W(r_ab, h_0)
//! - log g = 1/N sum_b log rho^_b                 (eq. 15)
//! - h_a = h_0 k (rho^_a / g)^-epsilon            (eq. 14)
//!
//! h is longer where the liquid is thin, as at a free surface (the paper's text says
//! shorter). In all other sums a pair has h_ab = (h_a + h_b) / 2.

use rayon::prelude::*;

use super::summation::Summation;
use crate::particles::{Particles, ROWS_PER_TASK};
use crate::smoothing::Smoothing;
use crate::term::SweepWith;

/// How smoothing lengths follow density.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AdaptiveSmoothing {
    /// k, by which all lengths are multiplied: 1 or a little less.
    pub k: f64,
    /// epsilon, from 0, one length for all, to 1.
    pub epsilon: f64,
    /// Whether forces have the grad-h terms, which conserve energy; see
    /// [`grad_h`](super::grad_h).
    pub grad_h: bool,
}

impl Default for AdaptiveSmoothing {
    fn default() -> Self {
        Self {
            k: 0.9,
            epsilon: 0.6,
            grad_h: false,
        }
    }
}

/// The pilot estimate of the last lengths.
#[derive(Debug, Default)]
pub(crate) struct Pilot {
    /// rho^, kg/m^3.
    pub(crate) density: Vec<f64>,
    logarithm: Vec<f64>,
}

impl AdaptiveSmoothing {
    /// Gives particles their smoothing lengths, from h_0 in m, which `sweep` must
    /// hold too.
    pub(crate) fn adapt<const D: usize>(
        &self,
        smoothing_length: f64,
        sweep: &mut impl SweepWith<D>,
        particles: &mut Particles<D>,
        pilot: &mut Pilot,
    ) {
        let constant = Smoothing::Constant(smoothing_length);
        let Pilot { density, logarithm } = pilot;
        sweep.sweep_with(constant, &Summation, particles, |_| true, density);
        logarithm.resize(density.len(), 0.0);
        (logarithm.par_iter_mut(), &*density)
            .into_par_iter()
            .with_min_len(ROWS_PER_TASK)
            .for_each(|(logarithm, density)| *logarithm = density.ln());
        let mean = sum(logarithm) / logarithm.len().max(1) as f64;
        let longest = self.k * smoothing_length;
        (particles.smoothing_length.par_iter_mut(), &*logarithm)
            .into_par_iter()
            .with_min_len(ROWS_PER_TASK)
            .for_each(|(h, logarithm)| *h = longest * (-self.epsilon * (logarithm - mean)).exp());
    }
}

/// The sum in an order of its own, whatever the number of threads: eight sums side by side, which
/// need not wait for each other.
fn sum(values: &[f64]) -> f64 {
    let (eights, rest) = values.as_chunks::<8>();
    let mut sums = [0.0; 8];
    for eight in eights {
        for (sum, value) in sums.iter_mut().zip(eight) {
            *sum += value;
        }
    }
    sums.iter().chain(rest).sum()
}
