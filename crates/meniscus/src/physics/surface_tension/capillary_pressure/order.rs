//! Order among the particles of a liquid that walls hold.
//!
//! A contact line pulls at what lies within two spacings of the wall, finer than a kernel spreads; and where p - q is next to
//! nothing, pressure does not put particles back in order. Rows would close up and voids open between them, of which density
//! by continuity does not tell. So after each step of a liquid beside walls, with u = sqrt(sigma / (rho_0 dx)), C the colour
//! of liquid and walls together, and D the same smoothed four times more:
//!
//! - dx_i/dt = 0.3 u min(|e| - e_0, 1) e / |e| where |e| > e_0, with e_i = sum_j (1 - r_ij / reach)^2 x_ij / r_ij. Particle
//!   shifting (Xu, Stansby and Laurence 2009; Lind et al. 2012), at the pace of capillary waves of a spacing, and none among
//!   particles in fair order. Nothing is shifted out of the surface: where D < 0.75 e loses its part along grad D, and less of
//!   it up to D = 0.9. It is D which tells, since the surface of C runs along the wall under a foot of one particle,
//!   whose shifts would draw it out, and around voids, which shifts are to close.
//! - d rho_i/dt = (u / dx) d (rho_0 C - rho_i), less what is within 2 % of rho_i, where d goes from 0 to 1 with D. Voids so
//!   lose their pressure, and close.
//!
//! In two dimensions reach = 1.5 dx, e_0 = 0.15, and d begins at D = 0.90 and is one from 0.98, in three 2 dx, 0.1, 0.85 and
//! 0.95. Chosen by drops of 12 dx at 30 to 150 degrees and of 10 dx at 60: with the second in two dimensions drops that stand on
//! little wander, with the first in three voids stay open.
//!
//! Velocities stay, and momentum with them. Free bodies need neither, and get neither.

use crate::particles::Particles;
use crate::physics::surface_tension::surface::Surface;
use crate::real::Real;
use crate::term::{Pair, PairTerm};
use crate::vector::Vector;

/// Largest speed of shifting, u.
const PACE: f64 = 0.3;
/// What density and colour may differ by.
const LEEWAY: f64 = 0.02;
/// Passes of smoothing from C to D.
pub(super) const PASSES: usize = 4;
/// D between which the surface ends.
const SURFACE: [f64; 2] = [0.75, 0.9];

/// What depends on the dimension.
struct Measure {
    /// Reach of shifting, dx.
    reach: f64,
    /// e_0
    fair: f64,
    /// D between which density begins to mind, and does in full.
    depth: [f64; 2],
}

const IN_THE_PLANE: Measure = Measure {
    reach: 1.5,
    fair: 0.15,
    depth: [0.90, 0.98],
};
const IN_SPACE: Measure = Measure {
    reach: 2.0,
    fair: 0.1,
    depth: [0.85, 0.95],
};

const fn measure(dimension: usize) -> Measure {
    if dimension == 3 {
        IN_SPACE
    } else {
        IN_THE_PLANE
    }
}

/// Reach of shifting, dx.
pub(super) fn reach(dimension: usize) -> f64 {
    measure(dimension).reach
}

/// Where a particle is, as far as its order needs it.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Place<const D: usize> {
    /// Whether it is of a liquid that walls hold.
    held: bool,
    /// d
    depth: f64,
    /// C
    filled: f64,
    /// The share of e along `inward` that is taken away.
    surface: f64,
    /// The direction of grad D.
    inward: Vector<f64, D>,
}

/// How much of the way from one value to another.
fn part([from, to]: [f64; 2], value: f64) -> f64 {
    ((value - from) / (to - from)).clamp(0.0, 1.0)
}

impl<const D: usize> Place<D> {
    /// Of liquid beside walls, by C, and D with its gradient.
    pub(super) fn beside_walls(filled: f64, (smooth, inward): (f64, Vector<f64, D>)) -> Self {
        let u = part(measure(D).depth, smooth);
        Self {
            held: true,
            depth: u * u * (3.0 - 2.0 * u),
            filled,
            surface: 1.0 - part(SURFACE, smooth),
            inward: inward * (1.0 / inward.norm().max(f64::MIN_POSITIVE)),
        }
    }
}

/// Sums to e.
#[derive(Clone, Copy, Debug)]
pub struct Order {
    /// m
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
    pub fn new<const D: usize>(surface_tension: f64, density: f64, spacing: f64) -> Self {
        let pace = (surface_tension / (density * spacing)).sqrt();
        Self {
            reach: reach(D) * spacing,
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
            way -= place.inward * (place.surface * place.inward.dot(&way));
            let length = way.norm();
            let uneven = length - measure(D).fair;
            if uneven > 0.0 {
                let speed = PACE * self.pace * uneven.min(1.0);
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
