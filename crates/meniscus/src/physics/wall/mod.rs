//! Solid walls of dummy particles, after Adami, Hu and Adams (2012), J. Comput. Phys. 231,
//! 7057 ("A generalized wall boundary condition for smoothed particle hydrodynamics").
//!
//! A wall is the particles of one body, in layers as thick as the kernel's support. They take
//! part in the sums of the fluid as its own particles do, and move as they are told. Before
//! each force their pressure, density and velocity follow from the fluid near them
//! ([`Extrapolation`]):
//!
//! - eq. 27  p_w = (sum_f p_f W_wf + (g - a_w) . sum_f rho_f x_wf W_wf) / sum_f W_wf
//! - eq. 28  rho_w from p_w by the equation of state
//! - eq. 22, 23  v = v_w - sum_f (v_f - v_w(x_f)) W_wf / sum_f W_wf, seen by viscous forces, no slip
//!
//! with p_w no less than zero, since a wall does not pull (adhesion is another force); with the balanced
//! surface tension, which pulls on the liquid where its surface is hollow, no less than the mean p_f, if
//! that is below zero, down to -sigma / h, or the liquid would come off. And
//! where v_w(x_f) is the velocity that the wall would have at the fluid's place, which the paper takes for
//! that of the wall particle: the same, unless the wall turns.
//!
//! A wall with free slip takes no part in viscous forces. The equation of continuity sees the
//! wall's own velocity v_w, and is completed by the adjoint of eq. 27 ([`Compression`]). Forces between two wall particles do not exist ([`Walled`]), those
//! between fluid and wall act on both: m_w times the sum of a wall particle is the force
//! that the fluid exerts on it.
//!
//! - `bodies`: which bodies are walls
//! - `motion`: how a wall moves
//! - `extrapolation`: the sums above
//! - `compression`: what walls do to the density of the fluid
//! - `walled`: the material of a flow with walls
//! - `facing`: which way walls face
//! - `layout`: where wall particles lie

mod bodies;
mod compression;
mod extrapolation;
mod facing;
pub mod layout;
mod motion;
mod walled;

pub use bodies::WallBodies;
pub use compression::{Compression, Edge, Shared};
pub use extrapolation::{Extrapolation, Neighbourhood};
pub use facing::normals;
pub use motion::{Motion, Moved};
pub use walled::Walled;

pub use super::surface_tension::pairwise::strength::{Adhesion, Bearing};

/// What a wall does to the flow along it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Slip {
    /// The fluid at the wall moves with it.
    NoSlip,
    /// No friction.
    FreeSlip,
}

/// A wall: all particles of one body, of the fluid that lies against them.
#[derive(Clone, Debug, PartialEq)]
pub struct Wall {
    /// Index of the body.
    pub body: u16,
    /// Friction.
    pub slip: Slip,
    /// How it moves.
    pub motion: Motion,
    /// How it attracts the fluid, where surface tension is by pairwise forces.
    pub adhesion: Adhesion,
    /// Strength of that attraction over that of a sharp surface of its contact angle: one, unless
    /// measured otherwise.
    pub adhesion_factor: f64,
    /// Which of these forces its pressure balances.
    pub bearing: Bearing,
}

impl Wall {
    /// A body at rest, without slip.
    pub fn new(body: u16) -> Self {
        Self {
            body,
            slip: Slip::NoSlip,
            motion: Motion::Rest,
            adhesion: Adhesion::None,
            adhesion_factor: 1.0,
            bearing: Bearing::default(),
        }
    }
}
