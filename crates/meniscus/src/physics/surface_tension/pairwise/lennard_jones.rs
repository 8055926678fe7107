//! The Lennard-Jones potential, u = e ((r_0/r)^12 - 2 (r_0/r)^6), cut off at the support s:
//!
//! - f(r) = (r_0/r)^7 - (r_0/r)^13, r < s
//!
//! of which r_0 is the distance at rest. Nearer than r_0 / 2 the force stays what it is there.
//! Nothing else that pairs do is as stiff: a step has to be short against the swing of a particle
//! between its neighbours ([`LennardJones::stiffness`]).

use super::Attraction;
use crate::real::Real;

/// The force of the Lennard-Jones potential.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LennardJones {
    /// r_0, m
    pub rest_distance: f64,
}

impl Attraction for LennardJones {
    #[inline(always)]
    fn attraction<R: Real, const D: usize>(&self, distance: R, support: f64) -> R {
        let near = distance.max(distance.literal(0.5 * self.rest_distance));
        let ratio = distance.literal(self.rest_distance) / near;
        let sixth = ratio.square().powi(3);
        let value = ratio * sixth * (-sixth + 1.0);
        let within = distance.less(distance.literal(support));
        R::select(within, value, distance.zero())
    }
}

impl LennardJones {
    /// The square of the frequency, 1/s^2, at which a particle swings between its neighbours that
    /// pull with accelerations `strength` f, m/s^2, where the largest acceleration is `largest`.
    ///
    /// Its 2 D nearest are springs of 6 `strength` / r_0 at rest; one that is pressed until it
    /// gives the largest acceleration is of 13 times that over r_0. Both ends of a spring move.
    pub fn stiffness(&self, strength: f64, largest: f64, dimension: usize) -> f64 {
        let at_rest = 12.0 * dimension as f64 * strength;
        2.0 * (at_rest + 13.0 * largest) / self.rest_distance
    }
}
