//! The continuum surface force of Qiang, Chen and Gao, "Modified Algorithm
//! for Surface Tension with Smoothed Particle Hydrodynamics and Its
//! Applications", and that of Morris (2000), Int. J. Numer. Meth. Fluids 33,
//! 333, which it corrects. For a free surface, where c = 1 for all particles
//! and there is nothing outside, and between two fluids, where c = 1 in the
//! one that has surface tension and 0 in its surroundings:
//!
//! - eq. 10   c_i = sum_j V_j c_j W_ij                      colour, smoothed
//! - eq. 12   n_i = sum_j V_j (c_j - c_i) grad W_ij         normal, Morris
//! - eq. 13   the same, times the inverse of A_i            normal, CSPM
//! - eq. 16   N_i = 1 where |n_i| > 0.01 / h                normals to rely on
//! - eq. 15   kappa_i = -div u, u = n / |n|                 curvature, Morris
//! - eq. 18   the same, corrected                           curvature, CSPM
//! - eq. 21   f_i = s sigma kappa_i n_i, a_i = f_i / rho_i
//!
//! with the sums of [`super::gradient`] and [`super::curvature`]. Curvature is
//! summed over the particles with N = 1 alone, with a smoothing length H of
//! its own.
//!
//! - `calibration`: what makes sigma what it says
//! - `form`: the force as above, balanced, or as the divergence of a stress
//! - `flat`: the layer that both are measured on
//! - `cloud`: the particles with N = 1
//!
//! Departures from the print: c is 1 inside (the text of eq. 10 says 0), so that
//! n points inward and kappa = -div u = 1/R; matrices are inverted only where
//! neighbours do not lie on a line or plane; Morris's curvature is divided by C, and
//! particles with N = 0 take no part, where the print counts their normals as zero and
//! finds 1.77 / R.
//!
//! The defaults depart further, because the printed form takes the noise of a
//! disordered inside for a surface. They weigh particles by |n|, less the threshold.
//! Cut off there instead, particles come and go with a force of their own, which
//! works into a swinging drop. A threshold of 0.1 / h makes disorder do less still, and
//! drops of 10 to 20 spacings swing at a better period; but in space, at h = 1.5 dx, it leaves
//! bumps of few particles without tension, which grow to spikes.

mod calibration;
mod cloud;
mod flat;
mod form;

use calibration::Calibrated;
pub use calibration::Calibration;
use cloud::Cloud;
pub use cloud::Relist;
pub use flat::FlatLayer;
pub use form::{Form, Stress};

use super::curvature::{
    CorrectableDivergence, CorrectedCurvature, Curvature, Divergence, Weighting,
};
use super::gradient::{Correctable, CorrectedGradient, Gradient, Smoothed};
use super::surface::Surface;
use crate::fluid::Fluid;
use crate::particles::Particles;
use crate::term::Sweep;
use crate::vector::Vector;

/// How a gradient is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Correction {
    /// As Morris does: exact for a constant.
    Morris,
    /// By CSPM: exact for a linear function, also at an edge or a corner.
    Cspm,
}

/// The parameters of the model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Continuum {
    /// How normals are found.
    pub normal: Correction,
    /// How curvature is found.
    pub curvature: Correction,
    /// H / h, the smoothing length of curvature over that of all else.
    pub curvature_smoothing: f64,
    /// Normals shorter than this over h count as none (eq. 16); where weights go with length,
    /// this much is taken off the length of all, so that no particle enters at a jump.
    pub threshold: f64,
    /// What the others weigh in the curvature of their neighbours.
    pub weighting: Weighting,
    /// What the force is multiplied by.
    pub calibration: Calibration,
    /// How curvature and normals become a force.
    pub form: Form,
}

impl Default for Continuum {
    fn default() -> Self {
        Self {
            normal: Correction::Cspm,
            curvature: Correction::Cspm,
            curvature_smoothing: 1.5,
            threshold: 0.01,
            weighting: Weighting::NormalLength,
            calibration: Calibration::FlatLayer,
            form: Form::Balanced,
        }
    }
}

impl Continuum {
    /// The model as Qiang, Chen and Gao print it.
    pub const PRINTED: Self = Self {
        normal: Correction::Cspm,
        curvature: Correction::Cspm,
        curvature_smoothing: 1.5,
        threshold: 0.01,
        weighting: Weighting::Volume,
        calibration: Calibration::Printed,
        form: Form::Force,
    };
}

/// Columns that the model needs on its way.
#[derive(Debug, Default)]
pub(super) struct Scratch<const D: usize> {
    weighted: Vec<f64>,
    correctable: Vec<Correctable<f64, D>>,
    cloud: Cloud<D>,
    divergence: Vec<Divergence<f64, D>>,
    correctable_divergence: Vec<CorrectableDivergence<f64, D>>,
    /// Known from the first force on.
    pub(super) calibration: Option<Calibrated>,
}

/// Largest curvature that a layer of particles can show, as (D - 1) / h: that of a thread or
/// drop of a smoothing length across. What is more is of particles on their own.
const SHARPEST: f64 = 2.0;

/// What the model acts in.
#[derive(Clone, Copy, Debug)]
pub struct Surroundings<'a> {
    /// Fluids by index.
    pub fluids: &'a [Fluid],
    /// h, m
    pub smoothing_length: f64,
}

