//! From normals and curvature to a force.
//!
//! The force f = s sigma kappa n is no sum of pairs that push each other: where
//! particles are disordered, the forces on a closed surface do not quite cancel. Two ways out:
//!
//! - balanced: what is left is spread over the surface, as |n|, and taken off. Linear
//!   momentum of the whole is then conserved to rounding.
//! - stress, after Lafaurie et al. (1994), J. Comput. Phys. 113, 134:
//!   f_i = sum_j V_j (T_i + T_j) grad W_ij,  T = s sigma (|n| 1 - n n / |n|),
//!   antisymmetric pair by pair. No curvature is needed. On a flat layer it pulls
//!   with s sigma sum |n| V A_tt along the surface, A_tt = sum_j V_j (x_j - x_i)_t (grad W_ij)_t,
//!   which sets its strength. T pulls particles together along the surface: between two
//!   fluids under a background pressure they keep their distance, at a free
//!   surface, where nothing presses, they clump.

use super::super::surface::Surface;
use crate::particles::Particles;
use crate::real::Real;
use crate::record;
use crate::term::{Pair, PairTerm};
use crate::vector::Vector;

/// How curvature and normals become a force.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// s sigma kappa n, as printed; linear momentum is conserved on a symmetric lattice only.
    Force,
    /// The same, less what it adds up to: conserves linear momentum of the whole.
    Balanced,
    /// The divergence of a stress, by pairs that push each other: conserves linear momentum.
    Stress,
}

/// Takes what the forces add up to off the surface.
pub(super) fn balance<const D: usize>(particles: &Particles<D>, surface: &mut Surface<D>) {
    let at_surface = |i: usize, surface: &Surface<D>| {
        if surface.curvature[i] == 0.0 {
            0.0
        } else {
            surface.normal[i].norm()
        }
    };
    let whole: f64 = (0..particles.len())
        .map(|i| at_surface(i, surface) * particles.volume(i))
        .sum();
    if whole > 0.0 {
        let excess = surface.net_force * (1.0 / whole);
        for i in 0..particles.len() {
            let share = at_surface(i, surface);
            surface.force[i] -= excess * share;
        }
    }
}

/// Sums to the force per volume of the stress, N/m^3.
#[derive(Debug)]
pub struct Stress<'a, F, const D: usize> {
    /// n of each particle, 1/m.
    pub normal: &'a [Vector<f64, D>],
    /// Normals shorter than this cannot be relied on, 1/m.
    pub shortest: f64,
    /// s sigma of each particle, N/m.
    pub factor: &'a F,
}

impl<F, const D: usize> Clone for Stress<'_, F, D> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<F, const D: usize> Copy for Stress<'_, F, D> {}

record! {
    /// A stress sqrt(t t) 1 - t t / sqrt(t t), by its one vector t, and a volume.
    pub struct Tense<R, D> {
        /// s sigma n, N/m^2
        tension: Vector<R, D>,
        /// 1 / |t|, m^2/N; zero without tension
        inverse: R,
        /// V, m^D
        volume: R,
    }
}

impl<F: Fn(usize) -> f64 + Sync, const D: usize> PairTerm<D> for Stress<'_, F, D> {
    type Record<R: Real> = Tense<R, D>;
    type Sum<R: Real> = Vector<R, D>;
    const OFTEN: bool = false;

    fn record(&self, particles: &Particles<D>, i: usize) -> Tense<f64, D> {
        let tension = self.normal[i] * (self.factor)(i);
        let acts = self.normal[i].norm() >= self.shortest && tension.norm() > 0.0;
        Tense {
            tension: if acts { tension } else { Vector::ZERO },
            inverse: if acts { 1.0 / tension.norm() } else { 0.0 },
            volume: particles.volume(i),
        }
    }

    #[inline(always)]
    fn pair<R: Real>(
        &self,
        i: &Tense<R, D>,
        j: &Tense<R, D>,
        ij: &Pair<R, D>,
        sum: &mut Vector<R, D>,
    ) {
        let gradient = ij.grad_w * j.volume;
        let across = i.tension.norm_squared() * i.inverse + j.tension.norm_squared() * j.inverse;
        *sum += gradient * across;
        *sum -= i.tension * (i.tension.dot(&gradient) * i.inverse);
        *sum -= j.tension * (j.tension.dot(&gradient) * j.inverse);
    }
}
