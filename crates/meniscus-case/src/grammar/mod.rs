//! What may stand in a case file, and what it means.
//!
//! - `document`: the top of the file
//! - `fluid`, `van_der_waals`, `body`, `shape`, `arrangement`: what there is at the start; `wall`, `wall_shape`, `motion`: around it
//! - `deformation`: a change of shape on the way
//! - `physics`: what is solved; `surface_tension`, `pairwise`: models of surface tension
//! - `output`: how often results are written; `measure`: what is measured

mod arrangement;
mod body;
mod deformation;
mod document;
mod fluid;
mod measure;
mod motion;
mod output;
mod pairwise;
mod physics;
mod shape;
mod surface_tension;
mod van_der_waals;
mod wall;
mod wall_shape;

pub(crate) use body::{DraftBody, Geometry};
pub use deformation::Deformation;
pub(crate) use document::{Draft, document};
pub use measure::{
    Arc, Base, ContactAngle, Crown, Hydrostatics, Jet, Measure, Oscillation, Sensor,
    StaticPressure, TankSurface, Waist, Window,
};
pub use output::Output;
pub(crate) use van_der_waals::DraftVanDerWaals;
pub(crate) use wall::DraftWall;
pub(crate) use wall_shape::{Surface, WallShape};
