//! What shifts of particles do to their density.
//!
//! A particle that is shifted takes its density along, and where shifts s widen the distances of particles it falls:
//!
//! rho_i -> rho_i (1 - div S_i),   div S_i = sum_j V_j (S_j - S_i) . grad W_ij / (1/D sum_j V_j x_ji . grad W_ij)
//!
//! (divided by 0.4 at least), with S_i = sum_j V_j s_j W_ij / sum_j V_j W_ij the mean of shifts around, zero for walls. Of the mean, since shifts themselves go
//! down the slope of the very sums that density is of: the sum with s_j is negative for whatever shifts that put particles in
//! order, though they leave the volume as it is, and drops shrink.

use crate::particles::Particles;
use crate::physics::wall::WallBodies;
use crate::real::Real;
use crate::record;
use crate::term::{Pair, PairTerm};
use crate::vector::Vector;

/// Least of what a divergence is divided by: the filling of a kernel that is 1 inside.
const LEAST_FILLING: f64 = 0.4;

record! {
    /// Volume, and its product with a shift; or sums of both.
    pub struct Shifted<R, D> {
        /// V, m^D; sum V W
        volume: R,
        /// V s, m^(D + 1); sum V s W, m
        shift: Vector<R, D>,
    }
}

/// Sums to what the mean shift around a particle is a ratio of.
#[derive(Clone, Copy, Debug)]
pub struct MeanShift<'a, const D: usize> {
    /// s of each particle, m.
    pub shifts: &'a [Vector<f64, D>],
}

impl<const D: usize> PairTerm<D> for MeanShift<'_, D> {
    type Record<R: Real> = Shifted<R, D>;
    type Sum<R: Real> = Shifted<R, D>;
    const OFTEN: bool = false;

    fn record(&self, particles: &Particles<D>, i: usize) -> Shifted<f64, D> {
        let volume = particles.volume(i);
        Shifted {
            volume,
            shift: self.shifts[i] * volume,
        }
    }

    #[inline(always)]
    fn pair<R: Real>(
        &self,
        _: &Shifted<R, D>,
        j: &Shifted<R, D>,
        ij: &Pair<R, D>,
        sum: &mut Shifted<R, D>,
    ) {
        sum.volume = sum.volume + j.volume * ij.w;
        sum.shift += j.shift * ij.w;
    }
}

/// Sums to D times the filling of the kernel, and to that filling times div S.
#[derive(Clone, Copy, Debug)]
pub struct Widening<'a, const D: usize> {
    /// Sums of [`MeanShift`].
    pub around: &'a [Shifted<f64, D>],
    /// What is no liquid.
    pub walls: WallBodies<'a>,
}

impl<const D: usize> Widening<'_, D> {
    /// The factor on the density of a particle with these sums.
    pub fn thinned((filling, divergence): (f64, f64)) -> f64 {
        1.0 - divergence / (filling / D as f64).max(LEAST_FILLING)
    }
}

impl<const D: usize> PairTerm<D> for Widening<'_, D> {
    /// V and S.
    type Record<R: Real> = Shifted<R, D>;
    type Sum<R: Real> = (R, R);
    const OFTEN: bool = false;

    fn record(&self, particles: &Particles<D>, i: usize) -> Shifted<f64, D> {
        let around = &self.around[i];
        let is_wall = self.walls.hold(particles.body[i]);
        Shifted {
            volume: particles.volume(i),
            shift: match is_wall || around.volume == 0.0 {
                true => Vector::ZERO,
                false => around.shift * (1.0 / around.volume),
            },
        }
    }

    #[inline(always)]
    fn pair<R: Real>(
        &self,
        i: &Shifted<R, D>,
        j: &Shifted<R, D>,
        ij: &Pair<R, D>,
        sum: &mut (R, R),
    ) {
        sum.0 = sum.0 - j.volume * ij.offset.dot(&ij.grad_w);
        sum.1 = sum.1 + j.volume * (j.shift - i.shift).dot(&ij.grad_w);
    }
}
