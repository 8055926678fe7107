//! A scheme: which equations are solved, by which formulas, with which step.

use crate::kernel::Kernel;

/// One liquid. All SI.
#[derive(Clone, Debug, PartialEq)]
pub struct Fluid {
    /// Name, for messages and output.
    pub name: String,
    /// Density at zero pressure above background, rho_0, kg/m^3.
    pub density: f64,
    /// Numerical speed of sound c, m/s.
    pub sound_speed: f64,
    /// Exponent gamma of Tait's equation of state.
    pub stiffness_exponent: f64,
    /// Pressure added everywhere, Pa.
    pub background_pressure: f64,
    /// Dynamic viscosity mu, Pa s; zero for none.
    pub viscosity: f64,
    /// Surface tension sigma against the surroundings, N/m; zero for none.
    pub surface_tension: f64,
}

/// How density is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DensityForm {
    /// D rho/Dt = rho_i sum_j V_j (v_i - v_j) . grad W
    Continuity,
    /// rho_i = sum_j m_j W
    Summation,
}

/// How the pressure gradient is discretised. Each conserves linear momentum exactly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PressureForm {
    /// -sum m_j (p_i/rho_i^2 + p_j/rho_j^2) grad W
    OverDensitySquared,
    /// -sum m_j (p_i + p_j)/(rho_i rho_j) grad W
    OverDensityProduct,
    /// -1/m_i sum (V_i^2 + V_j^2) (rho_j p_i + rho_i p_j)/(rho_i + rho_j) grad W (Hu and Adams)
    HuAdams,
}

/// How the laminar viscous force is discretised.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ViscosityForm {
    /// Morris: acts on the velocity difference (a Laplacian)
    Morris,
    /// Monaghan and Cleary: acts along the line of centres (the stress form)
    MonaghanCleary,
}

/// Acceleration of the frame or of gravity, m/s^2. In 2D the third component is ignored.
#[derive(Clone, Debug, PartialEq)]
pub enum BodyForce {
    /// The same at all times.
    Constant([f64; 3]),
    /// mean + amplitude sin(2 pi frequency t + phase); Hz, rad.
    Oscillating {
        /// Constant part.
        mean: [f64; 3],
        /// Oscillating part.
        amplitude: [f64; 3],
        /// Frequency, Hz.
        frequency: f64,
        /// Phase at t = 0, rad.
        phase: f64,
    },
    /// Straight lines between (time in s, acceleration); constant before the first and after the last.
    Table(Vec<(f64, [f64; 3])>),
}

/// A model of surface tension.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SurfaceTension {
    /// Free-surface continuum surface force of Jancik and Hyhlik.
    JancikHyhlik {
        /// a of eq. 8, default 2.
        slope: f64,
        /// b of eq. 8, default 4.
        power: u32,
        /// Normals shorter than this over h count as zero (eq. 10), default 0.01.
        threshold: f64,
    },
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
    /// Smoothing length h, m.
    pub smoothing_length: f64,
    /// How density is found.
    pub density: DensityForm,
    /// Form of the pressure gradient.
    pub pressure: PressureForm,
    /// alpha of the artificial viscosity; zero for none.
    pub artificial_viscosity: f64,
    /// Form of the laminar viscous force; acts where a fluid's viscosity is not zero.
    pub viscosity: ViscosityForm,
    /// Body force, if any.
    pub body_force: Option<BodyForce>,
    /// Model of surface tension, if any; acts where a fluid's surface tension is not zero.
    pub surface_tension: Option<SurfaceTension>,
    /// Rate k of a drag -k v that brings a flow to rest, 1/s; zero for none.
    pub damping: f64,
    /// Time step.
    pub time_step: TimeStep,
}
