//! Order among the particles of a liquid that walls hold.
//!
//! A contact line pulls at what lies within two spacings of the wall, finer than a kernel spreads; and where p - q is next to
//! nothing, pressure does not put particles back in order. Rows would close up and voids open between them, of which density
//! by continuity does not tell. So after each step of a liquid beside walls, with u = sqrt(sigma / (rho_0 dx)):
//!
//! - dx_i/dt = 0.3 u min(|e| - 0.15, 1) e / |e| where |e| > 0.15, with e_i = sum_j (1 - r_ij / (1.5 dx))^2 x_ij / r_ij; at the
//!   surface of e its part along the surface. Particle shifting (Xu, Stansby and Laurence 2009; Lind et al. 2012), at the pace of
//!   capillary waves of a spacing, and none among particles in fair order.
//! - d rho_i/dt = (u / dx) d (rho_0 C - rho_i), less what is within 2 % of rho_i, with C the colour of liquid and walls and d from
//!   0 to 1 with depth: of C smoothed four times more, between 0.90 and 0.98. Voids so lose their pressure, and close.
//!
//! Velocities stay, and momentum with them. Free bodies need neither, and get neither.

use crate::particles::Particles;
use crate::physics::surface_tension::surface::Surface;
use crate::real::Real;
use crate::term::{Pair, PairTerm};
use crate::vector::Vector;

/// Reach of shifting, dx.
pub(super) const REACH: f64 = 1.5;
/// Largest speed of shifting, u.
const PACE: f64 = 0.3;
/// |e| of fair order.
const FAIR: f64 = 0.15;
/// What density and colour may differ by.
const LEEWAY: f64 = 0.02;
/// Passes of smoothing that tell depth.
pub(super) const PASSES: usize = 4;
/// Colour so smoothed between which depth begins and counts in full.
const DEPTH: [f64; 2] = [0.90, 0.98];

/// Where a particle is, as far as its order needs it.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Place {
    /// Whether it is of a liquid that walls hold.
    held: bool,
    /// d
    depth: f64,
    /// C
    filled: f64,
}

impl Place {
    /// Of liquid beside walls, by the colour of both, smoothed more and as it is.
    pub(super) fn beside_walls(smooth: f64, filled: f64) -> Self {
        let u = ((smooth - DEPTH[0]) / (DEPTH[1] - DEPTH[0])).clamp(0.0, 1.0);
        Self {
            held: true,
            depth: u * u * (3.0 - 2.0 * u),
            filled,
        }
    }
}

/// Sums to e.
#[derive(Clone, Copy, Debug)]
pub struct Order {
    /// 1.5 dx, m
    reach: f64,
    /// rho_0, kg/m^3
    density: f64,
    /// u, m/s
    pace: f64,
    /// u / dx, 1/s
    rate: f64,
}

impl Order {
    /// Of a surface tension in N/m, a density at rest in kg/m^3 and a spacing in m.
    pub fn new(surface_tension: f64, density: f64, spacing: f64) -> Self {
        let pace = (surface_tension / (density * spacing)).sqrt();
        Self {
            reach: REACH * spacing,
            density,
            pace,
            rate: pace / spacing,
        }
    }

    /// Whether any of these rows is put in order, as of the last force.
    pub(crate) fn minds<const D: usize>(
        surface: &Surface<D>,
        mut rows: std::ops::Range<usize>,
    ) -> bool {
        let places = &surface.capillary_pressure.places;
        rows.any(|row| places[row].held)
    }

    /// Shifts particles by `uneven`, their e, and brings their densities nearer to colour, for `dt` seconds.
    pub(crate) fn restore<const D: usize>(
        &self,
        surface: &Surface<D>,
        uneven: &[Vector<f64, D>],
        particles: &mut Particles<D>,
        dt: f64,
    ) {
        let places = &surface.capillary_pressure.places;
        for (row, place) in places.iter().enumerate().filter(|(_, place)| place.held) {
            let mut way = uneven[row];
            let inward = surface.normal[row];
            let steep = inward.norm_squared();
            if steep > 0.0 {
                way -= inward * (inward.dot(&way) / steep);
            }
            let length = way.norm();
            if length > FAIR {
                let speed = PACE * self.pace * (length - FAIR).min(1.0);
                particles.position[row] += way * (speed * dt / length);
            }
            let density = &mut particles.density[row];
            let off = place.filled * self.density / *density - 1.0;
            let beyond = off - off.clamp(-LEEWAY, LEEWAY);
            *density += *density * beyond * place.depth * (self.rate * dt).min(1.0);
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
