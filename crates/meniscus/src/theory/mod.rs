//! Exact results that simulations are held against.
//!
//! Each function states its formula, source and units (SI throughout) and is
//! tested against a number known from elsewhere. Where a result exists for a
//! two-dimensional body (a slice through a long rod, everything per metre of
//! its length) and a three-dimensional one, `dimension` is 2 or 3. Nothing is
//! checked: a negative density gives NaN.

mod artificial_viscosity;
mod bridge;
mod cap;
mod cap_on_ball;
mod capillary;
mod dimensionless;
mod ellipsoid;
mod jet;
mod laplace;
mod meniscus;
mod oscillation;
mod sessile;
mod spreading;
mod thread;
mod two_fluid_oscillation;
mod van_der_waals;
mod viscous_oscillation;

pub use artificial_viscosity::artificial_kinematic_viscosity;
pub use bridge::Bridge;
pub use cap::{Cap, contact_angle};
pub use cap_on_ball::CapOnBall;
pub use capillary::{capillary_length, capillary_time, capillary_velocity};
pub use dimensionless::{
    bond_number, capillary_number, laplace_number, ohnesorge_number, reynolds_number, weber_number,
};
pub use ellipsoid::{ellipse_perimeter, ellipsoid_area, equivalent_radius};
pub use jet::{jet_breakup_length, jet_drop_speed};
pub use laplace::{pressure_jump, surface_tension_from_pressure};
pub use meniscus::{PlateMeniscus, jurin_rise, meniscus_height, meniscus_rise, puddle_height};
pub use oscillation::{angular_frequency, surface_tension_from_frequency};
pub use sessile::SessileDrop;
pub use spreading::{spreading_laan, spreading_pasandideh_fard, spreading_roisman};
pub use thread::thread_growth_rate;
pub use two_fluid_oscillation::{Medium, immersed_angular_frequency, two_fluid_oscillation};
pub use van_der_waals::{
    Coexistence, coexistence, reduced_pressure, spinodal, step_surface_tension,
};
pub use viscous_oscillation::{ViscousOscillation, lamb_damping_rate, viscous_oscillation};
