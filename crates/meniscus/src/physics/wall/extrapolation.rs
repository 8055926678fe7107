//! What the fluid near a wall particle is like: the sums of Adami, Hu and Adams, eq. 22 and 27.

use crate::particles::Particles;
use crate::real::Real;
use crate::record;
use crate::term::{Pair, PairTerm};
use crate::vector::Vector;

use super::bodies::WallBodies;

/// Sums over the fluid alone.
#[derive(Clone, Copy, Debug)]
pub struct Extrapolation<'a> {
    /// What is no fluid.
    pub walls: WallBodies<'a>,
}

record! {
    /// What is extrapolated; all zero for a wall.
    pub struct Source<R, D> {
        /// 1 for fluid
        weight: R,
        /// V, m^D
        volume: R,
        /// p, Pa
        pressure: R,
        /// rho, kg/m^3
        density: R,
        /// v, m/s
        velocity: Vector<R, D>,
    }
}

record! {
    /// Sums over the fluid near a particle.
    pub struct Neighbourhood<R, D> {
        /// sum W, 1/m^D
        weight: R,
        /// sum p W
        pressure: R,
        /// sum rho x_wf W
        head: Vector<R, D>,
        /// sum x_wf W
        arm: Vector<R, D>,
        /// sum v W
        velocity: Vector<R, D>,
        /// sum V grad W, 1/m
        filling: Vector<R, D>,
    }
}

impl<const D: usize> PairTerm<D> for Extrapolation<'_> {
    type Record<R: Real> = Source<R, D>;
    type Sum<R: Real> = Neighbourhood<R, D>;

    fn record(&self, particles: &Particles<D>, i: usize) -> Source<f64, D> {
        let wall = self.walls.hold(particles.body[i]);
        let weight = if wall { 0.0 } else { 1.0 };
        Source {
            weight,
            volume: weight * particles.volume(i),
            pressure: weight * particles.pressure[i],
            density: weight * particles.density[i],
            velocity: particles.velocity[i] * weight,
        }
    }

    #[inline(always)]
    fn pair<R: Real>(
        &self,
        _: &Source<R, D>,
        j: &Source<R, D>,
        ij: &Pair<R, D>,
        sum: &mut Neighbourhood<R, D>,
    ) {
        sum.weight = sum.weight + j.weight * ij.w;
        sum.pressure = sum.pressure + j.pressure * ij.w;
        sum.head += ij.offset * (j.density * ij.w);
        sum.arm += ij.offset * (j.weight * ij.w);
        sum.velocity += j.velocity * ij.w;
        sum.filling += ij.grad_w * j.volume;
    }
}
