//! Surface tension in balance with the pressure gradient, for one fluid with a free surface.
//!
//! A free surface asks for the pressure sigma kappa. The pressure gradient of pairs,
//! -sum_j V_i V_j (p_i + p_j) grad W_ij, knows the condition p = 0 there. So the force is
//! that gradient of p - q, and the gradient of q, where q = sigma kappa at the surface:
//!
//! m_i a_i = -sum_j V_i V_j (p_i - q_i + p_j - q_j) grad W_ij - V_i A_i^-1 sum_j V_j (q_j - q_i) grad W_ij
//!
//! with A_i as in [`super::gradient`], so that the last sum is exact for a linear q up to the surface. Both sums
//! with q nearly cancel; what is left beside the plain pressure gradient is
//!
//! m_i a_i = sigma V_i [2 kappa_i n_i - (A_i^-1 - 1) sum_j V_j (kappa_j - kappa_i) grad W_ij],
//!
//! n_i = sum_j V_j grad W_ij, the second term along the surface and in its layer alone. A constant p = sigma kappa cancels it particle by
//! particle, however disordered they are; on a flat surface the sum of 2 |n| V over a unit of area is 1 by
//! the kernel's own normalisation. How q goes on inside does not matter to a flow that is resolved: kappa
//! relaxes there towards its mean over neighbours, one sweep a step, so that there is no jump at
//! which disorder could push. It is state, part of a [`Snapshot`](crate::Snapshot).
//!
//! kappa at the surface is found by regression ([`Regression`]), smoothed over the layer
//! (S, with weights V |n|), and sharpened by kappa + f (kappa - S kappa), which gives back what
//! normals and smoothing take from a short wave.
//!
//! A particle that lies outside the surface, at a depth d < 0, has neither neighbours nor
//! pressure to bring it back: it is a bump too small for kappa. To its own
//! curvature -2 d / dx^2 is added. Neighbours nearer than 0.8 dx push each other.
//!
//! Forces and moments of each free body are balanced, and of one on a plane wall the
//! forces along it ([`super::bodies`]). What walls change is in [`Wetting`].
//!
//! - `half_space`: the kernel's integrals under a plane surface
//! - `coverage`: what surrounds a particle
//! - `layer`: which particles make the surface
//! - `regression`: its curvature
//! - `extension`: curvature off the surface
//! - `wetting`, `wedge`: walls, and the contact angle

mod coverage;
mod extension;
mod half_space;
mod layer;
mod regression;
mod wedge;
mod wetting;

pub use coverage::{Coverage, Covered, Facing, Inward};
pub use extension::{Extended, Extension, Mean};
pub use half_space::HalfSpace;
pub use regression::{Moments, Point, Regression};
pub use wedge::Wedge;
pub use wetting::{
    Imaged, Solid, WallCoverage, WallCovered, WettedMean, WettedRegression, Wetting,
};

use super::bodies::{Bodies, balance};
use super::gradient::LEAST_MATRIX;
use super::surface::Surface;
use crate::kernel::Kernel;
use crate::particles::Particles;
use crate::term::Sweep;
use crate::vector::Vector;
use layer::{Layer, Thresholds};

/// The model; it has no parameter.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Balanced;

/// f, for Wendland's C2 kernel with h = 2 dx.
const SHARPENING: f64 = 5.0;
/// Sweeps by which curvature spreads inside at the start, and rounds in which depth and
/// curvature of the surface find each other.
const SPREADING: usize = 40;
const ROUNDS: usize = 3;
/// Curvature of a particle outside the surface, over its height in squared spacings.
const BUMP: f64 = 2.0;
/// Spacings nearer than which neighbours push each other.
const REST: f64 = 0.8;

/// What the model acts in.
#[derive(Clone, Copy, Debug)]
pub struct Surroundings<'a, const D: usize> {
    /// sigma, N/m
    pub surface_tension: f64,
    /// Smoothing kernel.
    pub kernel: Kernel,
    /// h, m
    pub smoothing_length: f64,
    /// dx, m
    pub spacing: f64,
    /// Free bodies.
    pub bodies: Bodies<'a, D>,
    /// Walls, whose particles have no mass meanwhile.
    pub wetting: &'a Wetting,
}

