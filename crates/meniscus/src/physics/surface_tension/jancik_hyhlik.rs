//! The free-surface continuum surface force of Jancik and Hyhlik, "Surface
//! Tension Model for Free-Surface Problems in SPH". In the paper's order,
//! with V = m / rho and all sums including j = i:
//!
//! - eq. 7   f*_i  = sum_j V_j W_ij                        colour of the liquid, smoothed
//! - eq. 8   f**_i = max(0, a f*_i - a + 1)^b              stretched to vanish at the surface
//! - eq. 9   n_i   = sum_j V_j (f**_j - f**_i) grad W_ij   normal, inward
//! - eq. 10  N_i   = 1 where |n_i| >= 0.01 / h, else 0     surface-active
//! - eq. 11  C_i   = sum_j V_j min(N_i, N_j) W_ij
//! - eq. 13  k_i   = sum_j min(N_i, N_j) V_j (u_j - u_i) . grad W_ij / C_i,   u = n / |n|
//! - eq. 14  k*_i  = sum_j V_j N_j k_j W_ij / C_i
//! - eq. 12, 15  a_i = -sigma / rho_i k*_i n_i / C_i
//!
//! The paper's 0.01 in eq. 10 takes the noise of a slightly disordered inside for
//! a surface: at a jitter of 0.05 spacings nearly all particles are active, and
//! the measured tension is 24 % low. The default here is 0.1 (6 % low then; within
//! 0.4 % of the paper's threshold on a lattice); 0.01 reproduces the paper.
//!
//! Departures from the print: the bracket of eq. 8 is cut at zero (its even
//! power would rise again for f* < 1/2), eq. 14 sums k_j (the print carries
//! k_i), and particles with N_i = 0, where C_i = 0, feel no force.
//! k is the divergence of the inward normal: -1/R on a circle, -2/R on a sphere.

use rayon::prelude::*;

use crate::particles::Particles;
use crate::real::Real;
use crate::record;
use crate::term::{Pair, PairTerm, Sweep};
use crate::vector::Vector;

/// Eq. 7: sums to f*.
#[derive(Clone, Copy, Debug)]
pub struct Colour;

impl<const D: usize> PairTerm<D> for Colour {
    type Record<R: Real> = R;
    type Sum<R: Real> = R;

    fn record(&self, particles: &Particles<D>, i: usize) -> f64 {
        particles.volume(i)
    }

    #[inline(always)]
    fn pair<R: Real>(&self, _: &R, volume: &R, ij: &Pair<R, D>, sum: &mut R) {
        *sum = *sum + *volume * ij.w;
    }
}

record! {
    /// Volume and stretched colour.
    pub struct Coloured<R, D> {
        /// V, m^D
        volume: R,
        /// f**
        colour: R,
    }
}

/// Eq. 9: sums to n, 1/m.
#[derive(Clone, Copy, Debug)]
pub struct Normal<'a> {
    /// f** of each particle.
    pub colour: &'a [f64],
}

impl<const D: usize> PairTerm<D> for Normal<'_> {
    type Record<R: Real> = Coloured<R, D>;
    type Sum<R: Real> = Vector<R, D>;

    fn record(&self, particles: &Particles<D>, i: usize) -> Coloured<f64, D> {
        Coloured {
            volume: particles.volume(i),
            colour: self.colour[i],
        }
    }

    #[inline(always)]
    fn pair<R: Real>(
        &self,
        i: &Coloured<R, D>,
        j: &Coloured<R, D>,
        ij: &Pair<R, D>,
        sum: &mut Vector<R, D>,
    ) {
        *sum += ij.grad_w * (j.volume * (j.colour - i.colour));
    }
}

record! {
    /// Volume, unit normal and N.
    pub struct Oriented<R, D> {
        /// u
        direction: Vector<R, D>,
        /// V, m^D
        volume: R,
        /// N, 0 or 1
        active: R,
    }
}

record! {
    /// The sums of eqs. 11 and 13.
    pub struct Divergence<R, D> {
        /// C
        correction: R,
        /// k C, 1/m
        divergence: R,
    }
}

/// Eqs. 11 and 13: sums to C and k C.
#[derive(Clone, Copy, Debug)]
pub struct Curvature<'a, const D: usize> {
    /// n of each particle, 1/m.
    pub normal: &'a [Vector<f64, D>],
    /// Normals shorter than this count as none, 1/m.
    pub shortest: f64,
}

impl<const D: usize> Curvature<'_, D> {
    /// Eq. 10
    fn is_active(&self, normal: &Vector<f64, D>) -> bool {
        normal.norm_squared() >= self.shortest * self.shortest
    }
}

