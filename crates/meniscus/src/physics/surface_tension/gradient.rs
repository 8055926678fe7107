//! Sums that smooth a column of values, or take its gradient:
//!
//! - f_i      = sum_j w_j W_ij                          of weighted values w = V f
//! - grad f_i = sum_j V_j (f_j - f_i) grad W_ij         (Morris 2000; exact for a constant)
//! - grad f_i = A_i^-1 sum_j V_j (f_j - f_i) grad W_ij,
//!   A_i = sum_j V_j (x_j - x_i) grad W_ij              (CSPM, Chen, Beraun and Carney 1999;
//!   exact for a linear f, also where a part of the kernel is empty)

use super::matrix::Matrix;
use crate::particles::Particles;
use crate::real::Real;
use crate::record;
use crate::term::{Pair, PairTerm};
use crate::vector::Vector;

/// Sums to sum_j w_j W_ij.
#[derive(Clone, Copy, Debug)]
pub struct Smoothed<'a> {
    /// w of each particle, its value times its volume.
    pub weighted: &'a [f64],
}

impl<const D: usize> PairTerm<D> for Smoothed<'_> {
    type Record<R: Real> = R;
    type Sum<R: Real> = R;

    fn record(&self, _: &Particles<D>, i: usize) -> f64 {
        self.weighted[i]
    }

    #[inline(always)]
    fn pair<R: Real>(&self, _: &R, weighted: &R, ij: &Pair<R, D>, sum: &mut R) {
        *sum = *sum + *weighted * ij.w;
    }
}

record! {
    /// Volume and a value.
    pub struct Valued<R, D> {
        /// V, m^D
        volume: R,
        /// f
        value: R,
    }
}

/// Sums to sum_j V_j (f_j - f_i) grad W_ij.
#[derive(Clone, Copy, Debug)]
pub struct Gradient<'a> {
    /// f of each particle.
    pub values: &'a [f64],
}

impl<const D: usize> PairTerm<D> for Gradient<'_> {
    type Record<R: Real> = Valued<R, D>;
    type Sum<R: Real> = Vector<R, D>;

    fn record(&self, particles: &Particles<D>, i: usize) -> Valued<f64, D> {
        Valued {
            volume: particles.volume(i),
            value: self.values[i],
        }
    }

    #[inline(always)]
    fn pair<R: Real>(
        &self,
        i: &Valued<R, D>,
        j: &Valued<R, D>,
        ij: &Pair<R, D>,
        sum: &mut Vector<R, D>,
    ) {
        *sum += ij.grad_w * (j.volume * (j.value - i.value));
    }
}

/// Sums to the gradient as [`Gradient`] has it, and to A.
#[derive(Clone, Copy, Debug)]
pub struct CorrectedGradient<'a> {
    /// f of each particle.
    pub values: &'a [f64],
}

record! {
    /// A gradient and what it must be divided by.
    pub struct Correctable<R, D> {
        /// sum_j V_j (f_j - f_i) grad W_ij
        gradient: Vector<R, D>,
        /// A
        matrix: Matrix<R, D>,
    }
}

impl<const D: usize> PairTerm<D> for CorrectedGradient<'_> {
    type Record<R: Real> = Valued<R, D>;
    type Sum<R: Real> = Correctable<R, D>;

    fn record(&self, particles: &Particles<D>, i: usize) -> Valued<f64, D> {
        Gradient {
            values: self.values,
        }
        .record(particles, i)
    }

    #[inline(always)]
    fn pair<R: Real>(
        &self,
        i: &Valued<R, D>,
        j: &Valued<R, D>,
        ij: &Pair<R, D>,
        sum: &mut Correctable<R, D>,
    ) {
        sum.add(ij.grad_w * j.volume, j.value - i.value, &ij.offset);
    }
}

impl<R: Real, const D: usize> Correctable<R, D> {
    /// Adds a neighbour: V_j grad W_ij, f_j - f_i and x_i - x_j.
    #[inline(always)]
    pub fn add(&mut self, weighted: Vector<R, D>, difference: R, offset: &Vector<R, D>) {
        self.gradient += weighted * difference;
        // x_j - x_i is minus the offset.
        self.matrix.add_outer(&-weighted, offset);
    }
}

impl<const D: usize> Correctable<f64, D> {
    /// A^-1 times the gradient; less where so few neighbours are left, as about a particle
    /// thrown out, that it would be mostly correction.
    pub fn corrected(&self) -> Vector<f64, D> {
        let filling = self.matrix.trace() / D as f64;
        let trust = (filling / LEAST_FILLING).min(1.0);
        self.matrix.inverse(LEAST_MATRIX).times(&self.gradient) * trust
    }
}

/// Mean of A's eigenvalues from which on a corrected gradient is trusted: 1 inside,
/// 1/2 at a plane surface, 1/4 at a corner of a square, 1/8 of a cube.
pub(crate) const LEAST_FILLING: f64 = 0.1;

/// How round A must be to be inverted, see [`Matrix::inverse`]: 1 inside and at a
/// plane surface, 0.77 at a corner of a square, 0 for particles on a line.
pub(crate) const LEAST_MATRIX: f64 = 0.2;
