//! One file per equation.
//!
//! - [`equation_of_state`]: pressure from density
//! - [`continuity`]: rate of density; [`summation`]: density itself
//! - [`density_diffusion`]: against noise of density
//! - [`adaptive_smoothing`]: smoothing lengths that follow density; [`grad_h`]: what forces owe to that
//! - [`momentum`]: pressure gradient and viscous force
//! - [`viscosity`]: artificial and laminar; [`viscous_stress`]: laminar, in two sweeps, of
//!   [`velocity_gradient`] and [`stress_divergence`]
//! - [`body_force`]: gravity and shaken frames
//! - [`velocity_smoothing`]: motion smoothed by XSPH
//! - [`surface_tension`]: one file per model
//! - [`van_der_waals`]: a fluid whose cohesion is its surface tension
//! - [`wall`]: solid walls of dummy particles

pub mod adaptive_smoothing;
pub mod body_force;
pub mod continuity;
pub mod density_diffusion;
pub mod equation_of_state;
pub mod grad_h;
pub mod momentum;
pub mod stress_divergence;
pub mod summation;
pub mod surface_tension;
pub mod van_der_waals;
pub mod velocity_gradient;
pub mod velocity_smoothing;
pub mod viscosity;
pub mod viscous_rest;
pub mod viscous_stress;
pub mod wall;
