//! Morris's viscous force ([`super::viscosity`]) of what the gradient of velocity leaves, for
//! [`super::viscous_stress`].

use super::surface_tension::matrix::Matrix;
use crate::particles::Particles;
use crate::real::Real;
use crate::record;
use crate::term::{Pair, PairTerm};
use crate::vector::Vector;

record! {
    /// A particle and its gradient of velocity.
    pub struct Rest<R, D> {
        /// V
        volume: R,
        /// mu
        viscosity: R,
        /// v
        velocity: Vector<R, D>,
        /// dv_d/dx_e, 1/s
        gradient: Matrix<R, D>,
    }
}

/// Sums to a force per volume, N/m^3.
#[derive(Clone, Copy, Debug)]
pub struct ViscousRest<'a, const D: usize> {
    /// Of all rows.
    pub rest: &'a [Rest<f64, D>],
}

impl<const D: usize> PairTerm<D> for ViscousRest<'_, D> {
    type Record<R: Real> = Rest<R, D>;
    type Sum<R: Real> = Vector<R, D>;

    fn record(&self, _: &Particles<D>, i: usize) -> Rest<f64, D> {
        self.rest[i]
    }

    #[inline(always)]
    fn pair<R: Real>(
        &self,
        i: &Rest<R, D>,
        j: &Rest<R, D>,
        ij: &Pair<R, D>,
        sum: &mut Vector<R, D>,
    ) {
        let along = ij.offset.dot(&ij.grad_w);
        let strength = j.volume * (i.viscosity + j.viscosity) * along
            / (ij.distance_squared + ij.distance_squared.tiny());
        for d in 0..D {
            let linear = (i.gradient.0[d] + j.gradient.0[d]).dot(&ij.offset) * 0.5;
            sum.0[d] = sum.0[d] + strength * (i.velocity.0[d] - j.velocity.0[d] - linear);
        }
    }
}
