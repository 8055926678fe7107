//! Particles of the liquid that come too near push each other: where p - q vanishes nothing else keeps them apart. Along
//! the line of centres, so that linear and angular momentum are kept:
//!
//! rho_0 a_i = K sigma / dx^3 sum_j (0.8 dx - x_ij) x_ij / |x_ij|

use super::order;
use crate::kernel::Kernel;
use crate::particles::Particles;
use crate::physics::wall::WallBodies;
use crate::real::Real;
use crate::term::{Pair, PairTerm};
use crate::vector::Vector;

/// Spacings nearer than which particles push each other.
const REST: f64 = 0.8;
/// K: as stiff as a capillary wave of about two spacings, which the steps resolve.
const STIFFNESS: f64 = 5.0;

/// Sums to an acceleration, m/s^2. Particles of walls neither push nor are pushed: they would hold what lies before them in place,
/// each between two of them.
#[derive(Clone, Copy, Debug)]
pub struct Closeness<'a> {
    walls: WallBodies<'a>,
    /// 0.8 dx, m
    rest: f64,
    /// K sigma / (rho_0 dx^3), 1/s^2
    stiffness: f64,
}

impl<'a> Closeness<'a> {
    /// Of a surface tension in N/m, a density at rest in kg/m^3 and a spacing in m.
    pub fn new(surface_tension: f64, density: f64, spacing: f64, walls: WallBodies<'a>) -> Self {
        Self {
            walls,
            rest: REST * spacing,
            stiffness: STIFFNESS * surface_tension / (density * spacing.powi(3)),
        }
    }

    /// The kernel and smoothing length whose lists hold the pairs that push, and beside walls those that
    /// [`Order`](super::Order) asks for.
    pub fn range(dimension: usize, spacing: f64, walled: bool) -> (Kernel, f64) {
        let kernel = Kernel::WendlandC2;
        let reach = if walled {
            order::reach(dimension)
        } else {
            REST
        };
        (kernel, reach * spacing / kernel.support())
    }
}

impl<const D: usize> PairTerm<D> for Closeness<'_> {
    /// One, and zero for walls.
    type Record<R: Real> = R;
    type Sum<R: Real> = Vector<R, D>;
    const OFTEN: bool = false;

    fn record(&self, particles: &Particles<D>, i: usize) -> f64 {
        if self.walls.hold(particles.body[i]) {
            0.0
        } else {
            1.0
        }
    }

    #[inline(always)]
    fn pair<R: Real>(&self, i: &R, j: &R, ij: &Pair<R, D>, sum: &mut Vector<R, D>) {
        let distance = (ij.distance_squared + ij.distance_squared.tiny()).sqrt();
        let close = (distance.literal(self.rest) - distance).positive();
        *sum += ij.offset * (*i * *j * close * self.stiffness / distance);
    }
}
