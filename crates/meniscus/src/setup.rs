//! What a simulation starts from, and whether it can.

mod van_der_waals;

use std::f64::consts::PI;
use std::fmt;

use crate::domain::Domain;
use crate::fluid::Fluid;
use crate::pairs::Precision;
use crate::particles::Particle;
use crate::physics::body_force::BodyForce;
use crate::physics::surface_tension::SurfaceTension;
use crate::physics::surface_tension::pairwise::Pairwise;
use crate::physics::surface_tension::pairwise::akinci::Akinci;
use crate::physics::surface_tension::pairwise::lennard_jones::LennardJones;
use crate::physics::wall::{Adhesion, Wall};
use crate::scheme::{
    AdaptiveSmoothing, DensityDiffusion, DensityForm, PressureForm, Scheme, TimeStep, VanDerWaals,
};
pub(crate) use van_der_waals::check_density;

/// Spacings that the kernel must reach for the colour of a surface to fall off over more than
/// one layer of particles.
const LEAST_REACH: f64 = 3.0;

/// Everything that a simulation starts from.
#[derive(Clone, Debug)]
pub struct Setup<const D: usize> {
    /// What is solved, and how.
    pub scheme: Scheme,
    /// Fluids; particles name them by index.
    pub fluids: Vec<Fluid>,
    /// Particles at t = 0.
    pub particles: Vec<Particle<D>>,
    /// Distance between neighbouring particles, m.
    pub spacing: f64,
    /// Periodic axes.
    pub domain: Domain<D>,
}

impl<const D: usize> Setup<D> {
    /// Whether a simulation can start from this, but for what only its first sweep shows.
    ///
    /// # Errors
    /// What [`Simulation::new`](crate::Simulation::new) would refuse, and why.
    pub fn check(&self) -> Result<(), SetupError> {
        validate(self)
    }
}

/// Why a simulation can not start.
#[derive(Clone, Debug, PartialEq)]
pub struct SetupError(pub String);

impl fmt::Display for SetupError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for SetupError {}

/// Spacings, m, at which the square of a volume and the second slope of a
/// kernel are f32, in 3D as in 2D.
const LEAST: f64 = 1e-6;
const LARGEST: f64 = 1e6;

