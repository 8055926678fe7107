//! A flat film of a case's liquid, and what it pulls with.
//!
//! Close packed, jittered out of any order, brought to rest by a drag; it repeats along itself, and
//! both its surfaces are free. At rest nothing presses across it, so it pulls with twice its
//! surface tension.

use std::collections::BTreeMap;

use meniscus::measure::FilmStress;
use meniscus::physics::surface_tension::pairwise::Pairwise;
use meniscus::physics::surface_tension::pairwise::akinci::{Curvature, Normalisation, Reading};
use meniscus::physics::surface_tension::pairwise::estimate::Resolution;
use meniscus::rates::{Dimension, Space};
use meniscus::scheme::{Fluid, Scheme, TimeStep};
use meniscus::shape::{Arrangement, Pattern, Shape};
use meniscus::{Domain, Precision, Setup, Simulation, SurfaceTension, Vector};
use meniscus_case::{Case, default_sound_speed};

use crate::failure::Failure;

/// Largest displacement at the start, in spacings: none of the lattice is left.
const JITTER: f64 = 0.5;
/// Time to come to rest, and that of the measurements after it, in sqrt(rho dx^3 / sigma).
const REST: f64 = 60.0;
const MEASURED: f64 = 20.0;
/// How often it is measured.
const TIMES: usize = 5;
/// Rate of the drag over sqrt(sigma / (rho dx^3)).
const DRAG: f64 = 0.06;

/// A film to be made of one fluid of a case.
#[derive(Clone, Debug)]
pub struct Film {
    /// Whose it is.
    pub fluid: Fluid,
    model: Pairwise,
    scheme: Scheme,
    spacing: f64,
    dimension: usize,
    /// The speeds of the case from which its sound speed follows; none where it is given.
    speeds: Option<meniscus_case::SpeedScales>,
}

impl Film {
    /// Of a fluid of a case, if pairwise forces are its surface tension.
    pub fn new(case: &Case, index: usize) -> Option<Self> {
        let Some(SurfaceTension::Pairwise(model)) = case.scheme.surface_tension else {
            return None;
        };
        let (from, fluid) = (&case.scheme, &case.fluids[index]);
        let spacing = case.spacing;
        let rate = (fluid.surface_tension / (fluid.density * spacing.powi(3))).sqrt();
        let scheme = Scheme {
            kernel: from.kernel,
            density: from.density,
            density_diffusion: from.density_diffusion,
            pressure: from.pressure,
            velocity_smoothing: from.velocity_smoothing,
            surface_tension: Some(SurfaceTension::Pairwise(model)),
            damping: DRAG * rate,
            time_step: TimeStep::Adaptive { safety: 1.0 },
            precision: Precision::Double,
            ..Scheme::new(from.smoothing_length)
        };
        Some(Self {
            fluid: Fluid {
                // Rest does not depend on it.
                viscosity: 0.0,
                cohesion_factor: 1.0,
                ..fluid.clone()
            },
            model,
            scheme,
            spacing,
            dimension: case.dimension,
            speeds: (!case.given.sound_speed[index]).then_some(case.speeds),
        })
    }

    fn resolution(&self) -> Resolution {
        Resolution {
            kernel: self.scheme.kernel,
            smoothing_length: self.scheme.smoothing_length,
            spacing: self.spacing,
            dimension: self.dimension,
        }
    }

    /// The liquid with forces of this strength, over that of a sharp surface.
    fn liquid(&self, factor: f64) -> Fluid {
        let mut fluid = Fluid {
            cohesion_factor: factor,
            ..self.fluid.clone()
        };
        if let Some(speeds) = self.speeds {
            let cohesion = self.model.cohesion_pressure(&fluid, &self.resolution());
            let left = (cohesion - fluid.background_pressure).max(0.0);
            fluid.sound_speed = default_sound_speed(&meniscus_case::SpeedScales {
                cohesion: (left / fluid.density).sqrt(),
                ..speeds
            });
        }
        fluid
    }

