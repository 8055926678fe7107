//! What an experimenter would measure.
//!
//! Functions of plain columns: positions in m, masses in kg, densities in
//! kg/m^3, pressures in Pa, one entry per particle. Where columns differ in
//! length, the shortest counts. In two dimensions everything is per metre of
//! the third: a mass is in kg/m, an energy in J/m, a volume in m^2. Positions are those of
//! one whole body: a film alone may repeat itself.
//!
//! - totals over all particles: [`centre_of_mass`], [`linear_momentum`], [`kinetic_energy`], ...
//! - the body's shape: [`PrincipalAxes`], [`semi_axes_by_tips`], [`surface_energy`]
//! - how round a body is, by direction: [`Outline`]
//! - a splash: [`Crown`]; a drop on a wall ([`Base`]): [`DropOnWall`]; the surface in a tank: [`TankSurface`]
//! - which particles lie at a free surface: [`surface_particles`]
//! - drops that merge, break or spread: [`waist`], [`fragments`], [`Bag`], [`contacts`], [`width_across`]; a jet and its
//!   drops: [`Jet`]
//! - virtual pressure sensors: [`Sensor`]
//! - pressure against depth: [`PressureProfile`]
//! - pressure against radius, and what surface tension it shows: [`radial_profile`],
//!   [`StaticSurfaceTension`]
//! - how a drop's density ends: [`SurfaceLayer`], [`outer_rings`]; its stress: [`StressProfile`];
//!   that of a flat film: [`FilmStress`]
//! - a fitted oscillation and what surface tension it shows: [`DampedCosine`],
//!   [`OscillationSurfaceTension`]
//! - a fitted power law: [`PowerLaw`]

mod arc;
mod bag;
mod base;
mod circle;
mod compression_energy;
mod contact_angle;
mod crown;
mod damped_cosine;
mod estimate;
mod film_stress;
mod fit_error;
mod foot;
mod fragments;
mod jet;
mod level;
mod meniscus;
mod oscillation;
mod outline;
mod power_law;
mod pressure_profile;
mod radial;
#[cfg(test)]
mod samples;
mod semi_axes;
mod sensor;
mod stress_profile;
mod surface;
mod surface_layer;
mod totals;
mod waist;
mod width;

pub use bag::Bag;
pub use base::{Base, Plane};
pub use compression_energy::{compression_energy, specific_compression_energy};
pub use contact_angle::DropOnWall;
pub use crown::Crown;
pub use damped_cosine::DampedCosine;
pub use estimate::Estimate;
pub use film_stress::FilmStress;
pub use fit_error::FitError;
pub use fragments::{contacts, fragments};
pub use jet::{FreeDrop, Jet};
pub use meniscus::{Meniscus, TankSurface, surface_profile};
pub use oscillation::OscillationSurfaceTension;
pub use outline::Outline;
pub use power_law::PowerLaw;
pub use pressure_profile::PressureProfile;
pub use radial::{RadialBin, StaticSurfaceTension, radial_profile};
pub use semi_axes::{
    PrincipalAxes, semi_axes_along_coordinates, semi_axes_by_tips, surface_energy,
};
pub use sensor::{Reading, Sensor};
pub use stress_profile::StressProfile;
pub use surface::surface_particles;
pub use surface_layer::{SurfaceLayer, outer_rings};
pub use totals::{
    angular_momentum, centre_of_mass, kinetic_energy, linear_momentum, maximum_speed, range,
};
pub use waist::waist;
pub use width::width_across;
