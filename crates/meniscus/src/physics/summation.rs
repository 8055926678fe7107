//! Density by summation:
//!
//! rho_i = sum_j m_j W_ij
//!
//! Exact mass conservation, but too low within a smoothing length of a free
//! surface, where part of the kernel is empty: meant for filled domains.

use crate::particles::Particles;
use crate::real::Real;
use crate::term::{Pair, PairTerm};

/// Sums to density, kg/m^3.
#[derive(Clone, Copy, Debug)]
pub struct Summation;

impl<const D: usize> PairTerm<D> for Summation {
    type Record<R: Real> = R;
    type Sum<R: Real> = R;
    const OFTEN: bool = false;

    fn record(&self, particles: &Particles<D>, i: usize) -> f64 {
        particles.mass[i]
    }

    #[inline(always)]
    fn pair<R: Real>(&self, _: &R, mass: &R, ij: &Pair<R, D>, sum: &mut R) {
        *sum = *sum + *mass * ij.w;
    }
}
