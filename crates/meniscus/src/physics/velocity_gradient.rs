//! The gradient of velocity, and what corrects it (CSPM; Chen, Beraun and Carney 1999):
//!
//! - G_i = sum_j V_j (v_j - v_i) grad W_ij
//! - A_i = sum_j V_j (x_j - x_i) grad W_ij
//!
//! G A^-1 is exact for any linear motion, up to a free surface.

use super::continuity::{Continuity, Moving};
use super::surface_tension::curvature::CorrectableDivergence;
use crate::particles::Particles;
use crate::real::Real;
use crate::term::{Pair, PairTerm};

/// Sums to G, 1/s, and A.
#[derive(Clone, Copy, Debug)]
pub struct VelocityGradient;

impl<const D: usize> PairTerm<D> for VelocityGradient {
    type Record<R: Real> = Moving<R, D>;
    type Sum<R: Real> = CorrectableDivergence<R, D>;

    fn record(&self, particles: &Particles<D>, i: usize) -> Moving<f64, D> {
        Continuity.record(particles, i)
    }

    #[inline(always)]
    fn pair<R: Real>(
        &self,
        i: &Moving<R, D>,
        j: &Moving<R, D>,
        ij: &Pair<R, D>,
        sum: &mut CorrectableDivergence<R, D>,
    ) {
        let weighted = ij.grad_w * j.volume;
        sum.gradient
            .add_outer(&(j.velocity - i.velocity), &weighted);
        // x_j - x_i is minus the offset.
        sum.matrix.add_outer(&-weighted, &ij.offset);
    }
}
