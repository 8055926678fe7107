//! The continuity equation:
//!
//! D rho_i / Dt = rho_i sum_j V_j (v_i - v_j) . grad W_ij,   V = m / rho
//!
//! Jancik and Hyhlik, eq. 2; or with V_i in place of V_j, that is
//! D rho_i / Dt = m_i sum_j (v_i - v_j) . grad W_ij, Ott and Schnetter (2003),
//! physics/0303112; Qiang, Chen and Gao, eq. 8: by the number of neighbours, whatever
//! their volume. Both are exact for a rigid motion, also at a free surface. With the
//! velocity gradient corrected ([`super::velocity_gradient`]) it is exact for any linear motion, and a free surface is compressed no less
//! than the inside:
//!
//! D rho_i / Dt = -rho_i trace(G_i A_i^-1),   G_i = sum_j V_j (v_j - v_i) grad W_ij,
//! A_i = sum_j V_j (x_j - x_i) grad W_ij

use crate::particles::Particles;
use crate::physics::surface_tension::curvature::CorrectableDivergence;
use crate::physics::surface_tension::gradient::{LEAST_FILLING, LEAST_MATRIX};
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

/// (1/rho) D rho / Dt, 1/s, as [`Continuity`] finds it, of the sums of
/// [`VelocityGradient`](super::velocity_gradient::VelocityGradient).
pub fn plain<const D: usize>(sum: &CorrectableDivergence<f64, D>) -> f64 {
    -sum.gradient.trace()
}

/// The corrected (1/rho) D rho / Dt, 1/s; less where so few neighbours are left that it would be
/// mostly correction.
pub fn corrected<const D: usize>(sum: &CorrectableDivergence<f64, D>) -> f64 {
    let filling = sum.matrix.trace() / D as f64;
    let trust = (filling / LEAST_FILLING).clamp(0.0, 1.0);
    let inverse = sum.matrix.inverse(LEAST_MATRIX);
    -trust * sum.gradient.trace_of_product(&inverse)
}