/// Columns that the model needs on its way.
#[derive(Debug, Default)]
pub(super) struct Scratch<const D: usize> {
    tables: Option<(HalfSpace, Thresholds)>,
    /// One for each contact angle.
    wedges: Vec<Wedge>,
    layer: Layer<D>,
    moments: Vec<Moments<f64, D>>,
    weight: Vec<f64>,
    means: Vec<(f64, f64)>,
    rough: Vec<f64>,
    smooth: Vec<f64>,
    held: Vec<bool>,
    extended: Vec<Extended<f64, D>>,
}

impl<const D: usize> Scratch<D> {
    /// kappa of the surface, 1/m, smoothed and sharpened, into `curvature`, which holds that
    /// of before; rows it does not reach are left as they are, and not held.
    fn find_curvature(
        &mut self,
        sweep: &mut impl Sweep<D>,
        particles: &Particles<D>,
        surroundings: Surroundings<'_, D>,
        curvature: &mut [f64],
    ) {
        let spacing = surroundings.spacing;
        let Self {
            tables: Some((half_space, thresholds)),
            wedges,
            layer,
            moments,
            weight,
            means,
            rough,
            smooth,
            held,
            ..
        } = self
        else {
            return;
        };
        layer.locate(particles, half_space, thresholds, wedges, curvature);
        let term = Regression {
            points: &layer.points,
        };
        let in_layer = |rows: std::ops::Range<usize>| {
            (layer.points[rows].iter()).any(|point| point.weight > 0.0)
        };
        let h = surroundings.smoothing_length;
        let wetted = WettedRegression {
            points: &layer.points,
            images: &layer.images,
            kernel: (1.0 / h, surroundings.kernel.value(0.0, h, D)),
        };
        let walled = !layer.images.is_empty();
        if walled {
            sweep.sweep(&wetted, particles, in_layer, moments);
        } else {
            sweep.sweep(&term, particles, in_layer, moments);
        }
        let sharpest = (D as f64 - 1.0) / spacing;
        weight.clear();
        weight.extend(layer.points.iter().map(|point| point.weight));
        rough.clear();
        rough.extend((layer.points.iter().zip(&*moments)).map(|(point, sum)| {
            if point.weight > 0.0 {
                (sum.curvature(&point.direction)).clamp(-sharpest, sharpest)
            } else {
                0.0
            }
        }));
        let shallow = |rows: std::ops::Range<usize>| layer.shallow[rows].contains(&true);
        let mut mean = |values: &[f64], means: &mut Vec<(f64, f64)>| {
            if walled {
                let surface = wetted;
                let term = WettedMean { surface, values };
                sweep.sweep(&term, particles, shallow, means);
            } else {
                sweep.sweep(&Mean { weight, values }, particles, shallow, means);
            }
        };
        mean(rough, means);
        held.clear();
        held.extend((0..particles.len()).map(|i| layer.shallow[i] && means[i].0 > 0.0));
        smooth.clear();
        smooth.extend((means.iter().zip(&*held)).map(
            |(sum, &held)| {
                if held { sum.1 / sum.0 } else { 0.0 }
            },
        ));
        mean(smooth, means);
        for (i, kappa) in curvature.iter_mut().enumerate() {
            if held[i] {
                *kappa = smooth[i] + SHARPENING * (smooth[i] - means[i].1 / means[i].0);
            }
        }
    }

    /// One sweep of the extension; what is not held takes the mean of its neighbours into `to`.
    fn spread(
        &mut self,
        sweep: &mut impl Sweep<D>,
        particles: &Particles<D>,
        rest: f64,
        curvature: &[f64],
        to: &mut Vec<f64>,
    ) {
        let term = Extension {
            values: curvature,
            rest,
        };
        sweep.sweep(&term, particles, |_| true, &mut self.extended);
        to.clear();
        to.extend((0..particles.len()).map(|i| {
            if self.held[i] {
                curvature[i]
            } else {
                self.extended[i].value / self.layer.covered[i].filled.max(f64::MIN_POSITIVE)
            }
        }));
    }
}

