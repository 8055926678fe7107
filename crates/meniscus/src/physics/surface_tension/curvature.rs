//! Curvature as the divergence of unit normals u, which point into the liquid:
//! kappa = -div u, 1/R on a circle, 2/R on a sphere. Only particles whose
//! normal can be relied on (N = 1) take part, on either side of a pair:
//!
//! - C_i     = sum_j V_j min(N_i, N_j) W_ij
//! - div u_i = sum_j min(N_i, N_j) V_j (u_j - u_i) . grad W_ij / C_i      (Morris 2000)
//! - div u_i = trace(A_i^-1 G_i),   G_i = sum_j min(N_i, N_j) V_j (u_j - u_i) grad W_ij,
//!   A_i = sum_j min(N_i, N_j) V_j (x_j - x_i) grad W_ij                  (CSPM)

use super::gradient::LEAST_MATRIX;
use super::matrix::Matrix;
use crate::particles::Particles;
use crate::real::Real;
use crate::record;
use crate::term::{Pair, PairTerm};
use crate::vector::Vector;

record! {
    /// Volume, unit normal and N.
    pub struct Oriented<R, D> {
        /// u
        direction: Vector<R, D>,
        /// V, m^D
        volume: R,
        /// N, 0 or 1
        active: R,
    }
}

record! {
    /// A divergence and what it must be divided by.
    pub struct Divergence<R, D> {
        /// C
        correction: R,
        /// C div u, 1/m
        divergence: R,
    }
}

/// Morris's form: sums to C and C div u.
#[derive(Clone, Copy, Debug)]
pub struct Curvature<'a, const D: usize> {
    /// n of each particle, 1/m.
    pub normal: &'a [Vector<f64, D>],
    /// Normals shorter than this count as none, 1/m.
    pub shortest: f64,
}

impl<const D: usize> Curvature<'_, D> {
    /// Whether a normal can be relied on.
    pub(super) fn is_active(&self, normal: &Vector<f64, D>) -> bool {
        normal.norm_squared() >= self.shortest * self.shortest
    }
}

impl<const D: usize> PairTerm<D> for Curvature<'_, D> {
    type Record<R: Real> = Oriented<R, D>;
    type Sum<R: Real> = Divergence<R, D>;

    fn record(&self, particles: &Particles<D>, i: usize) -> Oriented<f64, D> {
        let normal = self.normal[i];
        let active = self.is_active(&normal);
        Oriented {
            direction: if active {
                normal * (1.0 / normal.norm())
            } else {
                Vector::ZERO
            },
            volume: particles.volume(i),
            active: if active { 1.0 } else { 0.0 },
        }
    }

    #[inline(always)]
    fn pair<R: Real>(
        &self,
        i: &Oriented<R, D>,
        j: &Oriented<R, D>,
        ij: &Pair<R, D>,
        sum: &mut Divergence<R, D>,
    ) {
        let volume = i.active.min(j.active) * j.volume;
        sum.correction = sum.correction + volume * ij.w;
        sum.divergence = sum.divergence + volume * (j.direction - i.direction).dot(&ij.grad_w);
    }
}

/// The corrected form: sums to G and A.
#[derive(Clone, Copy, Debug)]
pub struct CorrectedCurvature<'a, const D: usize>(pub Curvature<'a, D>);

record! {
    /// The gradient of a vector and what it must be divided by.
    pub struct CorrectableDivergence<R, D> {
        /// G, 1/m
        gradient: Matrix<R, D>,
        /// A
        matrix: Matrix<R, D>,
    }
}

impl<const D: usize> PairTerm<D> for CorrectedCurvature<'_, D> {
    type Record<R: Real> = Oriented<R, D>;
    type Sum<R: Real> = CorrectableDivergence<R, D>;

    fn record(&self, particles: &Particles<D>, i: usize) -> Oriented<f64, D> {
        self.0.record(particles, i)
    }

    #[inline(always)]
    fn pair<R: Real>(
        &self,
        i: &Oriented<R, D>,
        j: &Oriented<R, D>,
        ij: &Pair<R, D>,
        sum: &mut CorrectableDivergence<R, D>,
    ) {
        let weighted = ij.grad_w * (i.active.min(j.active) * j.volume);
        sum.gradient
            .add_outer(&(j.direction - i.direction), &weighted);
        // x_j - x_i is minus the offset.
        sum.matrix.add_outer(&-weighted, &ij.offset);
    }
}

impl<const D: usize> CorrectableDivergence<f64, D> {
    /// div u, 1/m; uncorrected where too few neighbours are left for A to be inverted.
    pub fn divergence(&self) -> f64 {
        let inverse = self.matrix.inverse(LEAST_MATRIX);
        (0..D)
            .map(|d| match &inverse {
                Some(inverse) => self.gradient.0[d].dot(&inverse.0[d]),
                None => self.gradient.0[d][d],
            })
            .sum()
    }
}
