//! What to say when a run blows up: which particle, which term, what to change.

use std::fmt;

use crate::domain::Domain;
use crate::fluid::Fluid;
use crate::particles::Particles;
use crate::physics::continuity::Continuity;
use crate::physics::momentum::Momentum;
use crate::physics::wall::Walled;
use crate::rates::{Rates, momentum};
use crate::reference;
use crate::vector::Vector;

/// The term that pushes a particle hardest.
#[derive(Clone, Debug, PartialEq)]
pub struct Culprit {
    /// Name of the term.
    pub term: &'static str,
    /// Its acceleration, m/s^2.
    pub acceleration: f64,
    /// Rate of the logarithm of density, 1/s.
    pub compression_rate: f64,
}

/// What went wrong.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Failure {
    /// A position, velocity, density or acceleration is not a finite number.
    NotFinite,
    /// Density over reference density left the bounds of [`SANE_DENSITY`].
    Density(f64),
    /// The temperature, K, of a van der Waals fluid is not above zero.
    Temperature(f64),
    /// The adaptive step, s, fell far below the acoustic limit, s.
    StepCollapsed {
        /// The step.
        step: f64,
        /// h / c
        acoustic: f64,
    },
}

/// Bounds of density over reference density in a weakly compressible flow.
pub const SANE_DENSITY: std::ops::Range<f64> = 0.3..3.0;

/// A run that blew up.
#[derive(Clone, Debug, PartialEq)]
pub struct Diverged {
    /// Step at which it was noticed.
    pub step: u64,
    /// Time, s.
    pub time: f64,
    /// Number of the particle.
    pub particle: u32,
    /// Dimensions of the flow, 2 or 3.
    pub dimension: usize,
    /// Where it is, m; the third component is zero in 2D.
    pub position: [f64; 3],
    /// What went wrong.
    pub failure: Failure,
    /// The term that pushes it hardest.
    pub culprit: Box<Culprit>,
    /// How the run was set, as far as it bears on blow-ups.
    pub circumstances: Circumstances,
}

/// What the usual causes of a blow-up show in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circumstances {
    /// The step over the shortest limit that held for it.
    pub step_over_limit: f64,
    /// Largest speed before the step, over the least speed of sound.
    pub mach_number: f64,
    /// alpha of the artificial viscosity.
    pub artificial_viscosity: f64,
}

impl fmt::Display for Diverged {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y, z] = self.position;
        let z = match self.dimension {
            2 => String::new(),
            _ => format!(", {z:.4e}"),
        };
        write!(
            f,
            "the run diverged at step {}, t = {:.6e} s: particle {} at ({x:.4e}, {y:.4e}{z}) m ",
            self.step, self.time, self.particle
        )?;
        match self.failure {
            Failure::NotFinite => write!(f, "has a value that is not a finite number")?,
            Failure::Density(ratio) => write!(
                f,
                "has {ratio:.3} times its reference density (sane: {} to {})",
                SANE_DENSITY.start, SANE_DENSITY.end
            )?,
            Failure::Temperature(temperature) => {
                write!(f, "has a temperature of {temperature:.3e} K")?;
            }
            Failure::StepCollapsed { step, acoustic } => write!(
                f,
                "forces a time step of {step:.3e} s, {:.0} times below h/c = {acoustic:.3e} s",
                acoustic / step
            )?,
        }
        write!(
            f,
            "; the strongest term there is {} ({:.3e} m/s^2)",
            self.culprit.term, self.culprit.acceleration
        )
    }
}

impl std::error::Error for Diverged {}

impl Diverged {
    /// What a user may change, most likely remedy first.
    pub fn advice(&self) -> Vec<&'static str> {
        let mut advice = Vec::new();
        let Circumstances {
            step_over_limit,
            mach_number,
            artificial_viscosity,
        } = self.circumstances;
        if step_over_limit > 1.5 {
            advice.push("shorten the time step: it is longer than its limits, which `meniscus check` prints");
        }
        if mach_number > 0.3 {
            advice.push("raise sound_speed to at least ten times the fastest flow: the flow is not slow against sound");
        }
        if let Failure::Temperature(_) = self.failure {
            advice.push("conduct heat between pairs (conduction = \"brookshaw\"), with a conductivity above zero");
        } else if artificial_viscosity < 0.05 {
            advice.push(
                "raise artificial_viscosity to 0.05 or more: a free surface disorders without it",
            );
        }
        match self.culprit.term {
            "surface tension" => {
                advice.push("refine the spacing: a feature thinner than a smoothing length has no curvature");
            }
            "artificial viscosity" | "laminar viscosity" => {
                advice.push("shorten the time step: the viscous limit is 0.125 h^2 rho / mu");
            }
            "the body force" => {
                advice.push("check the body force: it is the largest acceleration");
            }
            "a force of your own" => {
                advice.push("check your own force: it must be finite for any pair, also of a particle with itself");
            }
            _ => {}
        }
        advice.push("check the start: bodies that overlap or touch with less than a spacing push each other apart");
        if step_over_limit <= 1.5 {
            advice.push(
                "shorten the time step (time_step, or the safety factor of the adaptive step)",
            );
        }
        advice
    }
}