impl<const D: usize> PairTerm<D> for Curvature<'_, D> {
    type Record<R: Real> = Oriented<R, D>;
    type Sum<R: Real> = Divergence<R, D>;

    fn record(&self, particles: &Particles<D>, i: usize) -> Oriented<f64, D> {
        let normal = self.normal[i];
        let active = self.is_active(&normal);
        Oriented {
            direction: if active {
                normal * (1.0 / normal.norm())
            } else {
                Vector::ZERO
            },
            volume: particles.volume(i),
            active: if active { 1.0 } else { 0.0 },
        }
    }

    #[inline(always)]
    fn pair<R: Real>(
        &self,
        i: &Oriented<R, D>,
        j: &Oriented<R, D>,
        ij: &Pair<R, D>,
        sum: &mut Divergence<R, D>,
    ) {
        let volume = i.active.min(j.active) * j.volume;
        sum.correction = sum.correction + volume * ij.w;
        sum.divergence = sum.divergence + volume * (j.direction - i.direction).dot(&ij.grad_w);
    }
}

/// Eq. 14: sums to k* C, from V N k of each particle.
#[derive(Clone, Copy, Debug)]
pub struct Smoothing<'a> {
    /// V N k, m^(D-1)
    pub weighted_curvature: &'a [f64],
}

impl<const D: usize> PairTerm<D> for Smoothing<'_> {
    type Record<R: Real> = R;
    type Sum<R: Real> = R;

    fn record(&self, _: &Particles<D>, i: usize) -> f64 {
        self.weighted_curvature[i]
    }

    #[inline(always)]
    fn pair<R: Real>(&self, _: &R, weighted: &R, ij: &Pair<R, D>, sum: &mut R) {
        *sum = *sum + *weighted * ij.w;
    }
}

/// The parameters of the model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JancikHyhlik {
    /// a of eq. 8
    pub slope: f64,
    /// b of eq. 8
    pub power: u32,
    /// Normals shorter than this over h count as none (eq. 10).
    pub threshold: f64,
}

impl Default for JancikHyhlik {
    fn default() -> Self {
        Self {
            slope: 2.0,
            power: 4,
            threshold: 0.1,
        }
    }
}

/// What the model finds on the way; columns of one row per particle.
#[derive(Debug, Default)]
pub struct Surface<const D: usize> {
    /// f**
    pub colour: Vec<f64>,
    /// n, 1/m, pointing into the liquid
    pub normal: Vec<Vector<f64, D>>,
    /// -k*, 1/m: positive for a convex surface; zero where N = 0
    pub curvature: Vec<f64>,
    divergence: Vec<Divergence<f64, D>>,
    weighted_curvature: Vec<f64>,
    smoothed: Vec<f64>,
}

impl<const D: usize> Surface<D> {
    /// Number of surface-active particles (N = 1).
    pub fn active(&self) -> usize {
        self.divergence
            .iter()
            .filter(|d| d.correction > 0.0)
            .count()
    }

    /// -sigma k*_i n_i / C_i, N/m^3, the force of eq. 15 per volume.
    pub(crate) fn force_density(&self, i: usize, surface_tension: f64) -> Vector<f64, D> {
        let correction = self.divergence[i].correction;
        if correction > 0.0 {
            self.normal[i] * (surface_tension * self.curvature[i] / correction)
        } else {
            Vector::ZERO
        }
    }
}

impl JancikHyhlik {
    /// Adds the acceleration of eq. 15 to `acceleration`, m/s^2.
    ///
    /// `surface_tension` gives sigma in N/m of each particle.
    pub fn accelerate<const D: usize>(
        &self,
        sweep: &mut impl Sweep<D>,
        particles: &Particles<D>,
        smoothing_length: f64,
        surface_tension: impl Fn(usize) -> f64 + Sync,
        surface: &mut Surface<D>,
        acceleration: &mut [Vector<f64, D>],
    ) {
        let Surface {
            colour,
            normal,
            curvature,
            divergence,
            weighted_curvature,
            smoothed,
        } = surface;
        sweep.sweep(&Colour, particles, |_| true, colour);
        for f in colour.iter_mut() {
            *f = (self.slope * *f - self.slope + 1.0)
                .max(0.0)
                .powi(self.power as i32);
        }
        sweep.sweep(&Normal { colour }, particles, |_| true, normal);
        let shortest = self.threshold / smoothing_length;
        let term = Curvature { normal, shortest };
        let is_active =
            |rows: std::ops::Range<usize>| normal[rows].iter().any(|n| term.is_active(n));
        sweep.sweep(&term, particles, is_active, divergence);
        weighted_curvature.clear();
        weighted_curvature.extend((0..particles.len()).map(|i| {
            let Divergence {
                correction,
                divergence,
            } = divergence[i];
            if correction > 0.0 {
                particles.volume(i) * divergence / correction
            } else {
                0.0
            }
        }));
        sweep.sweep(
            &Smoothing { weighted_curvature },
            particles,
            is_active,
            smoothed,
        );
        curvature.clear();
        curvature.extend(smoothed.iter().zip(divergence.iter()).map(|(smoothed, d)| {
            if d.correction > 0.0 {
                -smoothed / d.correction
            } else {
                0.0
            }
        }));
        let surface = &*surface;
        (acceleration.par_iter_mut(), &particles.density)
            .into_par_iter()
            .with_min_len(1024)
            .enumerate()
            .for_each(|(i, (acceleration, density))| {
                *acceleration += surface.force_density(i, surface_tension(i)) * (1.0 / density);
            });
    }
}