    /// Everything that its tension over the one asked for depends on: in units of density, spacing and
    /// surface tension, so that it is the same film at any scale.
    pub fn inputs(&self) -> BTreeMap<String, String> {
        let Fluid {
            density,
            surface_tension,
            ..
        } = self.fluid;
        let pressure = surface_tension / self.spacing;
        let speed = (pressure / density).sqrt();
        let number = |value: f64| format!("{value:.9e}");
        let fluid = self.liquid(1.0);
        let mut inputs = BTreeMap::from(
            [
                ("model", self.model.name().to_owned()),
                ("dimension", self.dimension.to_string()),
                ("kernel", self.scheme.kernel.name().to_owned()),
                (
                    "smoothing_length_over_spacing",
                    number(self.scheme.smoothing_length / self.spacing),
                ),
                (
                    "sound_speed_over_capillary_speed",
                    number(fluid.sound_speed / speed),
                ),
                (
                    "sound_speed",
                    if self.speeds.is_some() {
                        "default"
                    } else {
                        "given"
                    }
                    .to_owned(),
                ),
                ("stiffness_exponent", number(fluid.stiffness_exponent)),
                (
                    "background_pressure_over_capillary_pressure",
                    number(fluid.background_pressure / pressure),
                ),
                ("density_form", format!("{:?}", self.scheme.density)),
                (
                    "density_diffusion",
                    format!("{:?}", self.scheme.density_diffusion),
                ),
                ("pressure_form", format!("{:?}", self.scheme.pressure)),
                ("velocity_smoothing", number(self.scheme.velocity_smoothing)),
            ]
            .map(|(name, value)| (name.to_owned(), value)),
        );
        if let Pairwise::LennardJones(model) = self.model {
            let ratio = number(model.rest_distance / self.spacing);
            inputs.insert("rest_distance_over_spacing".into(), ratio);
        }
        if let Some(akinci) = self.model.akinci() {
            inputs.insert("akinci".into(), format!("{akinci:?}"));
            // As printed these are out of units, and know what a metre is.
            if akinci.curvature != Curvature::None
                || akinci.normalisation == Normalisation::Printed
                || akinci.reading == Reading::Acceleration
            {
                inputs.insert("density".into(), number(density));
                inputs.insert("spacing".into(), number(self.spacing));
                inputs.insert("surface_tension".into(), number(surface_tension));
            }
        }
        if let Pairwise::GaussianPair(form) = self.model {
            inputs.insert("form".into(), format!("{form:?}"));
        }
        inputs
    }

    /// The surface tension, N/m, that it shows with forces of this strength, over that of a sharp surface;
    /// `seed` says which film.
    ///
    /// # Errors
    /// If the film blows up.
    pub fn surface_tension(&self, factor: f64, seed: u64) -> Result<f64, Failure> {
        match self.dimension {
            2 => self.tension_in::<2>(factor, seed),
            _ => self.tension_in::<3>(factor, seed),
        }
    }

    fn tension_in<const D: usize>(&self, factor: f64, seed: u64) -> Result<f64, Failure>
    where
        Space: Dimension<D>,
    {
        let domain = self.domain::<D>();
        let setup = Setup {
            scheme: self.scheme.clone(),
            fluids: vec![self.liquid(factor)],
            particles: self.particles(&domain, seed)?,
            spacing: self.spacing,
            domain,
        };
        let mut simulation =
            Simulation::<D>::new(setup).map_err(|error| Failure::new(error.to_string()))?;
        let Fluid {
            density,
            surface_tension,
            ..
        } = self.fluid;
        let time = (density * self.spacing.powi(3) / surface_tension).sqrt();
        let mut sum = 0.0;
        for part in 1..=TIMES {
            let until = REST + MEASURED * part as f64 / TIMES as f64;
            simulation.advance_to(until * time).map_err(|diverged| {
                Failure::diverged(&diverged, "a film of this liquid does not hold together")
            })?;
            sum += pull(&simulation).unwrap_or(f64::NAN);
        }
        Ok(0.5 * sum / TIMES as f64)
    }

    /// As wide along each axis as the lattice fits into, and thick enough to have a bulk.
    fn domain<const D: usize>(&self) -> Domain<D> {
        let reach = self.scheme.kernel.support() * self.scheme.smoothing_length / self.spacing;
        let width = match D {
            2 => (6.0 * reach).max(24.0),
            _ => (2.5 * reach).max(10.0),
        };
        let periods = [1.0, 3.0_f64.sqrt()];
        let mut domain = Domain::default();
        for (axis, period) in domain.periodic[..D - 1].iter_mut().zip(periods) {
            let length = (width / period).ceil() * period * self.spacing;
            *axis = Some((0.0, length));
        }
        domain
    }

    fn particles<const D: usize>(
        &self,
        domain: &Domain<D>,
        seed: u64,
    ) -> Result<Vec<meniscus::Particle<D>>, Failure> {
        let reach = self.scheme.kernel.support() * self.scheme.smoothing_length;
        let thickness = (3.0 * reach).max(12.0 * self.spacing);
        let high = std::array::from_fn(|d| domain.periodic[d].map_or(thickness, |axis| axis.1));
        let block = Shape::Block {
            low: Vector::ZERO,
            high: Vector(high),
        };
        let arrangement = Arrangement {
            jitter: JITTER,
            seed,
            ..Arrangement::new(Pattern::ClosePacked, self.spacing)
        };
        let limit = (2.0 * arrangement.estimate(&block)) as usize;
        let mut particles = (arrangement.body(&block, self.fluid.density, limit))
            .map_err(|error| Failure::new(format!("a film cannot be laid: {error}")))?;
        for particle in &mut particles {
            domain.wrap(&mut particle.position);
        }
        Ok(particles)
    }
}

/// The tension of a whole film, N/m.
fn pull<const D: usize>(simulation: &Simulation<D>) -> Option<f64> {
    let (particles, scheme) = (simulation.particles(), simulation.scheme());
    let range = scheme.kernel.support() * scheme.smoothing_length;
    let force = |i, j, offset| simulation.force_at_rest([i, j], offset);
    let width = 0.5 * simulation.spacing();
    let stress = FilmStress::measure(
        &particles.position,
        simulation.domain(),
        range,
        width,
        force,
    )?;
    Some(stress.tension())
}
