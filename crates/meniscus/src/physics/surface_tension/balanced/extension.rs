//! Curvature off the surface, and what the force needs of it:
//!
//! - a weighted mean, sum_j w_j f_j W_ij / sum_j w_j W_ij (Shepard)
//! - for all particles at once: sum_j V_j f_j W_ij, sum_j V_j (f_j - f_i) grad W_ij, and
//! - the push sum_j V_j (b - r_ij)+ x_ij / r_ij of neighbours nearer than b

use super::super::gradient::{Gradient, Valued};
use crate::particles::Particles;
use crate::real::Real;
use crate::record;
use crate::term::{Pair, PairTerm};
use crate::vector::Vector;

/// Sums to the weight, and to the weighted values.
#[derive(Clone, Copy, Debug)]
pub struct Mean<'a> {
    /// w of each particle.
    pub weight: &'a [f64],
    /// f of each particle.
    pub values: &'a [f64],
}

impl<const D: usize> PairTerm<D> for Mean<'_> {
    type Record<R: Real> = (R, R);
    type Sum<R: Real> = (R, R);
    const OFTEN: bool = false;

    fn record(&self, _: &Particles<D>, i: usize) -> (f64, f64) {
        (self.weight[i], self.weight[i] * self.values[i])
    }

    #[inline(always)]
    fn pair<R: Real>(&self, _: &(R, R), j: &(R, R), ij: &Pair<R, D>, sum: &mut (R, R)) {
        sum.0 = j.0.mul_add(ij.w, sum.0);
        sum.1 = j.1.mul_add(ij.w, sum.1);
    }
}

/// Sums to what a column of values is like about each particle, and to the push.
#[derive(Clone, Copy, Debug)]
pub struct Extension<'a> {
    /// f of each particle.
    pub values: &'a [f64],
    /// b, m
    pub rest: f64,
}

record! {
    /// Sums about a particle.
    pub struct Extended<R, D> {
        /// sum V f W
        value: R,
        /// sum V (f - f_i) grad W
        gradient: Vector<R, D>,
        /// m^(D+1)
        push: Vector<R, D>,
    }
}

impl<const D: usize> PairTerm<D> for Extension<'_> {
    type Record<R: Real> = Valued<R, D>;
    type Sum<R: Real> = Extended<R, D>;

    fn record(&self, particles: &Particles<D>, i: usize) -> Valued<f64, D> {
        Gradient {
            values: self.values,
        }
        .record(particles, i)
    }

    #[inline(always)]
    fn pair<R: Real>(
        &self,
        i: &Valued<R, D>,
        j: &Valued<R, D>,
        ij: &Pair<R, D>,
        sum: &mut Extended<R, D>,
    ) {
        sum.value = (j.volume * j.value).mul_add(ij.w, sum.value);
        sum.gradient += ij.grad_w * (j.volume * (j.value - i.value));
        let distance = ij.distance_squared.max(ij.w.tiny()).sqrt();
        let nearer = (distance.literal(self.rest) - distance).positive();
        sum.push += ij.offset * (nearer * j.volume / distance);
    }
}
