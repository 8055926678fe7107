//! Gradients of velocity and temperature:
//!
//! - G_i      = 1/rho_i sum_j m_j (v_j - v_i) grad W_ij
//! - grad T_i = 1/rho_i sum_j m_j (T_j - T_i) grad W_ij
//!
//! with the density of i. So the sums of [`stress_divergence`](crate::physics::stress_divergence) are their adjoints: the work of the
//! stress is sum_i V_i S_i : G_i, and the viscous part of it is never negative.

use crate::particles::Particles;
use crate::physics::surface_tension::matrix::Matrix;
use crate::real::Real;
use crate::record;
use crate::term::{Pair, PairTerm};
use crate::vector::Vector;

/// Sums to rho times either gradient.
#[derive(Clone, Copy, Debug)]
pub struct Gradients<'a, const D: usize> {
    /// v, m/s
    pub velocity: &'a [Vector<f64, D>],
    /// T, K
    pub temperature: &'a [f64],
}

record! {
    /// Mass, velocity, temperature.
    pub struct Warm<R, D> {
        /// kg
        mass: R,
        /// m/s
        velocity: Vector<R, D>,
        /// K
        temperature: R,
    }
}

record! {
    /// Density times gradients.
    pub struct GradientSums<R, D> {
        /// rho G, kg/(m^3 s); rows are components of velocity
        velocity: Matrix<R, D>,
        /// rho grad T, K kg/m^4
        temperature: Vector<R, D>,
    }
}

impl<const D: usize> PairTerm<D> for Gradients<'_, D> {
    type Record<R: Real> = Warm<R, D>;
    type Sum<R: Real> = GradientSums<R, D>;
    const OFTEN: bool = false;

    fn record(&self, particles: &Particles<D>, i: usize) -> Warm<f64, D> {
        Warm {
            mass: particles.mass[i],
            velocity: self.velocity[i],
            temperature: self.temperature[i],
        }
    }

    #[inline(always)]
    fn pair<R: Real>(
        &self,
        i: &Warm<R, D>,
        j: &Warm<R, D>,
        ij: &Pair<R, D>,
        sum: &mut GradientSums<R, D>,
    ) {
        let weighted = ij.grad_w * j.mass;
        sum.velocity
            .add_outer(&(j.velocity - i.velocity), &weighted);
        sum.temperature += weighted * (j.temperature - i.temperature);
    }
}
