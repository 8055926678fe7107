//! Tartakovsky and Panchenko (2016), J. Comput. Phys. 305, 1119 ("Pairwise Force Smoothed
//! Particle Hydrodynamics model for multiphase flow"): two Gaussians, with s the support,
//!
//! - f(r) = psi(r, e) - A psi(r, e/2)                     plain
//! - f(r) = (r/s) (psi(r, e) - A psi(r, e/2))             times the distance
//! - psi(r, e) = exp(-r^2 / (2 e^2)), e = s / 3.5, r < s
//! - A = 2^(D+1)
//!
//! With this A the plain pair leaves an even bulk without pressure: the integral of f r^D
//! vanishes, so that it does not compress a liquid. The second holds it together in bulk
//! as well. Either drops to zero from 0.002 of psi's height at s.

use super::Attraction;
use crate::real::Real;

/// Two Gaussians.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GaussianPair {
    /// Finite, and strongest, between two particles at one place.
    Plain,
    /// Times the distance: nothing between two particles at one place.
    TimesDistance,
}

impl Attraction for GaussianPair {
    #[inline(always)]
    fn attraction<R: Real, const D: usize>(&self, distance: R, support: f64) -> R {
        let one = distance.literal(1.0);
        let q = distance * (1.0 / support);
        let within = q.min(one);
        let wide = (within.square() * (0.5 * 3.5 * 3.5)).exp_minus();
        let narrow = wide.square().square();
        let pair = wide - narrow * f64::from(2_u32 << D);
        let value = match self {
            GaussianPair::Plain => pair,
            GaussianPair::TimesDistance => pair * within,
        };
        R::select(q.less(one), value, one.zero())
    }
}
