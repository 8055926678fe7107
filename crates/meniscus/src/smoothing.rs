//! The smoothing length of a pair.

use crate::particles::Particles;

/// The smoothing length h_ij of a pair.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Smoothing {
    /// One for all pairs, m.
    Constant(f64),
    /// `factor` (h_i + h_j) / 2, with those of the particles: the same seen from either, so that
    /// forces stay antisymmetric.
    Mean {
        /// 1 for the mean itself.
        factor: f64,
    },
}

impl From<f64> for Smoothing {
    fn from(smoothing_length: f64) -> Self {
        Smoothing::Constant(smoothing_length)
    }
}

impl Smoothing {
    /// h_ij of rows `i` and `j`, m.
    pub fn of_pair<const D: usize>(self, particles: &Particles<D>, i: usize, j: usize) -> f64 {
        match self {
            Smoothing::Constant(h) => h,
            Smoothing::Mean { .. } => self.share(particles, i) + self.share(particles, j),
        }
    }

    /// What row `i` brings to h_ij, m.
    pub(crate) fn share<const D: usize>(self, particles: &Particles<D>, i: usize) -> f64 {
        match self {
            Smoothing::Constant(h) => 0.5 * h,
            Smoothing::Mean { factor } => 0.5 * factor * particles.smoothing_length[i],
        }
    }
}