pub(crate) fn validate<const D: usize>(setup: &Setup<D>) -> Result<(), SetupError> {
    let complain = |what: String| Err(SetupError(what));
    if setup.fluids.is_empty() {
        return complain("there is no fluid".into());
    }
    let scheme = &setup.scheme;
    let mut positive = vec![
        ("spacing", setup.spacing),
        ("smoothing length", scheme.smoothing_length),
    ];
    let mut at_least_zero = vec![
        ("artificial viscosity", scheme.artificial_viscosity),
        ("damping", scheme.damping),
        ("velocity smoothing", scheme.velocity_smoothing),
    ];
    if scheme.density == DensityForm::Summation && scheme.velocity_smoothing != 0.0 {
        return complain(
            "velocity smoothing moves particles where density follows from continuity, not by summation"
                .into(),
        );
    }
    if let Some(diffusion) = scheme.density_diffusion {
        at_least_zero.push(("strength of density diffusion", diffusion.strength));
        if diffusion.strength > DensityDiffusion::STRONGEST {
            return complain(format!(
                "strength of density diffusion must be at most {}, found {}",
                DensityDiffusion::STRONGEST,
                diffusion.strength
            ));
        }
        if scheme.density == DensityForm::Summation {
            return complain(
                "density by summation follows from places alone and cannot diffuse".into(),
            );
        }
    }
    match scheme.time_step {
        TimeStep::Fixed(dt) => positive.push(("time step", dt)),
        TimeStep::Adaptive { safety } if safety > 1.0 => {
            return complain(format!(
                "safety factor of the time step must be at most 1, found {safety}"
            ));
        }
        TimeStep::Adaptive { safety } => positive.push(("safety factor of the time step", safety)),
    }
    if scheme.precision == Precision::Mixed && !(LEAST..=LARGEST).contains(&setup.spacing) {
        return complain(format!(
            "mixed precision takes spacings from {LEAST:e} to {LARGEST:e} m, found {:e}: use double",
            setup.spacing
        ));
    }
    for fluid in &setup.fluids {
        positive.push(("density of a fluid", fluid.density));
        positive.push(("sound speed of a fluid", fluid.sound_speed));
        positive.push(("stiffness exponent of a fluid", fluid.stiffness_exponent));
        at_least_zero.push(("viscosity of a fluid", fluid.viscosity));
        at_least_zero.push(("surface tension of a fluid", fluid.surface_tension));
        if !fluid.background_pressure.is_finite() {
            return complain(format!(
                "background pressure of {} must be finite, found {}",
                fluid.name, fluid.background_pressure
            ));
        }
    }
    if let Some(SurfaceTension::Continuum(model)) = &scheme.surface_tension {
        positive.push(("smoothing length of curvature", model.curvature_smoothing));
        at_least_zero.push(("threshold of normals", model.threshold));
        let reach = scheme.kernel.support() * scheme.smoothing_length / setup.spacing;
        if reach < LEAST_REACH * (1.0 - 1e-9) {
            return complain(format!(
                "the kernel reaches {reach:.2} spacings; normals of a surface need {LEAST_REACH}: take a longer smoothing length"
            ));
        }
        let tensions = || setup.fluids.iter().map(|fluid| fluid.surface_tension);
        let highest = tensions().fold(0.0, f64::max);
        let differs = tensions().any(|sigma| sigma > 0.0 && sigma != highest);
        if differs && tensions().any(|sigma| sigma == 0.0) {
            return complain(
                "beside a fluid without surface tension, the surroundings, all others must have the same"
                    .into(),
            );
        }
    }
    validate_balanced(setup)?;
    let on_mesh = match scheme.surface_tension {
        Some(SurfaceTension::TotalVariation(_)) => Some("total variation"),
        Some(SurfaceTension::CapillaryPressure(_)) => Some("capillary pressure"),
        _ => None,
    };
    if let Some(model) = on_mesh.filter(|_| setup.fluids.len() > 1) {
        return complain(format!(
            "{model} is for one fluid with a free surface, and there are {}: take the continuum model",
            setup.fluids.len()
        ));
    }
    validate_pairwise(setup)?;
    van_der_waals::validate(setup)?;
    validate_adaptive_smoothing(scheme).map_err(SetupError)?;
    for (name, value) in at_least_zero {
        if !(value >= 0.0 && value.is_finite()) {
            return complain(format!(
                "{name} must be finite and not negative, found {value}"
            ));
        }
    }
    if !scheme.body_force.as_ref().is_none_or(BodyForce::is_sound) {
        return complain(
            "the body force must be of finite numbers, and the times of its table must not fall"
                .into(),
        );
    }
    for (index, wall) in scheme.walls.iter().enumerate() {
        if !wall.motion.is_sound() {
            return complain(format!(
                "the motion of wall {index} must be of finite numbers"
            ));
        }
        if scheme.walls[..index]
            .iter()
            .any(|other| other.body == wall.body)
        {
            return complain(format!("body {} is a wall twice", wall.body));
        }
    }
    for (name, value) in positive {
        if !(value > 0.0 && value.is_finite()) {
            return complain(format!("{name} must be positive and finite, found {value}"));
        }
    }
    for (low, high) in setup.domain.periodic.iter().flatten() {
        if !(high - low > 0.0 && (high - low).is_finite()) {
            return complain(format!(
                "a periodic axis from {low} to {high} m has no length"
            ));
        }
    }
    for (i, particle) in setup.particles.iter().enumerate() {
        let values = particle.position.norm_squared() + particle.velocity.norm_squared();
        if particle.fluid as usize >= setup.fluids.len() {
            return complain(format!(
                "particle {i} is of fluid {}, of {}",
                particle.fluid,
                setup.fluids.len()
            ));
        }
        if !(values.is_finite() && particle.mass > 0.0 && particle.mass.is_finite()) {
            return complain(format!(
                "particle {i} has a place, velocity or mass that is impossible: {particle:?}"
            ));
        }
    }
    Ok(())
}

/// What smoothing lengths that follow density ask of a scheme.
fn validate_adaptive_smoothing(scheme: &Scheme) -> Result<(), String> {
    let Some(AdaptiveSmoothing { k, epsilon, grad_h }) = scheme.adaptive_smoothing else {
        return Ok(());
    };
    if !(k > 0.0 && k.is_finite()) {
        return Err(format!(
            "k of adaptive smoothing must be positive and finite, found {k}"
        ));
    }
    if !(0.0..=1.0).contains(&epsilon) {
        return Err(format!(
            "epsilon of adaptive smoothing must be from 0 to 1, found {epsilon}"
        ));
    }
    if scheme.density != DensityForm::Summation {
        return Err(
            "adaptive smoothing takes density by summation: continuity knows nothing of a change of smoothing lengths"
                .into(),
        );
    }
    if !scheme.walls.is_empty() {
        return Err(
            "adaptive smoothing takes no walls: their particles are part of no density that smoothing lengths could follow"
                .into(),
        );
    }
    if matches!(
        scheme.surface_tension,
        Some(
            SurfaceTension::Balanced(_)
                | SurfaceTension::CapillaryPressure(_)
                | SurfaceTension::Continuum(_)
                | SurfaceTension::Pairwise(_)
        )
    ) {
        return Err(
            "this model of surface tension is calibrated for one smoothing length, and cannot go with adaptive smoothing"
                .into(),
        );
    }
    let fixed = |fluid: &VanDerWaals| !fluid.cohesion_adapts;
    if grad_h && scheme.van_der_waals.as_ref().is_some_and(fixed) {
        return Err(
            "a van der Waals fluid heats by the work of its pressure, whatever that is: it needs grad-h terms only where the range of cohesion adapts"
                .into(),
        );
    }
    if grad_h && scheme.pressure != PressureForm::OverDensitySquared {
        return Err(
            "the grad-h terms belong to the pressure form over-density-squared: no energy is behind the others with density by summation"
                .into(),
        );
    }
    Ok(())
}

