//! Marching in time.
//!
//! - [`integrator`]: kick, drift, density, forces, kick
//! - [`step`]: limits on the time step

pub mod integrator;
pub mod step;
