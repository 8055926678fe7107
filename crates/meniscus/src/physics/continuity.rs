//! The continuity equation:
//!
//! D rho_i / Dt = rho_i sum_j V_j (v_i - v_j) . grad W_ij,   V = m / rho
//!
//! Jancik and Hyhlik, eq. 2; or with V_i in place of V_j, that is
//! D rho_i / Dt = m_i sum_j (v_i - v_j) . grad W_ij, Ott and Schnetter (2003),
//! physics/0303112; Qiang, Chen and Gao, eq. 8: by the number of neighbours, whatever
//! their volume. Both are exact for a rigid motion, also at a free surface. With the
//! velocity gradient corrected as in [`super::surface_tension::gradient`] (CSPM; Chen, Beraun and
//! Carney 1999) it is exact for any linear motion, and a free surface is compressed no less
//! than the inside:
//!
//! D rho_i / Dt = -rho_i trace(G_i A_i^-1),   G_i = sum_j V_j (v_j - v_i) grad W_ij,
//! A_i = sum_j V_j (x_j - x_i) grad W_ij

use crate::particles::Particles;
use crate::physics::surface_tension::gradient::{LEAST_FILLING, LEAST_MATRIX};
use crate::physics::surface_tension::matrix::Matrix;
use crate::real::Real;
use crate::record;
use crate::term::{Pair, PairTerm};
use crate::vector::Vector;

record! {
    /// A moving volume.
    pub struct Moving<R, D> {
        /// v, m/s
        velocity: Vector<R, D>,
        /// V, m^D
        volume: R,
    }
}

/// Sums to (1/rho) D rho / Dt, 1/s.
#[derive(Clone, Copy, Debug)]
pub struct Continuity;

impl<const D: usize> PairTerm<D> for Continuity {
    type Record<R: Real> = Moving<R, D>;
    type Sum<R: Real> = R;

    fn record(&self, particles: &Particles<D>, i: usize) -> Moving<f64, D> {
        Moving {
            velocity: particles.velocity[i],
            volume: particles.volume(i),
        }
    }

    #[inline(always)]
    fn pair<R: Real>(&self, i: &Moving<R, D>, j: &Moving<R, D>, ij: &Pair<R, D>, sum: &mut R) {
        let approach = (i.velocity - j.velocity).dot(&ij.offset);
        *sum = approach.mul_add(ij.slope_over_distance * j.volume, *sum);
    }
}

/// The form of Ott and Schnetter: sums to (1/rho) D rho / Dt, 1/s.
#[derive(Clone, Copy, Debug)]
pub struct NumberContinuity;

impl<const D: usize> PairTerm<D> for NumberContinuity {
    type Record<R: Real> = Moving<R, D>;
    type Sum<R: Real> = R;
    const OFTEN: bool = false;

    fn record(&self, particles: &Particles<D>, i: usize) -> Moving<f64, D> {
        Continuity.record(particles, i)
    }

    #[inline(always)]
    fn pair<R: Real>(&self, i: &Moving<R, D>, j: &Moving<R, D>, ij: &Pair<R, D>, sum: &mut R) {
        *sum = *sum + (i.velocity - j.velocity).dot(&ij.grad_w) * i.volume;
    }
}

/// The corrected form: sums to G and A.
#[derive(Clone, Copy, Debug)]
pub struct CorrectedContinuity;

record! {
    /// The gradient of velocity and what it must be divided by.
    pub struct VelocityGradient<R, D> {
        /// G, 1/s
        gradient: Matrix<R, D>,
        /// A
        matrix: Matrix<R, D>,
    }
}

impl<const D: usize> PairTerm<D> for CorrectedContinuity {
    type Record<R: Real> = Moving<R, D>;
    type Sum<R: Real> = VelocityGradient<R, D>;

    fn record(&self, particles: &Particles<D>, i: usize) -> Moving<f64, D> {
        Continuity.record(particles, i)
    }

    #[inline(always)]
    fn pair<R: Real>(
        &self,
        i: &Moving<R, D>,
        j: &Moving<R, D>,
        ij: &Pair<R, D>,
        sum: &mut VelocityGradient<R, D>,
    ) {
        let weighted = ij.grad_w * j.volume;
        sum.gradient
            .add_outer(&(j.velocity - i.velocity), &weighted);
        // x_j - x_i is minus the offset.
        sum.matrix.add_outer(&-ij.offset, &weighted);
    }
}

impl<const D: usize> VelocityGradient<f64, D> {
    /// (1/rho) D rho / Dt, 1/s, as [`Continuity`] finds it.
    pub fn plain(&self) -> f64 {
        -self.gradient.trace()
    }

    /// (1/rho) D rho / Dt, 1/s; less where so few neighbours are left that it would be mostly
    /// correction.
    pub fn corrected(&self) -> f64 {
        let filling = self.matrix.trace() / D as f64;
        let trust = (filling / LEAST_FILLING).clamp(0.0, 1.0);
        let inverse = self.matrix.inverse(LEAST_MATRIX);
        -trust * self.gradient.trace_of_product(&inverse)
    }
}
