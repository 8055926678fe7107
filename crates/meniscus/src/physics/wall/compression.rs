//! How a wall compresses the fluid that moves against it.
//!
//! The sum of continuity over a wall's particles, with the wall's own velocity, finds half of the
//! volume that the wall takes from the fluid. The other half goes with the pressure of the wall's
//! particles: that is the fluid's, by eq. 27 ([`super`]), so what it does in work must go
//! into the compression of the very particles that it was taken from:
//!
//! D rho_f / Dt += rho_f / V_f sum_w (W_fw / sum_k W_kw) V_w sum_k V_k (v_k - v_w) . grad W_kw
//!
//! over wall particles w and their fluid neighbours k. It is the adjoint of eq. 27: with it the
//! power of a wall's pressure is the rate of elastic energy. Doubling continuity's own sum, or
//! mirrored velocities, compress as much, but feed waves of sound and of the scale of particles
//! along a wall (found by trying both in a tank at rest). A wall that pushes alone, whose pressure has been cut off at zero,
//! does no such work.
//!
//! At a contact line, where liquid meets but a part of a wall's particle, the sum over k has also what comes along the wall: no volume that
//! the wall takes, but the liquid's edge moving on. It would compress a liquid that spreads, in front, and its pressure
//! would hold contact lines. With N the wall's normal, [`Edge`] takes it off, and by the same token what the particle's
//! pressure does along the wall:
//!
//! sum_k V_k (v_k - v_w) . grad W_kw -> that + (v_w - v) . T_w,   T_w = (1 - N N) sum_k V_k grad W_wk,   v = sum_k v_k W_kw / sum_k W_kw
//! F_k = sum_w p_w V_w (V_k grad W_wk - T_w W_kw / sum_f W_fw)

use super::extrapolation::Neighbourhood;
use crate::particles::Particles;
use crate::physics::surface_tension::gradient::Smoothed;
use crate::real::Real;
use crate::term::{Pair, PairTerm, Sweep};
use crate::vector::Vector;

/// Columns that the sum above needs on its way.
#[derive(Debug, Default)]
pub struct Compression {
    /// Per row: what the wall has for the fluid.
    weighted: Vec<f64>,
    sums: Vec<f64>,
}

impl Compression {
    /// Completes (1/rho) D rho / Dt, 1/s, of the fluid by `of_wall`, what the sums of continuity have for the
    /// rows of walls, with what these know of the fluid; none for those that take no part. Walls are left with a rate of
    /// zero. `touches` holds for rows with fluid that meets a wall.
    pub fn complete<const D: usize>(
        &mut self,
        sweep: &mut impl Sweep<D>,
        particles: &Particles<D>,
        walls: &[u32],
        touches: impl Fn(std::ops::Range<usize>) -> bool + Sync,
        of_wall: impl Fn(usize, f64) -> Option<f64>,
        rates: &mut [f64],
    ) {
        let Self { weighted, sums } = self;
        weighted.clear();
        weighted.resize(particles.len(), 0.0);
        for &row in walls {
            let row = row as usize;
            if let Some(rate) = of_wall(row, rates[row]) {
                weighted[row] = rate * particles.volume(row);
            }
        }
        sweep.sweep(&Smoothed { weighted }, particles, touches, sums);
        for (i, (rate, sum)) in rates.iter_mut().zip(&*sums).enumerate() {
            *rate += sum / particles.volume(i);
        }
        // Their own density follows from their pressure.
        for &row in walls {
            rates[row as usize] = 0.0;
        }
    }
}

/// The edge of the liquid at a particle of a wall.
#[derive(Clone, Copy, Debug)]
pub struct Edge<const D: usize> {
    /// T_w, 1/m
    along: Vector<f64, D>,
    /// The mean of the liquid's velocity, m/s.
    velocity: Vector<f64, D>,
    /// sum W, 1/m^D
    weight: f64,
}

impl<const D: usize> Edge<D> {
    /// For a unit normal, of either sign; none is zero, and has no edge.
    pub fn new(near: &Neighbourhood<f64, D>, normal: Vector<f64, D>) -> Option<Self> {
        (near.weight > 0.0 && normal != Vector::ZERO).then(|| Self {
            along: near.filling - normal * normal.dot(&near.filling),
            velocity: near.velocity * (1.0 / near.weight),
            weight: near.weight,
        })
    }

    /// What it adds to the rate that continuity finds for the wall's particle, 1/s, whose velocity is `of_wall`.
    pub fn passing(&self, of_wall: Vector<f64, D>) -> f64 {
        -(of_wall - self.velocity).dot(&self.along)
    }

    /// The force along the wall, N, that the pressure (Pa) of its particle of this volume is kept from, over sum W.
    pub fn kept(&self, pressure: f64, volume: f64) -> Vector<f64, D> {
        self.along * (pressure * volume / self.weight)
    }

    /// sum W, 1/m^D
    pub fn weight(&self) -> f64 {
        self.weight
    }
}

/// Sums to sum_j F_j W_ij.
#[derive(Clone, Copy, Debug)]
pub struct Shared<'a, const D: usize> {
    /// F of each particle.
    pub of: &'a [Vector<f64, D>],
}

impl<const D: usize> PairTerm<D> for Shared<'_, D> {
    type Record<R: Real> = Vector<R, D>;
    type Sum<R: Real> = Vector<R, D>;
    const OFTEN: bool = false;

    fn record(&self, _: &Particles<D>, i: usize) -> Vector<f64, D> {
        self.of[i]
    }

    #[inline(always)]
    fn pair<R: Real>(
        &self,
        _: &Vector<R, D>,
        of: &Vector<R, D>,
        ij: &Pair<R, D>,
        sum: &mut Vector<R, D>,
    ) {
        *sum += *of * ij.w;
    }
}
