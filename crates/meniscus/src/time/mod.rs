//! Marching in time.
//!
//! - [`integrator`]: kick, drift, density, forces, kick
//! - [`step`]: limits on the time step
//! - [`work`]: what is done on the liquid from outside

pub mod integrator;
pub mod step;
pub mod work;