impl Surroundings<'_> {
    /// Whether the surface lies between two fluids: one has surface tension, another none.
    pub(super) fn has_interface(&self) -> bool {
        let without = |fluid: &Fluid| fluid.surface_tension == 0.0;
        self.fluids.iter().any(without) && !self.fluids.iter().all(without)
    }

    /// Surface tension that acts on a particle, N/m: its own fluid's, or beside another
    /// fluid that of the interface.
    fn surface_tension(&self, fluid: u16) -> f64 {
        let own = self.fluids[fluid as usize].surface_tension;
        if own > 0.0 {
            return own;
        }
        (self.fluids.iter()).fold(0.0, |most, fluid| most.max(fluid.surface_tension))
    }

    /// c of a fluid's particles.
    fn colour(&self, fluid: u16) -> f64 {
        let outside = self.has_interface() && self.fluids[fluid as usize].surface_tension == 0.0;
        if outside { 0.0 } else { 1.0 }
    }
}

impl Continuum {
    /// Eqs. 10 to 13: colour and normals.
    fn find_normals<const D: usize>(
        &self,
        sweep: &mut impl Sweep<D>,
        particles: &Particles<D>,
        surroundings: Surroundings<'_>,
        surface: &mut Surface<D>,
    ) {
        let Surface {
            colour,
            normal,
            continuum:
                Scratch {
                    weighted,
                    correctable,
                    ..
                },
            ..
        } = surface;
        weighted.clear();
        weighted.extend(
            (0..particles.len())
                .map(|i| particles.volume(i) * surroundings.colour(particles.fluid[i])),
        );
        sweep.sweep(&Smoothed { weighted }, particles, |_| true, colour);
        match self.normal {
            Correction::Morris => {
                let term = Gradient { values: colour };
                sweep.sweep(&term, particles, |_| true, normal);
            }
            Correction::Cspm => {
                let term = CorrectedGradient { values: colour };
                sweep.sweep(&term, particles, |_| true, correctable);
                normal.clear();
                normal.extend(correctable.iter().map(Correctable::corrected));
            }
        }
        if self.weighting == Weighting::NormalLength {
            let shortest = self.threshold / surroundings.smoothing_length;
            for n in normal.iter_mut() {
                *n = *n * (1.0 - shortest / n.norm().max(f64::MIN_POSITIVE)).max(0.0);
            }
        }
    }

    /// Normals shorter than this count as none, 1/m.
    fn shortest(&self, surroundings: Surroundings<'_>) -> f64 {
        match self.weighting {
            Weighting::Volume => self.threshold / surroundings.smoothing_length,
            // What is taken off the length of all has left none.
            Weighting::NormalLength => 0.0,
        }
    }

    /// Eqs. 15 to 18: curvature of the surface, from that of the layer under it.
    fn find_curvature<const D: usize, S: Sweep<D> + Relist<D>>(
        &self,
        at_surface: &mut S,
        particles: &Particles<D>,
        shortest: f64,
        calibrated: Calibrated,
        surface: &mut Surface<D>,
    ) {
        let Surface {
            normal,
            curvature,
            active,
            continuum:
                Scratch {
                    cloud,
                    divergence,
                    correctable_divergence,
                    ..
                },
            ..
        } = surface;
        cloud.gather(at_surface, particles, normal, shortest);
        *active = cloud.len();
        curvature.clear();
        curvature.resize(particles.len(), 0.0);
        let term = Curvature {
            normal: cloud.normal(),
            shortest,
            weighting: self.weighting,
        };
        let particles = cloud.particles();
        match self.curvature {
            Correction::Morris => {
                at_surface.sweep(&term, particles, |_| true, divergence);
                cloud.scatter(divergence, curvature, |sum| {
                    calibrated.curvature::<D>(-sum.divergence / sum.correction)
                });
            }
            Correction::Cspm => {
                let term = CorrectedCurvature(term);
                at_surface.sweep(&term, particles, |_| true, correctable_divergence);
                cloud.scatter(correctable_divergence, curvature, |sum| {
                    calibrated.curvature_of(&sum.gradient())
                });
            }
        }
    }

    /// Adds the acceleration of eq. 21 to `acceleration`, m/s^2.
    ///
    /// `sweep` sums with h over all particles; `at_surface` sums with
    /// [`curvature_smoothing`](Self::curvature_smoothing) h over those at the surface.
    pub fn accelerate<const D: usize, S: Sweep<D> + Relist<D>>(
        &self,
        sweep: &mut impl Sweep<D>,
        at_surface: &mut S,
        particles: &Particles<D>,
        surroundings: Surroundings<'_>,
        surface: &mut Surface<D>,
        acceleration: &mut [Vector<f64, D>],
    ) {
        let calibrated = surface.continuum.calibration.unwrap_or_default();
        let shortest = self.shortest(surroundings);
        self.find_normals(sweep, particles, surroundings, surface);
        self.find_curvature(at_surface, particles, shortest, calibrated, surface);
        let sharpest = SHARPEST * (D as f64 - 1.0) / surroundings.smoothing_length;
        for curvature in &mut surface.curvature {
            *curvature = curvature.clamp(-sharpest, sharpest);
        }
        let factor =
            |i: usize| calibrated.strength * surroundings.surface_tension(particles.fluid[i]);
        match self.form {
            Form::Force | Form::Balanced => {
                surface.force.clear();
                surface.force.extend(
                    (surface.normal.iter().zip(&surface.curvature).enumerate())
                        .map(|(i, (normal, curvature))| *normal * (factor(i) * curvature)),
                );
            }
            Form::Stress => {
                let stress = Stress {
                    normal: &surface.normal,
                    shortest,
                    factor: &factor,
                };
                sweep.sweep(&stress, particles, |_| true, &mut surface.force);
            }
        }
        surface.net_force = surface.sum_of_forces(particles);
        if self.form == Form::Balanced {
            form::balance(particles, surface);
        }
        surface.add_to(&particles.density, acceleration);
    }
}
