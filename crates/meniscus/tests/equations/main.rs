//! What the equations promise, stated as physics.
//!
//! - `wave`: plane waves in a periodic strip, which others start from
//! - `viscosity`: a shear wave decays at the rate that the viscosity sets
//! - `sound`: a standing wave has the frequency that the speed of sound sets
//! - `conservation`: momentum, angular momentum, energy
//! - `motion`: free fall, drag, rigid motion, moving frames, two fluids at rest
//! - `order`: what halving the time step gains
//! - `limits`: which effect limits the time step
//! - `divergence`: runs that blow up say so, and why

#[path = "../common/mod.rs"]
mod common;

mod conservation;
mod divergence;
mod limits;
mod motion;
mod order;
mod sound;
mod viscosity;
mod wave;
