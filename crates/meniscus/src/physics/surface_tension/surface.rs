//! What a model of the surface finds on the way.

use super::{balanced, capillary_pressure, continuum, jancik_hyhlik, total_variation};
use crate::particles::Particles;
use crate::vector::Vector;

/// What the model found in the last step: columns of one row per particle.
#[derive(Debug, Default)]
pub struct Surface<const D: usize> {
    /// Smoothed colour, 1 inside the liquid.
    pub colour: Vec<f64>,
    /// n, 1/m, pointing into the liquid.
    pub normal: Vec<Vector<f64, D>>,
    /// Curvature, 1/m: positive for a convex surface. Away from it zero, or that of the surface nearby.
    pub curvature: Vec<f64>,
    /// Force per volume, N/m^3.
    pub force: Vec<Vector<f64, D>>,
    /// What particles of walls bear of it, N (N/m in 2D), where the model has it for each.
    pub(crate) borne: Vec<Vector<f64, D>>,
    /// What pairwise forces add to the pressure by the virial theorem, Pa: the mean over the axes
    /// of sum_j r_ij . F_ij / (2 V_i) (Tartakovsky and Meakin 2005). Negative where they attract;
    /// never fed back. Empty for other models.
    pub virial_pressure: Vec<f64>,
    /// What the forces on all particles add up to, N (N/m in 2D), before a model balances
    /// them: zero for an exact force on closed surfaces.
    pub net_force: Vector<f64, D>,
    pub(super) active: usize,
    pub(super) balanced: balanced::Scratch<D>,
    pub(super) jancik_hyhlik: jancik_hyhlik::Scratch<D>,
    pub(super) continuum: continuum::Scratch<D>,
    pub(super) capillary_pressure: capillary_pressure::Scratch<D>,
    pub(super) total_variation: total_variation::Scratch<D>,
}

impl<const D: usize> Surface<D> {
    /// Number of surface-active particles, those with a normal to be relied on.
    pub fn active(&self) -> usize {
        self.active
    }

    /// What the continuum model multiplies sigma kappa n by; none before its first force.
    pub fn strength(&self) -> Option<f64> {
        Some(self.continuum.calibration?.strength)
    }

    /// Whether what a flat layer tells is known.
    pub(crate) fn is_calibrated(&self) -> bool {
        self.continuum.calibration.is_some()
    }

    /// The sum of the forces on all particles, N (N/m in 2D).
    pub(super) fn sum_of_forces(&self, particles: &Particles<D>) -> Vector<f64, D> {
        let mut sum = Vector::ZERO;
        for (i, force) in self.force.iter().enumerate() {
            sum += *force * particles.volume(i);
        }
        sum
    }

    /// Adds the force over density to `acceleration`, m/s^2.
    pub(crate) fn add_to(&self, densities: &[f64], acceleration: &mut [Vector<f64, D>]) {
        for ((a, force), density) in acceleration.iter_mut().zip(&self.force).zip(densities) {
            *a += *force * (1.0 / density);
        }
    }
}
