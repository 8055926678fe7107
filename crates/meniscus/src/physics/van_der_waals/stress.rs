//! The force of the stress (Sigalotti, Daza and Donoso, eq. 3 and 5):
//!
//! - S       = -p I + eta (G + G^T) + (zeta - 2/D eta) trace(G) I
//! - dv_i/dt = sum_j m_j (S_i / rho_i^2 + S_j / rho_j^2) grad W_ij
//!
//! with p the repulsive part of the pressure alone. Pairs push each other: momentum is
//! conserved exactly.

use crate::particles::Particles;
use crate::physics::surface_tension::matrix::Matrix;
use crate::real::Real;
use crate::record;
use crate::term::{Pair, PairTerm};
use crate::vector::Vector;

/// Sums to acceleration, m/s^2.
#[derive(Clone, Copy, Debug)]
pub struct Stress<'a, const D: usize> {
    /// S / rho^2, Pa m^6/kg^2
    pub stress: &'a [Matrix<f64, D>],
}

record! {
    /// Mass and stress.
    pub struct Stressed<R, D> {
        /// kg
        mass: R,
        /// S / rho^2
        stress: Matrix<R, D>,
    }
}

impl<const D: usize> PairTerm<D> for Stress<'_, D> {
    type Record<R: Real> = Stressed<R, D>;
    type Sum<R: Real> = Vector<R, D>;
    const OFTEN: bool = false;

    fn record(&self, particles: &Particles<D>, i: usize) -> Stressed<f64, D> {
        Stressed {
            mass: particles.mass[i],
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
        let weighted = ij.grad_w * j.mass;
        for d in 0..D {
            sum.0[d] = sum.0[d] + (i.stress.0[d] + j.stress.0[d]).dot(&weighted);
        }
    }
}
