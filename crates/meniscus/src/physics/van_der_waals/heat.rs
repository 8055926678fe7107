//! The heat of pressure and viscosity, and conduction (Sigalotti, Daza and Donoso, eq. 4 and 6):
//!
//! - dU_i/dt = sum_j m_j (v_j - v_i) . S_i / rho_i^2 grad W_ij + conduction
//!
//! Each particle takes the work of its own stress, and what motion loses heat gains. Printed is
//! 1/2 sum_j m_j (v_j - v_i) . (S_i / rho_i^2 + S_j / rho_j^2) grad W_ij, the same in all, where a pair shares
//! evenly: then a cold particle loses the work of a hot one, and goes below zero kelvin as the tips
//! of a drawn-out drop expand; from its own it cannot. Conduction is one of
//!
//! - sum_j m_j 2 kappa / (rho_i rho_j) (T_i - T_j) r . grad W_ij / r^2             between pairs
//! - -sum_j m_j (q_i / rho_i^2 + q_j / rho_j^2) . grad W_ij, q = -kappa grad T    as printed
//!
//! A kick changes the velocity while it works. Its heat is that of the mean velocity, which
//! differs from v by a multiple of the acceleration: the second sum has that in place of velocity.

use crate::particles::Particles;
use crate::physics::stress_divergence::Stressed;
use crate::physics::surface_tension::matrix::Matrix;
use crate::real::Real;
use crate::record;
use crate::term::{Pair, PairTerm};
use crate::vector::Vector;

/// Sums to heat.
#[derive(Clone, Copy, Debug)]
pub struct Heat<'a, const D: usize> {
    /// S / rho^2, Pa m^6/kg^2
    pub stress: &'a [Matrix<f64, D>],
    /// q / rho^2, W m^4/kg^2; zero where pairs exchange heat
    pub flux: &'a [Vector<f64, D>],
    /// v, m/s
    pub velocity: &'a [Vector<f64, D>],
    /// a, m/s^2
    pub acceleration: &'a [Vector<f64, D>],
    /// T, K
    pub temperature: &'a [f64],
    /// kappa where pairs exchange heat, W/(m K); otherwise zero
    pub conductivity: f64,
}

record! {
    /// What a particle warms others by.
    pub struct Warming<R, D> {
        /// Mass and stress
        stressed: Stressed<R, D>,
        /// 1/rho, m^3/kg
        specific_volume: R,
        /// K
        temperature: R,
        /// m/s
        velocity: Vector<R, D>,
        /// m/s^2
        acceleration: Vector<R, D>,
        /// q / rho^2
        flux: Vector<R, D>,
    }
}

record! {
    /// Heat, and what a change of velocity adds to it.
    pub struct Warmth<R, D> {
        /// dU/dt, W/kg
        heat: R,
        /// d^2U/dt^2 by acceleration, W/(kg s)
        gain: R,
    }
}

impl<const D: usize> PairTerm<D> for Heat<'_, D> {
    type Record<R: Real> = Warming<R, D>;
    type Sum<R: Real> = Warmth<R, D>;
    const OFTEN: bool = false;

    fn record(&self, particles: &Particles<D>, i: usize) -> Warming<f64, D> {
        Warming {
            stressed: Stressed {
                weight: particles.mass[i],
                stress: self.stress[i],
            },
            specific_volume: 1.0 / particles.density[i],
            temperature: self.temperature[i],
            velocity: self.velocity[i],
            acceleration: self.acceleration[i],
            flux: self.flux[i],
        }
    }

    #[inline(always)]
    fn pair<R: Real>(
        &self,
        i: &Warming<R, D>,
        j: &Warming<R, D>,
        ij: &Pair<R, D>,
        sum: &mut Warmth<R, D>,
    ) {
        let weighted = ij.grad_w * j.stressed.weight;
        let mut push = weighted;
        for d in 0..D {
            push.0[d] = i.stressed.stress.0[d].dot(&weighted);
        }
        let exchange = (i.temperature - j.temperature)
            * (i.specific_volume * j.specific_volume)
            * ij.slope_over_distance
            * (2.0 * self.conductivity);
        let flow = exchange - (i.flux + j.flux).dot(&ij.grad_w);
        let work = (j.velocity - i.velocity).dot(&push);
        sum.heat = sum.heat + work + flow * j.stressed.weight;
        sum.gain = sum.gain + (j.acceleration - i.acceleration).dot(&push);
    }
}
