//! Order among the particles of a liquid near walls.
//!
//! A contact line pulls at what lies within two spacings of the wall, finer than a kernel spreads; and where p - q is next to
//! nothing, pressure does not put particles back in order. So after every fourth step, of particles that see the smoothed colour of a
//! wall, some three spacings from it, with
//! u = sqrt(sigma / (rho_0 dx)), and D the colour of liquid and walls together, smoothed four times more:
//!
//! dx_i/dt = min(0.1 u, |v_i|) min(|e| - e_0, 1) e / |e| where |e| > e_0, with e_i = sum_j (1 - r_ij / reach)^2 x_ij / r_ij
//!
//! Particle shifting (Xu, Stansby and Laurence 2009; Lind et al. 2012), slower than capillary waves of a spacing and than the
//! particle itself, and none among particles in fair order. It is motion that brings disorder; at a foot at rest, whose pull is
//! never even, shifts that went on would stir the liquid for ever, by 0.03 sqrt(sigma / (rho R)) where there is 0.003 so.
//!
//! The speed is that in the frame of the case: liquid that moving walls carry along is shifted at full pace though it rests on them.
//!
//! Nothing is shifted out of the surface: where D < 0.75 e loses its part along grad D, and less of it up to D = 0.9. It is D which
//! tells, since the surface of the colour itself runs along the wall under a foot of one particle, whose shifts would draw it out,
//! and around voids, which shifts are to close.
//!
//! What shifts do to the distance of particles they do to density ([`shift`](super::shift)); not counted, drops on plates grow by a
//! tenth in some ten capillary times. One shift stands for those of four steps.
//!
//! In two dimensions reach = 1.5 dx and e_0 = 0.15, in three 2 dx and 0.1. Velocities stay, and momentum with them. Liquid
//! away from walls needs no such order, and gets none.

use crate::particles::Particles;
use crate::physics::surface_tension::surface::Surface;
use crate::real::Real;
use crate::term::{Pair, PairTerm};
use crate::vector::Vector;

/// Largest speed of shifting, u.
const PACE: f64 = 0.1;
/// Steps from one shift to the next.
pub const STEPS_BETWEEN: u64 = 4;
/// Passes of smoothing from the colour to D.
pub(super) const PASSES: usize = 4;
/// D between which the surface ends.
const SURFACE: [f64; 2] = [0.75, 0.9];

/// Reach of shifting, dx.
pub(super) const fn reach(dimension: usize) -> f64 {
    if dimension == 3 { 2.0 } else { 1.5 }
}

/// e_0
const fn fair(dimension: usize) -> f64 {
    if dimension == 3 { 0.1 } else { 0.15 }
}

/// Where a particle is, as far as its order needs it.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Place<const D: usize> {
    /// The share of e along `inward` that is taken away; 1 on the surface, 0 inside.
    surface: f64,
    /// The direction of grad D.
    inward: Vector<f64, D>,
    /// Whether a wall is near.
    beside: bool,
}

impl<const D: usize> Place<D> {
    /// Of liquid beside walls, by D and its gradient.
    pub(super) fn beside_walls((deep, inward): (f64, Vector<f64, D>), wall: f64) -> Self {
        let [from, to] = SURFACE;
        Self {
            surface: 1.0 - ((deep - from) / (to - from)).clamp(0.0, 1.0),
            inward: inward * (1.0 / inward.norm().max(f64::MIN_POSITIVE)),
            beside: wall > 0.0,
        }
    }
}

/// Sums to e.
#[derive(Clone, Copy, Debug)]
pub struct Order {
    /// m
    reach: f64,
    /// Largest speed of shifting, m/s.
    pace: f64,
}

impl Order {
    /// Of a surface tension in N/m, a density at rest in kg/m^3 and a spacing in m.
    pub fn new<const D: usize>(surface_tension: f64, density: f64, spacing: f64) -> Self {
        Self {
            reach: reach(D) * spacing,
            pace: PACE * (surface_tension / (density * spacing)).sqrt(),
        }
    }

    /// Whether any of these rows is of liquid beside a wall, which is put in order, as of the last force.
    pub(crate) fn is_beside_wall<const D: usize>(
        surface: &Surface<D>,
        mut rows: std::ops::Range<usize>,
    ) -> bool {
        let places = &surface.capillary_pressure.places;
        rows.any(|row| places[row].beside)
    }

    /// The shift of a row with this e and `speed` (m/s) in `dt` seconds, m.
    pub(crate) fn shift<const D: usize>(
        &self,
        surface: &Surface<D>,
        row: usize,
        uneven: Vector<f64, D>,
        speed: f64,
        dt: f64,
    ) -> Vector<f64, D> {
        let place = &surface.capillary_pressure.places[row];
        let way = uneven - place.inward * (place.surface * place.inward.dot(&uneven));
        let length = way.norm();
        let beyond = length - fair(D);
        if place.beside && beyond > 0.0 {
            way * (self.pace.min(speed) * beyond.min(1.0) * dt / length)
        } else {
            Vector::ZERO
        }
    }
}

impl<const D: usize> PairTerm<D> for Order {
    type Record<R: Real> = ();
    type Sum<R: Real> = Vector<R, D>;
    const OFTEN: bool = false;

    fn record(&self, _: &Particles<D>, _: usize) {}

    #[inline(always)]
    fn pair<R: Real>(&self, (): &(), (): &(), ij: &Pair<R, D>, sum: &mut Vector<R, D>) {
        let distance = (ij.distance_squared + ij.distance_squared.tiny()).sqrt();
        let near = (distance.literal(1.0) - distance * (1.0 / self.reach)).positive();
        *sum += ij.offset * (near.square() / distance);
    }
}
