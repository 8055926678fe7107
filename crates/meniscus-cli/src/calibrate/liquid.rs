//! What holds the liquid of a film together, and how it is brought to rest.

use meniscus::physics::surface_tension::pairwise::Pairwise;
use meniscus::physics::surface_tension::pairwise::estimate::Resolution;
use meniscus::scheme::{Fluid, Scheme, Substance, TimeStep, VanDerWaals};
use meniscus::{Precision, SurfaceTension};
use meniscus_case::{Case, SpeedScales, default_sound_speed};

use super::film::{Film, Strength};

/// Degrees of freedom of molecules that take up what heat there is: a film is to be as warm as it was asked to be.
const ALL_HEAT: f64 = 1e6;
/// Viscosity of a van der Waals liquid over sqrt(rho sigma dx): at rest it has no part.
const VISCOSITY: f64 = 0.3;
/// Largest displacement at the start, in spacings: none of the lattice is left.
const JITTER: f64 = 0.5;
/// The same for a van der Waals film, and how thin it is laid, so that it is nowhere denser than it can be. It loses
/// its order as it draws together.
const LITTLE_JITTER: f64 = 0.25;
const THIN: f64 = 1.3;

/// The equations of a case as far as a film at rest knows them, if a film of this fluid would tell anything.
pub(super) fn scheme(case: &Case) -> Option<Scheme> {
    let from = &case.scheme;
    let plain = Scheme {
        kernel: from.kernel,
        density: from.density,
        pressure: from.pressure,
        time_step: TimeStep::Adaptive { safety: 1.0 },
        precision: Precision::Double,
        ..Scheme::new(from.smoothing_length)
    };
    if let Some(model) = from.van_der_waals {
        let substance = Substance {
            degrees_of_freedom: ALL_HEAT,
            ..model.substance
        };
        return Some(Scheme {
            adaptive_smoothing: from.adaptive_smoothing,
            artificial_viscosity: from.artificial_viscosity,
            viscosity: from.viscosity,
            van_der_waals: Some(VanDerWaals {
                substance,
                conductivity: 0.0,
                bulk_viscosity: 0.0,
                ..model
            }),
            ..plain
        });
    }
    let Some(SurfaceTension::Pairwise(_)) = from.surface_tension else {
        return None;
    };
    Some(Scheme {
        density_diffusion: from.density_diffusion,
        velocity_smoothing: from.velocity_smoothing,
        surface_tension: from.surface_tension,
        ..plain
    })
}

impl Film {
    /// The forces of pairs that hold it together, if they are what does.
    pub(super) fn pairwise(&self) -> Option<Pairwise> {
        match self.scheme.surface_tension {
            Some(SurfaceTension::Pairwise(model)) => Some(model),
            _ => None,
        }
    }

    fn resolution(&self) -> Resolution {
        Resolution {
            kernel: self.scheme.kernel,
            smoothing_length: self.scheme.smoothing_length,
            spacing: self.spacing,
            dimension: self.dimension,
        }
    }

    /// The liquid with a cohesion of this strength, over that of a sharp surface.
    pub(super) fn liquid(&self, factor: f64) -> Fluid {
        let mut fluid = Fluid {
            cohesion_factor: factor,
            ..self.fluid.clone()
        };
        if self.scheme.van_der_waals.is_some() {
            let unit = fluid.density * fluid.surface_tension * self.spacing;
            fluid.viscosity = VISCOSITY * unit.sqrt();
        }
        if let (Some(model), Some(speeds)) = (self.pairwise(), self.speeds) {
            let cohesion = model.cohesion_pressure(&fluid, &self.resolution());
            let left = (cohesion - fluid.background_pressure).max(0.0);
            fluid.sound_speed = default_sound_speed(&SpeedScales {
                cohesion: (left / fluid.density).sqrt(),
                ..speeds
            });
        }
        fluid
    }

    /// The equations of that liquid.
    pub(super) fn scheme_of(&self, strength: Strength) -> Scheme {
        let mut scheme = self.scheme.clone();
        if let Some(model) = &mut scheme.van_der_waals {
            model.substance = model.substance.stronger(strength.cohesion);
        }
        scheme
    }

    /// How thick a film is over the reach of its forces: so that its surfaces do not feel each other, those of pairwise
    /// forces over any layers that the particles beneath them lie in.
    pub(super) fn thickness(&self) -> f64 {
        match self.scheme.van_der_waals {
            Some(_) => 2.0,
            None => 3.0,
        }
    }

    /// How broad it is in space over that reach; one of long reach has particles enough.
    pub(super) fn breadth(&self) -> f64 {
        match self.scheme.van_der_waals {
            Some(_) => 1.5,
            None => 2.5,
        }
    }

    /// By how much of a spacing, at most, its particles are displaced at the start.
    pub(super) fn jitter(&self) -> f64 {
        match self.scheme.van_der_waals {
            Some(_) => LITTLE_JITTER,
            None => JITTER,
        }
    }

    /// How much thinner than at rest it is laid.
    pub(super) fn thinness(&self) -> f64 {
        match self.scheme.van_der_waals {
            Some(_) => THIN,
            None => 1.0,
        }
    }

    /// How far its forces reach, m, where smoothing lengths do not follow density.
    pub(super) fn reach(&self) -> f64 {
        let range = (self.scheme.van_der_waals).map_or(1.0, |model| model.cohesion_range);
        range * self.scheme.kernel.support() * self.scheme.smoothing_length
    }
}
