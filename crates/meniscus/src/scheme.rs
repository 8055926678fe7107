//! A scheme: which equations are solved, by which formulas, with which step.

pub use crate::fluid::Fluid;
use crate::kernel::Kernel;
use crate::pairs::Precision;
pub use crate::physics::adaptive_smoothing::AdaptiveSmoothing;
pub use crate::physics::body_force::BodyForce;
pub use crate::physics::density_diffusion::{DensityDiffusion, DiffusionForm};
pub use crate::physics::momentum::PressureForm;
pub use crate::physics::surface_tension::SurfaceTension;
pub use crate::physics::van_der_waals::{Conduction, Substance, VanDerWaals};
pub use crate::physics::viscosity::ViscosityForm;
pub use crate::physics::wall::{Adhesion, Bearing, Motion, Slip, Wall};

/// How density is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DensityForm {
    /// D rho/Dt = rho_i sum_j V_j (v_i - v_j) . grad W
    Continuity,
    /// D rho_i/Dt = m_i sum_j (v_i - v_j) . grad W (Ott and Schnetter), for fluids of different density
    Number,
    /// D rho/Dt with the gradient of velocity corrected: exact for a linear motion at a free surface too
    Corrected,
    /// rho_i = sum_j m_j W
    Summation,
}

/// How the flow is marched in time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Integrator {
    /// Kick-drift-kick; see [`crate::time::integrator`].
    Symplectic,
}

/// How long a time step is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TimeStep {
    /// Always this long, s.
    Fixed(f64),
    /// The shortest of the acoustic, force, viscous and capillary limits, times `safety`.
    Adaptive {
        /// Factor on all limits, at most 1.
        safety: f64,
    },
}

/// Everything that is solved, beside the particles themselves.
#[derive(Clone, Debug, PartialEq)]
pub struct Scheme {
    /// Smoothing kernel.
    pub kernel: Kernel,
    /// Smoothing length h, m; h_0 where lengths follow density.
    pub smoothing_length: f64,
    /// How smoothing lengths follow density, if they do; then density is by summation.
    pub adaptive_smoothing: Option<AdaptiveSmoothing>,
    /// How density is found.
    pub density: DensityForm,
    /// Diffusion of density, if any. Not with density by summation.
    pub density_diffusion: Option<DensityDiffusion>,
    /// Form of the pressure gradient.
    pub pressure: PressureForm,
    /// alpha of the artificial viscosity; zero for none.
    pub artificial_viscosity: f64,
    /// Form of the laminar viscous force; acts where a fluid's viscosity is not zero.
    pub viscosity: ViscosityForm,
    /// Body force, if any.
    pub body_force: Option<BodyForce>,
    /// epsilon of XSPH, by which particles move with their surroundings; zero for none. Not with
    /// density by summation.
    pub velocity_smoothing: f64,
    /// Model of surface tension, if any; acts where a fluid's surface tension is not zero.
    pub surface_tension: Option<SurfaceTension>,
    /// Equation of state, cohesion and heat of a van der Waals fluid, if it is one; in place of
    /// Tait's equation, of a model of surface tension and of the forms of pressure and viscosity.
    pub van_der_waals: Option<VanDerWaals>,
    /// Rate k of a drag -k v that brings a flow to rest, 1/s; zero for none.
    pub damping: f64,
    /// Walls: bodies that are not fluid. Their particles need no density, pressure or velocity.
    pub walls: Vec<Wall>,
    /// Integrator.
    pub integrator: Integrator,
    /// Time step.
    pub time_step: TimeStep,
    /// In what numbers the pairs are worked out.
    pub precision: Precision,
}

impl Scheme {
    /// Weakly compressible flow with artificial viscosity 0.1 and adaptive
    /// steps; Wendland's C2 kernel with this smoothing length, m.
    pub fn new(smoothing_length: f64) -> Self {
        Self {
            kernel: Kernel::WendlandC2,
            smoothing_length,
            adaptive_smoothing: None,
            density: DensityForm::Continuity,
            density_diffusion: None,
            pressure: PressureForm::OverDensitySquared,
            artificial_viscosity: 0.1,
            viscosity: ViscosityForm::MonaghanCleary,
            body_force: None,
            velocity_smoothing: 0.0,
            surface_tension: None,
            van_der_waals: None,
            damping: 0.0,
            walls: Vec::new(),
            integrator: Integrator::Symplectic,
            time_step: TimeStep::Adaptive { safety: 1.0 },
            precision: Precision::Double,
        }
    }

    /// A van der Waals fluid: Lucy's kernel with this support, m, density by summation, no
    /// artificial viscosity.
    pub fn van_der_waals(support: f64, model: VanDerWaals) -> Self {
        Self {
            kernel: Kernel::LucyQuartic,
            density: DensityForm::Summation,
            artificial_viscosity: 0.0,
            viscosity: ViscosityForm::Stress,
            van_der_waals: Some(model),
            ..Self::new(support)
        }
    }
}

impl TimeStep {
    /// Whether the step follows the flow.
    pub fn is_adaptive(self) -> bool {
        matches!(self, TimeStep::Adaptive { .. })
    }
}
