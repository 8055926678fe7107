//! What the equations promise, stated as physics.
//!
//! - `wave`: plane waves in a periodic strip, which others start from
//! - `viscosity`: a shear wave decays at the rate that the viscosity sets
//! - `sound`: a standing wave has the frequency that the speed of sound sets
//! - `conservation`: momentum, angular momentum, energy
//! - `motion`: free fall, drag, rigid motion, moving frames
//! - `interface`: two fluids side by side
//! - `order`: what halving the time step gains
//! - `limits`: which effect limits the time step
//! - `compression`: pressure against density
//! - `divergence`: runs that blow up say so, and why

#[path = "../common/mod.rs"]
mod common;

mod compression;
mod conservation;
mod divergence;
mod interface;
mod limits;
mod motion;
mod order;
mod sound;
mod viscosity;
mod wave;
