//! Limits on the time step, with h the smoothing length, s the radius of the
//! kernel's support, nu = mu / rho:
//!
//! - acoustic:  0.1 s / (c + |v|)
//! - force:     0.25 sqrt(h / |a|)
//! - viscous:   0.125 h^2 / nu
//! - capillary: 0.25 sqrt(rho h^3 / (2 pi sigma))
//! - pairwise:  0.5 / omega
//! - thermal:   0.03 s^2 / chi
//!
//! where omega is the frequency of particles that swing by stiff forces of pairs (Lennard-Jones);
//! a leapfrog bears 2 / omega; and chi = kappa / (rho c_v). Force, viscous and capillary as in Morris (2000), Int. J. Numer. Meth. Fluids 33, 333.
//! The first is stated by the support, since kernels of different support
//! differ in h at the same resolution: 0.3 h / c for a support of 3 h, 0.2 h / c
//! for 2 h.

use std::fmt;

use crate::fluid::Fluid;
use crate::physics::van_der_waals::flow::Stiffness;

/// The largest step that each effect allows, s; infinite where it is absent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepLimits {
    /// Sound crossing a particle.
    pub acoustic: f64,
    /// The largest acceleration.
    pub force: f64,
    /// Diffusion of momentum.
    pub viscous: f64,
    /// The shortest capillary wave.
    pub capillary: f64,
    /// Stiff forces between pairs.
    pub pairwise: f64,
    /// Diffusion of heat.
    pub thermal: f64,
}

/// An effect that limits the step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limit {
    /// Sound.
    Acoustic,
    /// Acceleration.
    Force,
    /// Viscosity.
    Viscous,
    /// Surface tension.
    Capillary,
    /// Stiff forces between pairs.
    Pairwise,
    /// Conduction of heat.
    Thermal,
}

impl fmt::Display for Limit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Limit::Acoustic => "acoustic",
            Limit::Force => "force",
            Limit::Viscous => "viscous",
            Limit::Capillary => "capillary",
            Limit::Pairwise => "pairwise",
            Limit::Thermal => "thermal",
        })
    }
}

impl StepLimits {
    /// Limits for `fluids`, with the largest speed (m/s) and acceleration (m/s^2) of the flow.
    pub fn new(
        fluids: &[Fluid],
        smoothing_length: f64,
        support: f64,
        largest_speed: f64,
        largest_acceleration: f64,
    ) -> Self {
        let h = smoothing_length;
        let least =
            |limit: &dyn Fn(&Fluid) -> f64| fluids.iter().map(limit).fold(f64::INFINITY, f64::min);
        Self {
            acoustic: least(&|fluid| 0.1 * support / (fluid.sound_speed + largest_speed)),
            force: 0.25 * (h / largest_acceleration).sqrt(),
            viscous: least(&|fluid| 0.125 * h * h * fluid.density / fluid.viscosity),
            capillary: least(&|fluid| {
                let period = std::f64::consts::TAU * fluid.surface_tension;
                0.25 * (fluid.density * h.powi(3) / period).sqrt()
            }),
            pairwise: f64::INFINITY,
            thermal: f64::INFINITY,
        }
    }

    /// The same for a van der Waals fluid, whose density and temperature set the speed of sound
    /// and what diffuses; of the support, m, and the largest speed of the flow, m/s.
    pub fn with_van_der_waals(
        self,
        stiffness: Stiffness,
        support: f64,
        largest_speed: f64,
    ) -> Self {
        // 0.125 h^2 where the support is 2 h.
        let square = 0.125 * (0.5 * support).powi(2);
        Self {
            acoustic: 0.1 * support / (stiffness.sound_speed + largest_speed),
            viscous: square / stiffness.viscous_diffusivity,
            thermal: square / stiffness.thermal_diffusivity,
            ..self
        }
    }

    /// The same with stiff forces of this square of a frequency, 1/s^2.
    pub fn with_stiffness(self, stiffness: f64) -> Self {
        Self {
            pairwise: 0.5 / stiffness.sqrt(),
            ..self
        }
    }

    /// Each limit by name.
    pub fn all(&self) -> [(Limit, f64); 6] {
        [
            (Limit::Acoustic, self.acoustic),
            (Limit::Force, self.force),
            (Limit::Viscous, self.viscous),
            (Limit::Capillary, self.capillary),
            (Limit::Pairwise, self.pairwise),
            (Limit::Thermal, self.thermal),
        ]
    }

    /// The shortest, and which it is.
    pub fn governing(&self) -> (Limit, f64) {
        self.all()
            .into_iter()
            .fold((Limit::Acoustic, f64::INFINITY), |best, next| {
                if next.1 < best.1 { next } else { best }
            })
    }
}
