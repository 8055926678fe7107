//! Cohesion, over a range H that is longer than the smoothing length:
//!
//! - rho^H_i = sum_j m_j W^H_ij
//! - dv_i/dt = 2 a sum_j m_j grad W^H_ij              (Sigalotti, Daza and Donoso, eq. 9)
//! - U_i     = -a rho^H_i
//!
//! The force is that of the energy -a/2 sum_ij m_i m_j W^H_ij, twice: as -a rho^2 is the pressure
//! of the energy -a rho. The rate of U, a sum_j m_j (v_j - v_i) . grad W^H_ij, is half of what
//! eq. 10 prints, with which energy is not conserved; taken from places it needs no march.

use crate::particles::Particles;
use crate::real::Real;
use crate::record;
use crate::term::{Pair, PairTerm};
use crate::vector::Vector;

/// Sums to density over the range H, and the gradient that pulls.
#[derive(Clone, Copy, Debug)]
pub struct Cohesion;

record! {
    /// A density and a gradient.
    pub struct Surrounding<R, D> {
        /// rho^H, kg/m^3
        density: R,
        /// sum_j m_j grad W^H_ij, kg/m^4
        gradient: Vector<R, D>,
    }
}

impl<const D: usize> PairTerm<D> for Cohesion {
    type Record<R: Real> = R;
    type Sum<R: Real> = Surrounding<R, D>;
    const OFTEN: bool = false;

    fn record(&self, particles: &Particles<D>, i: usize) -> f64 {
        particles.mass[i]
    }

    #[inline(always)]
    fn pair<R: Real>(&self, _: &R, mass: &R, ij: &Pair<R, D>, sum: &mut Surrounding<R, D>) {
        sum.density = sum.density + *mass * ij.w;
        sum.gradient += ij.grad_w * *mass;
    }
}