/// What surface tension in balance with the pressure gradient asks of a setup.
fn validate_balanced<const D: usize>(setup: &Setup<D>) -> Result<(), SetupError> {
    /// Smoothing length in spacings from which on the surface keeps its order.
    const LEAST_SMOOTHING: f64 = 1.75;
    if !matches!(
        setup.scheme.surface_tension,
        Some(SurfaceTension::Balanced(_))
    ) {
        return Ok(());
    }
    let complain = |what: String| {
        Err(SetupError(format!(
            "the balanced model of surface tension {what}"
        )))
    };
    let smoothing = setup.scheme.smoothing_length / setup.spacing;
    if smoothing < LEAST_SMOOTHING {
        return complain(format!(
            "needs a smoothing length of 2 spacings, found {smoothing:.2}"
        ));
    }
    if setup.fluids.len() > 1 {
        return complain(format!(
            "is for one fluid with a free surface, and there are {}: take the continuum model",
            setup.fluids.len()
        ));
    }
    let adhesion = |wall: &Wall| matches!(wall.adhesion, Adhesion::Coefficient(_));
    if setup.scheme.walls.iter().any(adhesion) {
        return complain("takes a contact angle of a wall, not a coefficient of adhesion".into());
    }
    Ok(())
}

/// What forces of pairs, and walls that attract, ask of a setup.
fn validate_pairwise<const D: usize>(setup: &Setup<D>) -> Result<(), SetupError> {
    let complain = |what: String| Err(SetupError(what));
    let scheme = &setup.scheme;
    let model = match &scheme.surface_tension {
        Some(SurfaceTension::Pairwise(model)) => Some(model),
        _ => None,
    };
    for (index, wall) in scheme.walls.iter().enumerate() {
        let sound = match wall.adhesion {
            Adhesion::None => true,
            Adhesion::Coefficient(beta) => beta >= 0.0 && beta.is_finite(),
            Adhesion::ContactAngle(angle) => (0.0..=PI).contains(&angle),
        };
        if !sound {
            return complain(format!(
                "the adhesion of wall {index} must be a coefficient, finite and not negative, or an angle from 0 to pi, found {:?}",
                wall.adhesion
            ));
        }
        let takes_angle = matches!(
            (wall.adhesion, &scheme.surface_tension),
            (
                Adhesion::ContactAngle(_),
                Some(
                    SurfaceTension::Balanced(_)
                        | SurfaceTension::CapillaryPressure(_)
                        | SurfaceTension::TotalVariation(_)
                )
            )
        );
        if wall.adhesion != Adhesion::None && model.is_none() && !takes_angle {
            return complain(format!(
                "wall {index} has adhesion, which only pairwise forces and, as a contact angle, capillary pressure, the balanced model and total variation know"
            ));
        }
        if matches!(wall.adhesion, Adhesion::Coefficient(_))
            && model.is_some_and(|model| model.akinci().is_none())
        {
            return complain(format!(
                "the adhesion of wall {index} is a coefficient of Akinci's model: give a contact angle"
            ));
        }
    }
    let support = scheme.kernel.support() * scheme.smoothing_length;
    match model {
        Some(Pairwise::Akinci(Akinci {
            gamma: Some(gamma), ..
        })) if !(*gamma >= 0.0 && gamma.is_finite()) => complain(format!(
            "gamma of pairwise forces must be finite and not negative, found {gamma}"
        )),
        Some(Pairwise::LennardJones(LennardJones { rest_distance }))
            if !(*rest_distance > 0.0 && *rest_distance < support) =>
        {
            complain(format!(
                "the rest distance of Lennard-Jones forces must be positive and shorter than the kernel's support, {support} m, found {rest_distance} m"
            ))
        }
        _ => Ok(()),
    }
}
