//! What a wall bears of the capillary pressure q, in the form in which it bears p - q:
//!
//! rho_i a_i = -sum_j V_j (q_i + q_j) grad W_ij
//!
//! of a wall's particle i, over liquid j.

use crate::particles::Particles;
use crate::physics::wall::WallBodies;
use crate::real::Real;
use crate::term::{Pair, PairTerm};
use crate::vector::Vector;

/// Sums to a force per volume, N/m^3.
#[derive(Clone, Copy, Debug)]
pub struct Load<'a> {
    /// kappa, 1/m
    pub curvature: &'a [f64],
    /// sigma, N/m
    pub surface_tension: f64,
    /// What is no liquid.
    pub walls: WallBodies<'a>,
}

impl<const D: usize> PairTerm<D> for Load<'_> {
    /// q, and volume; none of the latter for walls.
    type Record<R: Real> = (R, R);
    type Sum<R: Real> = Vector<R, D>;
    const OFTEN: bool = false;

    fn record(&self, particles: &Particles<D>, i: usize) -> (f64, f64) {
        let is_wall = self.walls.hold(particles.body[i]);
        (
            self.surface_tension * self.curvature[i],
            if is_wall { 0.0 } else { particles.volume(i) },
        )
    }

    #[inline(always)]
    fn pair<R: Real>(&self, i: &(R, R), j: &(R, R), ij: &Pair<R, D>, sum: &mut Vector<R, D>) {
        *sum += ij.grad_w * -(j.1 * (i.0 + j.0));
    }
}