/// Checks one row; `None` if all is well.
pub(crate) fn check<const D: usize>(
    particles: &Particles<D>,
    fluids: &[Fluid],
    i: usize,
) -> Option<Failure> {
    let ratio = particles.density[i] / fluids[particles.fluid[i] as usize].density;
    let sum = particles.position[i].norm_squared()
        + particles.velocity[i].norm_squared()
        + particles.acceleration[i].norm_squared();
    if !(sum.is_finite() && ratio.is_finite()) {
        Some(Failure::NotFinite)
    } else if let Some(&temperature) = particles.temperature.get(i) {
        // From liquid to vapour any density is sane.
        (temperature.is_nan() || temperature <= 0.0).then_some(Failure::Temperature(temperature))
    } else if !SANE_DENSITY.contains(&ratio) {
        Some(Failure::Density(ratio))
    } else {
        None
    }
}

/// Finds the term that pushes row `i` hardest, from the O(N) sum of each alone
/// at `time` seconds.
pub(crate) fn diagnose<const D: usize>(
    rates: &Rates<D>,
    particles: &Particles<D>,
    domain: &Domain<D>,
    time: f64,
    i: usize,
) -> Culprit {
    let parts = match &rates.van_der_waals {
        Some(fluid) => {
            let [stress, cohesion] = fluid.flow.parts(i);
            let body_force = rates.body_force(time);
            vec![
                ("the stress", stress),
                ("cohesion", cohesion),
                ("the body force", body_force),
            ]
        }
        None => parts_of_a_liquid(rates, particles, domain, time, i),
    };
    let mut own_force = Vector::ZERO;
    if !rates.forces.is_empty() {
        own_force = particles.acceleration[i];
        for (_, part) in &parts {
            own_force -= *part;
        }
    }
    let (kernel, h) = (rates.scheme.kernel, rates.pairs.smoothing());
    let rate: f64 = reference::sum(&Continuity, kernel, h, domain, particles, i);
    // A value that is not a number counts as the strongest.
    let strength = |a: &Vector<f64, D>| {
        if a.norm().is_finite() {
            a.norm()
        } else {
            f64::INFINITY
        }
    };
    let (term, a) = parts
        .into_iter()
        .chain([("a force of your own", own_force)])
        .fold(("none", Vector::ZERO), |best, part| {
            if strength(&part.1) > strength(&best.1) {
                part
            } else {
                best
            }
        });
    Culprit {
        term,
        acceleration: a.norm(),
        compression_rate: rate,
    }
}

/// The parts of the acceleration, m/s^2, of a weakly compressible liquid.
fn parts_of_a_liquid<const D: usize>(
    rates: &Rates<D>,
    particles: &Particles<D>,
    domain: &Domain<D>,
    time: f64,
    i: usize,
) -> Vec<(&'static str, Vector<f64, D>)> {
    let (scheme, fluids) = (&rates.scheme, &rates.fluids[..]);
    let whole = momentum(
        scheme,
        fluids,
        rates.walls.material(fluids),
        Some(scheme.pressure),
    );
    let none = Momentum {
        pressure: None,
        artificial_viscosity: 0.0,
        viscosity: None,
        ..whole
    };
    let (kernel, h) = (rates.scheme.kernel, rates.pairs.smoothing());
    let alone = |term: Momentum<Walled>| reference::sum(&term, kernel, h, domain, particles, i);
    vec![
        (
            "the pressure gradient",
            alone(Momentum {
                pressure: whole.pressure,
                ..none
            }),
        ),
        (
            "artificial viscosity",
            alone(Momentum {
                artificial_viscosity: whole.artificial_viscosity,
                ..none
            }),
        ),
        (
            "laminar viscosity",
            alone(Momentum {
                viscosity: whole.viscosity,
                ..none
            }),
        ),
        ("surface tension", rates.surface_acceleration(particles, i)),
        ("the body force", rates.body_force(time)),
    ]
}