impl Balanced {
    /// Adds the acceleration, m/s^2. Takes curvature on from the particles' column, and puts there what the
    /// next step begins with; an empty column begins anew.
    pub fn accelerate<const D: usize>(
        &self,
        sweep: &mut impl Sweep<D>,
        particles: &mut Particles<D>,
        surroundings: Surroundings<'_, D>,
        surface: &mut Surface<D>,
        acceleration: &mut [Vector<f64, D>],
    ) {
        let Surroundings {
            surface_tension,
            spacing,
            ..
        } = surroundings;
        let mut carried = std::mem::take(&mut particles.curvature);
        let begins = carried.is_empty();
        carried.resize(particles.len(), 0.0);
        let scratch = &mut surface.balanced;
        let tables = scratch.tables.get_or_insert_with(|| {
            let h = surroundings.smoothing_length;
            let half_space = HalfSpace::new(surroundings.kernel, h, D);
            let thresholds = Thresholds::new(&half_space, spacing);
            (half_space, thresholds)
        });
        let bump = BUMP / (spacing * spacing);
        let wetting = surroundings.wetting;
        for (&angle, &volume) in wetting.angle.iter().zip(&wetting.volume) {
            if volume > 0.0 && scratch.wedges.iter().all(|wedge| wedge.angle != angle) {
                let h = surroundings.smoothing_length;
                (scratch.wedges).push(Wedge::new(surroundings.kernel, h, D, angle));
            }
        }
        let tables = (&tables.0, &tables.1);
        (scratch.layer).look(sweep, particles, tables, wetting, &scratch.wedges);
        let curvature = &mut surface.curvature;
        curvature.clone_from(&carried);
        let rest = REST * spacing;
        for _ in 0..if begins { ROUNDS } else { 1 } {
            scratch.find_curvature(sweep, particles, surroundings, curvature);
        }
        if begins {
            for _ in 0..SPREADING {
                scratch.spread(sweep, particles, rest, curvature, &mut carried);
                std::mem::swap(curvature, &mut carried);
            }
        }
        scratch.spread(sweep, particles, rest, curvature, &mut carried);
        particles.curvature = carried;

        let Scratch {
            tables,
            layer,
            extended,
            ..
        } = scratch;
        let Some((half_space, _)) = tables else {
            return;
        };
        let sharpest = 2.0 * (D as f64 - 1.0) / spacing;
        let push = surface_tension / spacing.powi(D as i32 + 3);
        surface.active = 0;
        surface.colour.clone_from(&layer.filled);
        surface.normal.clear();
        (surface.normal).extend(layer.covered.iter().map(|sum| sum.normal));
        surface.force.clear();
        (surface.force).extend((0..particles.len()).map(|i| {
            let (normal, sum) = (layer.covered[i].normal, &extended[i]);
            let kappa = curvature[i];
            let outside = (bump * half_space.height(layer.filled[i], kappa)).min(sharpest);
            let mut force = normal * (2.0 * kappa) + layer.own_normal(i) * (2.0 * outside);
            if layer.holds(i) {
                surface.active += 1;
                let inverse = layer.facing[i].inward.matrix.inverse(LEAST_MATRIX);
                let missing = inverse.times(&sum.gradient) - sum.gradient;
                let direction = layer.points[i].direction;
                force -= missing - direction * missing.dot(&direction);
            }
            force * surface_tension + sum.push * push
        }));
        surface.net_force = balance(
            surroundings.bodies,
            particles,
            |i| layer.touches(i).then(|| layer.walls[i].normal),
            &mut surface.force,
        );
        surface.add_to(&particles.density, acceleration);
    }
}
