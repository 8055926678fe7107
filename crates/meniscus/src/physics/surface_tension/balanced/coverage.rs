//! What surrounds a particle:
//!
//! - c_i = sum_j V_j W_ij, 1 inside, about 1/2 at a surface
//! - n_i = sum_j V_j grad W_ij, zero inside: what a constant pressure p pushes with, by -2 p V_i n_i
//! - g_i = A_i^-1 sum_j V_j (c_j - c_i) grad W_ij, A_i as in [`super::super::gradient`]: into the liquid
//! - the neighbours close by that lie at the surface itself

use super::super::gradient::Correctable;
use crate::particles::Particles;
use crate::real::Real;
use crate::record;
use crate::term::{Pair, PairTerm};
use crate::vector::Vector;

/// Sums to c and n.
#[derive(Clone, Copy, Debug)]
pub struct Coverage;

record! {
    /// c and n.
    pub struct Covered<R, D> {
        /// c
        filled: R,
        /// n, 1/m
        normal: Vector<R, D>,
    }
}

impl<const D: usize> PairTerm<D> for Coverage {
    type Record<R: Real> = R;
    type Sum<R: Real> = Covered<R, D>;

    fn record(&self, particles: &Particles<D>, i: usize) -> f64 {
        particles.volume(i)
    }

    #[inline(always)]
    fn pair<R: Real>(&self, _: &R, volume: &R, ij: &Pair<R, D>, sum: &mut Covered<R, D>) {
        sum.filled = volume.mul_add(ij.w, sum.filled);
        sum.normal += ij.grad_w * *volume;
    }
}

/// Sums to the gradient of c, and to the neighbours at the surface.
#[derive(Clone, Copy, Debug)]
pub struct Inward<'a> {
    /// c of each particle.
    pub filled: &'a [f64],
    /// Particles with less are at the surface.
    pub open: f64,
    /// How near they count, m.
    pub near: f64,
}

record! {
    /// V, c, and whether it is at the surface, 1 or 0.
    pub struct Coloured<R, D> {
        /// V, m^D
        volume: R,
        /// c
        filled: R,
        /// 1 or 0
        open: R,
    }
}

record! {
    /// The gradient of c and what it must be divided by.
    pub struct Facing<R, D> {
        /// The gradient, 1/m.
        inward: Correctable<R, D>,
        /// Neighbours at the surface.
        open: R,
    }
}

impl<const D: usize> PairTerm<D> for Inward<'_> {
    type Record<R: Real> = Coloured<R, D>;
    type Sum<R: Real> = Facing<R, D>;
    const OFTEN: bool = false;

    fn record(&self, particles: &Particles<D>, i: usize) -> Coloured<f64, D> {
        let filled = self.filled[i];
        Coloured {
            volume: particles.volume(i),
            filled,
            open: if filled < self.open { 1.0 } else { 0.0 },
        }
    }

    #[inline(always)]
    fn pair<R: Real>(
        &self,
        i: &Coloured<R, D>,
        j: &Coloured<R, D>,
        ij: &Pair<R, D>,
        sum: &mut Facing<R, D>,
    ) {
        (sum.inward).add(ij.grad_w * j.volume, j.filled - i.filled, &ij.offset);
        let near = ij
            .distance_squared
            .less(ij.w.literal(self.near * self.near));
        sum.open = sum.open + R::select(near, j.open, ij.w.zero());
    }
}
