//! What energy-conserving forces owe to the change of smoothing lengths (as Springel and Hernquist
//! 2002, MNRAS 333, 649, for h ~ rho^(-1/D); here for adaptive kernel estimation).
//!
//! Let E be an energy that changes with the lengths of pairs, by sum_a m_a s_a drho_a with
//! rho_a = sum_b m_b W(r_ab, h_ab): compression has s = p / rho^2. Then, from h_ab = (h_a + h_b) / 2 and
//! h_a = k h_0 (rho^_a / g)^-epsilon,
//!
//! - zeta_a = 1/m_a dE/dh_a = 1/2 sum_b m_b (s_a + s_b) dW(r_ab, h_ab)/dh_ab
//! - chi_a  = -epsilon / rho^_a (zeta_a h_a - sum_c m_c zeta_c h_c / (N m_a))
//! - a_a    = -sum_b m_b (chi_a + chi_b) grad W(r_ab, h_0)
//!
//! which is to be added to -sum_b m_b (s_a + s_b) grad W(r_ab, h_ab). The sum over c is the change
//! of the geometric mean g. Linear momentum stays exact, since each pair is antisymmetric.

use super::adaptive_smoothing::{AdaptiveSmoothing, Pilot};
use crate::particles::Particles;
use crate::real::Real;
use crate::record;
use crate::smoothing::Smoothing;
use crate::term::{Pair, PairTerm, Sweep, SweepWith};
use crate::vector::Vector;

/// Sums to zeta, J/(kg m).
#[derive(Clone, Copy, Debug)]
pub struct EnergyOfLengths<'a> {
    /// s, J m^D / kg^2.
    pub stress: &'a [f64],
}

record! {
    /// What zeta reads.
    pub struct Stretched<R, D> {
        /// s, J m^D / kg^2
        stress: R,
        /// m, kg
        mass: R,
        /// h, m
        smoothing_length: R,
    }
}

impl<const D: usize> PairTerm<D> for EnergyOfLengths<'_> {
    type Record<R: Real> = Stretched<R, D>;
    type Sum<R: Real> = R;
    const OFTEN: bool = false;

    fn record(&self, particles: &Particles<D>, i: usize) -> Stretched<f64, D> {
        Stretched {
            stress: self.stress[i],
            mass: particles.mass[i],
            smoothing_length: particles.smoothing_length[i],
        }
    }

    #[inline(always)]
    fn pair<R: Real>(
        &self,
        i: &Stretched<R, D>,
        j: &Stretched<R, D>,
        ij: &Pair<R, D>,
        sum: &mut R,
    ) {
        // h dW/dh = -(D W + r dW/dr), and the same for kernels of any multiple of h.
        let dw = ij.w * (D as f64) + ij.slope_over_distance * ij.distance_squared;
        // Twice the mean length cancels the half of zeta.
        let lengths = i.smoothing_length + j.smoothing_length;
        *sum = *sum - j.mass * (i.stress + j.stress) * dw / lengths;
    }
}

/// Sums to the acceleration by chi, m/s^2.
#[derive(Clone, Copy, Debug)]
pub struct LengthForce<'a> {
    /// chi, J m^D / kg^2.
    pub stress: &'a [f64],
}

impl<const D: usize> PairTerm<D> for LengthForce<'_> {
    type Record<R: Real> = (R, R);
    type Sum<R: Real> = Vector<R, D>;
    const OFTEN: bool = false;

    fn record(&self, particles: &Particles<D>, i: usize) -> (f64, f64) {
        (self.stress[i], particles.mass[i])
    }

    #[inline(always)]
    fn pair<R: Real>(&self, i: &(R, R), j: &(R, R), ij: &Pair<R, D>, sum: &mut Vector<R, D>) {
        let ((own, _), (stress, mass)) = (*i, *j);
        *sum = sum.add_scaled(ij.grad_w, -(mass * (own + stress)));
    }
}

/// The grad-h terms of a step: energies first, then their force.
#[derive(Debug, Default)]
pub(crate) struct GradH<const D: usize> {
    /// zeta of all energies so far, then chi.
    stress: Vec<f64>,
    zeta: Vec<f64>,
    force: Vec<Vector<f64, D>>,
}

impl<const D: usize> GradH<D> {
    /// No energy yet.
    pub(crate) fn begin(&mut self, particles: &Particles<D>) {
        self.stress.clear();
        self.stress.resize(particles.len(), 0.0);
    }

    /// Adds an energy with this s (J m^D / kg^2) of each row, over the pairs that `sweep` sums.
    pub(crate) fn add_energy(
        &mut self,
        sweep: &mut impl Sweep<D>,
        particles: &Particles<D>,
        stress: &[f64],
    ) {
        let term = EnergyOfLengths { stress };
        sweep.sweep(&term, particles, |_| true, &mut self.zeta);
        for (sum, zeta) in self.stress.iter_mut().zip(&self.zeta) {
            *sum += zeta;
        }
    }

    /// Turns zeta into chi, and adds its acceleration, m/s^2.
    pub(crate) fn accelerate(
        &mut self,
        model: &AdaptiveSmoothing,
        smoothing_length: f64,
        pilot: &Pilot,
        sweep: &mut impl SweepWith<D>,
        particles: &Particles<D>,
        acceleration: &mut [Vector<f64, D>],
    ) {
        let Particles {
            mass,
            smoothing_length: h,
            ..
        } = particles;
        let rows = particles.len();
        let of_all: f64 = (0..rows).map(|c| mass[c] * self.stress[c] * h[c]).sum();
        for a in 0..rows {
            let share = of_all / (rows as f64 * mass[a]);
            let zeta_h = self.stress[a] * h[a];
            self.stress[a] = -model.epsilon / pilot.density[a] * (zeta_h - share);
        }
        let term = LengthForce {
            stress: &self.stress,
        };
        let constant = Smoothing::Constant(smoothing_length);
        sweep.sweep_with(constant, &term, particles, |_| true, &mut self.force);
        for (a, force) in acceleration.iter_mut().zip(&self.force) {
            *a += *force;
        }
    }
}
