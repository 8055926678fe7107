//! The sums over pairs.

use super::{Attraction, Pairwise};
use crate::particles::Particles;
use crate::real::Real;
use crate::record;
use crate::term::{Pair, PairTerm};
use crate::vector::Vector;

/// Sums to sum_j V_j grad W_ij.
#[derive(Clone, Copy, Debug)]
pub(super) struct VolumeGradient;

impl<const D: usize> PairTerm<D> for VolumeGradient {
    type Record<R: Real> = R;
    type Sum<R: Real> = Vector<R, D>;
    const OFTEN: bool = false;

    fn record(&self, particles: &Particles<D>, i: usize) -> f64 {
        particles.volume(i)
    }

    #[inline(always)]
    fn pair<R: Real>(&self, _: &R, volume: &R, ij: &Pair<R, D>, sum: &mut Vector<R, D>) {
        *sum += ij.grad_w * *volume;
    }
}

record! {
    /// What a fluid's particle brings to the pressure of a wall.
    pub struct Drawn<R, D> {
        /// 1 for a fluid, 0 for a wall
        is_fluid: R,
        /// rho_f a_f, N/m^3
        force: Vector<R, D>,
    }
}

/// Sums to sum_f rho_f a_f . x_wf W_wf, and sum_f W_wf.
#[derive(Clone, Copy, Debug)]
pub(super) struct Head<'a, const D: usize> {
    pub model: Pairwise,
    pub charges: &'a [Charge],
    /// Of the forces that the wall is to balance.
    pub pulled: &'a [Pulled<f64, D>],
}

impl<const D: usize> PairTerm<D> for Head<'_, D> {
    type Record<R: Real> = Drawn<R, D>;
    type Sum<R: Real> = (R, R);
    const OFTEN: bool = false;

    fn record(&self, particles: &Particles<D>, i: usize) -> Drawn<f64, D> {
        let is_fluid = self.charges[i].is_fluid;
        let share = self.model.share(particles.mass[i]);
        Drawn {
            is_fluid,
            force: self.pulled[i].acceleration * share * (is_fluid * particles.density[i]),
        }
    }

    #[inline(always)]
    fn pair<R: Real>(&self, _: &Drawn<R, D>, j: &Drawn<R, D>, ij: &Pair<R, D>, sum: &mut (R, R)) {
        sum.0 = sum.0 + j.force.dot(&ij.offset) * ij.w;
        sum.1 = sum.1 + j.is_fluid * ij.w;
    }
}

/// What a particle brings to the forces.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Charge {
    /// Root of G; zero for a wall.
    pub cohesion: f64,
    /// 1 for a fluid, 0 for a wall.
    pub is_fluid: f64,
    /// B Psi / m of a wall; zero for a fluid.
    pub wetting: f64,
    /// rho_0, kg/m^3
    pub rest_density: f64,
}

record! {
    /// What a pair reads.
    pub struct Charged<R, D> {
        /// m, kg
        mass: R,
        /// rho, kg/m^3
        density: R,
        /// rho_0, kg/m^3
        rest_density: R,
        /// Root of G
        cohesion: R,
        /// 1 or 0
        is_fluid: R,
        /// B Psi / m
        wetting: R,
        /// n
        normal: Vector<R, D>,
    }
}

record! {
    /// What pairs add up to.
    pub struct Pulled<R, D> {
        /// sum_j F_ij / m_i, m/s^2
        acceleration: Vector<R, D>,
        /// sum_j r_ij . F_ij / m_i, m^2/s^2
        virial: R,
    }
}

/// Sums to F / m.
#[derive(Clone, Copy, Debug)]
pub(super) struct PairwiseTerm<'a, const D: usize> {
    pub model: Pairwise,
    /// s, m
    pub support: f64,
    /// Whether forces within the fluid act, or adhesion alone.
    pub cohesion: bool,
    /// Whether K acts.
    pub deficiency: bool,
    /// The factors of K (n_i - n_j) and of m_j K (n_i - n_j), over G.
    pub curvature: (f64, f64),
    pub charges: &'a [Charge],
    /// n; nothing where there is no curvature force.
    pub normals: &'a [Vector<f64, D>],
}

impl<const D: usize> PairTerm<D> for PairwiseTerm<'_, D> {
    type Record<R: Real> = Charged<R, D>;
    type Sum<R: Real> = Pulled<R, D>;
    const OFTEN: bool = false;

    fn record(&self, particles: &Particles<D>, i: usize) -> Charged<f64, D> {
        let charge = self.charges[i];
        Charged {
            mass: particles.mass[i],
            density: particles.density[i],
            rest_density: charge.rest_density,
            cohesion: if self.cohesion { charge.cohesion } else { 0.0 },
            is_fluid: charge.is_fluid,
            wetting: charge.wetting,
            normal: self.normals.get(i).copied().unwrap_or_default(),
        }
    }

    #[inline(always)]
    fn pair<R: Real>(
        &self,
        i: &Charged<R, D>,
        j: &Charged<R, D>,
        ij: &Pair<R, D>,
        sum: &mut Pulled<R, D>,
    ) {
        let distance = ij.distance_squared.sqrt();
        let mut strength = i.cohesion * j.cohesion;
        if self.deficiency {
            strength = strength * ((i.rest_density + j.rest_density) / (i.density + j.density));
        }
        let wetting = i.is_fluid * j.wetting + i.wetting * j.is_fluid;
        let attraction = strength * self.model.attraction::<R, D>(distance, self.support)
            + wetting * self.model.adhesion::<R, D>(distance, self.support);
        // A particle has no direction from itself.
        let apart = distance.max(distance.literal(1e-9 * self.support));
        let mut force = ij.offset * -(attraction * j.mass / apart);
        let (alone, by_mass) = self.curvature;
        if alone != 0.0 || by_mass != 0.0 {
            let within = distance.less(distance.literal(self.support));
            let factor = strength * (j.mass * by_mass + alone);
            let factor = R::select(within, factor, factor.zero());
            force += (i.normal - j.normal) * -factor;
        }
        sum.acceleration += force;
        sum.virial = sum.virial + ij.offset.dot(&force);
    }
}
