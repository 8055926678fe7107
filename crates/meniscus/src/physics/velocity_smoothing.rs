//! XSPH: particles move with the velocity of their surroundings,
//!
//! d x_i / dt = v_i - epsilon sum_j m_j / rho_ij (v_i - v_j) W_ij,   rho_ij = (rho_i + rho_j) / 2
//!
//! Monaghan (1992), Annu. Rev. Astron. Astrophys. 30, 543; Qiang, Chen and Gao,
//! eq. 9. It moves places alone: momentum and continuity see the velocities as
//! they are. The sum over all masses of the shift is zero.

use crate::particles::Particles;
use crate::real::Real;
use crate::record;
use crate::term::{Pair, PairTerm};
use crate::vector::Vector;

/// Sums to the difference between the velocity that a particle moves with and its own, m/s.
#[derive(Clone, Copy, Debug)]
pub struct VelocitySmoothing {
    /// epsilon, from 0 to 1; the paper has 0.3.
    pub strength: f64,
}

record! {
    /// What is smoothed.
    pub struct Smoothable<R, D> {
        /// v, m/s
        velocity: Vector<R, D>,
        /// m, kg
        mass: R,
        /// rho, kg/m^3
        density: R,
    }
}

impl<const D: usize> PairTerm<D> for VelocitySmoothing {
    type Record<R: Real> = Smoothable<R, D>;
    type Sum<R: Real> = Vector<R, D>;
    const OFTEN: bool = false;

    fn record(&self, particles: &Particles<D>, i: usize) -> Smoothable<f64, D> {
        Smoothable {
            velocity: particles.velocity[i],
            mass: particles.mass[i],
            density: particles.density[i],
        }
    }

    #[inline(always)]
    fn pair<R: Real>(
        &self,
        i: &Smoothable<R, D>,
        j: &Smoothable<R, D>,
        ij: &Pair<R, D>,
        sum: &mut Vector<R, D>,
    ) {
        let share = j.mass * (2.0 * self.strength) / (i.density + j.density);
        *sum += (j.velocity - i.velocity) * (share * ij.w);
    }
}
