//! The divergence of a stress, with the weight w of a particle, its volume or its mass:
//!
//! sum_j w_j (S_i + S_j) grad W_ij
//!
//! Pairs push each other: momentum is conserved exactly.

use super::surface_tension::matrix::Matrix;
use crate::particles::Particles;
use crate::real::Real;
use crate::record;
use crate::term::{Pair, PairTerm};
use crate::vector::Vector;

/// What particles count by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Weight {
    /// V, m^D: of S in Pa the sum is a force per volume, N/m^3.
    Volume,
    /// m, kg: of S / rho^2 the sum is an acceleration, m/s^2.
    Mass,
}

impl Weight {
    /// That of row `i`.
    pub fn of<const D: usize>(self, particles: &Particles<D>, i: usize) -> f64 {
        match self {
            Weight::Volume => particles.volume(i),
            Weight::Mass => particles.mass[i],
        }
    }
}

/// Sums to the divergence.
#[derive(Clone, Copy, Debug)]
pub struct StressDivergence<'a, const D: usize> {
    /// S of each particle.
    pub stress: &'a [Matrix<f64, D>],
    /// w
    pub weight: Weight,
}

record! {
    /// Weight and stress.
    pub struct Stressed<R, D> {
        /// w
        weight: R,
        /// S
        stress: Matrix<R, D>,
    }
}

impl<const D: usize> PairTerm<D> for StressDivergence<'_, D> {
    type Record<R: Real> = Stressed<R, D>;
    type Sum<R: Real> = Vector<R, D>;
    const OFTEN: bool = false;

    fn record(&self, particles: &Particles<D>, i: usize) -> Stressed<f64, D> {
        Stressed {
            weight: self.weight.of(particles, i),
            stress: self.stress[i],
        }
    }

    #[inline(always)]
    fn pair<R: Real>(
        &self,
        i: &Stressed<R, D>,
        j: &Stressed<R, D>,
        ij: &Pair<R, D>,
        sum: &mut Vector<R, D>,
    ) {
        let weighted = ij.grad_w * j.weight;
        for d in 0..D {
            sum.0[d] = sum.0[d] + (i.stress.0[d] + j.stress.0[d]).dot(&weighted);
        }
    }
}
