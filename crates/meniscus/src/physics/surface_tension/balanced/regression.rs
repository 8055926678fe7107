//! Curvature by regression. Every particle i of the layer has a point X_i = x_i - d_i u_i of the
//! surface above it. Over its neighbours j in the layer with u_i . u_j > 0, weighted with
//! V_j |n_j| W_ij, the turning of the normal against the way along the surface,
//! s_j = X_j - X_i and q_j = -u_j, both in the tangent plane of i, gives
//!
//! kappa_i = trace(Cov(q, s) Var(s)^-1)
//!
//! 1/R for a circle, 2/R for a sphere.

use super::super::matrix::Matrix;
use crate::particles::Particles;
use crate::real::Real;
use crate::record;
use crate::term::{Pair, PairTerm};
use crate::vector::Vector;

record! {
    /// A point of the surface.
    pub struct Point<R, D> {
        /// d u, m: from the surface to the particle
        inset: Vector<R, D>,
        /// u, into the liquid
        direction: Vector<R, D>,
        /// V |n|, m^(D-1); 0 outside the layer
        weight: R,
    }
}

impl<const D: usize> Default for Point<f64, D> {
    fn default() -> Self {
        Self {
            inset: Vector::ZERO,
            direction: Vector::ZERO,
            weight: 0.0,
        }
    }
}

record! {
    /// Weighted sums of s, u and their products.
    pub struct Moments<R, D> {
        /// Of 1
        weight: R,
        /// Of s
        along: Vector<R, D>,
        /// Of u
        direction: Vector<R, D>,
        /// Of s s
        spread: Matrix<R, D>,
        /// Of u s
        turning: Matrix<R, D>,
    }
}

/// Sums to the moments.
#[derive(Clone, Copy, Debug)]
pub struct Regression<'a, const D: usize> {
    /// One for each particle.
    pub points: &'a [Point<f64, D>],
}

impl<const D: usize> PairTerm<D> for Regression<'_, D> {
    type Record<R: Real> = Point<R, D>;
    type Sum<R: Real> = Moments<R, D>;
    const OFTEN: bool = false;

    fn record(&self, _: &Particles<D>, i: usize) -> Point<f64, D> {
        self.points[i]
    }

    #[inline(always)]
    fn pair<R: Real>(
        &self,
        i: &Point<R, D>,
        j: &Point<R, D>,
        ij: &Pair<R, D>,
        sum: &mut Moments<R, D>,
    ) {
        let along = i.inset - j.inset - ij.offset;
        sum.add(i, j, along, ij.w);
    }
}

impl<R: Real, const D: usize> Moments<R, D> {
    /// Adds a point `along` the surface from another, m, that counts so much.
    #[inline(always)]
    pub(super) fn add(
        &mut self,
        i: &Point<R, D>,
        j: &Point<R, D>,
        along: Vector<R, D>,
        nearness: R,
    ) {
        let zero = nearness.zero();
        let same_side = zero.less(i.direction.dot(&j.direction));
        let weight = R::select(same_side, j.weight * nearness, zero);
        let weighted = along * weight;
        self.weight = self.weight + weight;
        self.along += weighted;
        self.direction += j.direction * weight;
        self.spread.add_outer(&weighted, &along);
        self.turning.add_outer(&j.direction, &weighted);
    }
}

/// How evenly the neighbours must lie about a particle, see [`Matrix::inverse`].
const LEAST_SPREAD: f64 = 0.1;

impl<const D: usize> Moments<f64, D> {
    /// kappa, 1/m, of a surface that faces `direction`; zero without neighbours.
    pub fn curvature(&self, direction: &Vector<f64, D>) -> f64 {
        if self.weight <= 0.0 {
            return 0.0;
        }
        let share = 1.0 / self.weight;
        let (along, turned) = (self.along * share, self.direction * share);
        let covariance = |products: &Matrix<f64, D>, first: &Vector<f64, D>| {
            Matrix(std::array::from_fn(|a| {
                products.0[a] * share - along * first[a]
            }))
            .within(direction)
        };
        let mut spread = covariance(&self.spread, &along);
        let turning = covariance(&self.turning, &turned);
        // A particle on its own has none, but for rounding.
        let mean = spread.trace() / (D as f64 - 1.0);
        if mean <= 0.0 {
            return 0.0;
        }
        spread.add_outer(&(*direction * mean), direction);
        -turning.trace_of_product(&spread.inverse(LEAST_SPREAD))
    }
}
