//! Curvature as the divergence of unit normals u, which point into the liquid:
//! kappa = -div u, 1/R on a circle, 2/R on a sphere. Each particle takes part with a
//! weight w_j: its volume, or none where its normal cannot be relied on.
//!
//! - C_i     = sum_j w_j W_ij
//! - div u_i = sum_j w_j (u_j - u_i) . grad W_ij / C_i                    (Morris 2000)
//! - div u_i = trace(A_i^-1 G_i),   G_i = sum_j w_j (u_j - u_i) grad W_ij,
//!   A_i = sum_j w_j (x_j - x_i) grad W_ij                                (CSPM)

use super::gradient::LEAST_MATRIX;
use super::matrix::Matrix;
use crate::particles::Particles;
use crate::real::Real;
use crate::record;
use crate::term::{Pair, PairTerm};
use crate::vector::Vector;

record! {
    /// Unit normal and weight.
    pub struct Oriented<R, D> {
        /// u
        direction: Vector<R, D>,
        /// w, m^D or m^(D-1)
        weight: R,
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

/// What a particle whose normal can be relied on weighs in a divergence.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Weighting {
    /// V
    Volume,
    /// V |n|: most where the surface is, none where normals end
    NormalLength,
}

/// Morris's form: sums to C and C div u.
#[derive(Clone, Copy, Debug)]
pub struct Curvature<'a, const D: usize> {
    /// n of each particle, 1/m.
    pub normal: &'a [Vector<f64, D>],
    /// Normals shorter than this cannot be relied on, 1/m.
    pub shortest: f64,
    /// What the others weigh.
    pub weighting: Weighting,
}

impl<const D: usize> Curvature<'_, D> {
    /// Whether a normal can be relied on.
    pub(super) fn is_active(&self, normal: &Vector<f64, D>) -> bool {
        // No normal has no direction, whatever the threshold.
        normal.norm_squared() >= (self.shortest * self.shortest).max(f64::MIN_POSITIVE)
    }
}

impl<const D: usize> PairTerm<D> for Curvature<'_, D> {
    type Record<R: Real> = Oriented<R, D>;
    type Sum<R: Real> = Divergence<R, D>;

    fn record(&self, particles: &Particles<D>, i: usize) -> Oriented<f64, D> {
        let normal = self.normal[i];
        let length = normal.norm();
        if !self.is_active(&normal) {
            return Oriented {
                direction: Vector::ZERO,
                weight: 0.0,
            };
        }
        let volume = particles.volume(i);
        Oriented {
            direction: normal * (1.0 / length),
            weight: match self.weighting {
                Weighting::Volume => volume,
                Weighting::NormalLength => volume * length,
            },
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
        sum.correction = sum.correction + j.weight * ij.w;
        sum.divergence = sum.divergence + j.weight * (j.direction - i.direction).dot(&ij.grad_w);
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
        let weighted = ij.grad_w * j.weight;
        sum.gradient
            .add_outer(&(j.direction - i.direction), &weighted);
        // x_j - x_i is minus the offset.
        sum.matrix.add_outer(&-weighted, &ij.offset);
    }
}

impl<const D: usize> CorrectableDivergence<f64, D> {
    /// The gradient of u, one row for each of its components, 1/m.
    pub fn gradient(&self) -> Matrix<f64, D> {
        let inverse = self.matrix.inverse(LEAST_MATRIX);
        Matrix(self.gradient.0.map(|row| inverse.times(&row)))
    }
}
