//! Flows ruled by surface tension, by smoothed particle hydrodynamics.
//!
//! A simulation is particles, fluids and a [`Scheme`] put together, and then
//! marched in time. All values are SI. The smallest that is complete:
//!
//! ```
//! use meniscus::scheme::PressureForm;
//! use meniscus::shape::{Arrangement, Pattern, Shape};
//! use meniscus::{Domain, Fluid, Scheme, Setup, Simulation, SurfaceTension, Vector};
//!
//! // A disc of water, 1 mm across, on a triangular lattice.
//! let spacing = 0.05e-3;
//! let mut water = Fluid::new("water", 998.0);
//! water.surface_tension = 0.0728;
//! water.sound_speed = 5.0;
//! let disc = Shape::Ball { centre: Vector([0.0, 0.0]), radius: 0.5e-3 };
//! let particles = Arrangement::new(Pattern::ClosePacked, spacing).body(&disc, water.density, 10_000)?;
//!
//! let mut scheme = Scheme::new(2.0 * spacing);
//! scheme.surface_tension = Some(SurfaceTension::default());
//! scheme.pressure = PressureForm::OverDensityProduct; // what this model is exact with
//! scheme.damping = 4000.0; // brings the disc to rest
//! let (fluids, domain) = (vec![water], Domain::default());
//! let mut simulation = Simulation::new(Setup { scheme, fluids, particles, spacing, domain })?;
//! simulation.advance_to(5e-3)?;
//!
//! // The pressure inside rises to sigma / R = 146 Pa.
//! let p = simulation.particles();
//! let inside = (0..p.len()).filter(|&i| p.position[i].norm() < 0.25e-3);
//! let (sum, count) = inside.fold((0.0, 0), |(sum, count), i| (sum + p.pressure[i], count + 1));
//! assert!((sum / count as f64 / 146.0 - 1.0).abs() < 0.03);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # The tour
//!
//! Who simulates needs:
//! - [`shape`]: bodies, and how particles fill them; [`domain`]: which axes repeat
//! - [`fluid`], [`scheme`], [`kernel`]: what is solved, and with what
//! - [`setup`], [`simulation`]: the start, and the march in time; [`snapshot`]: to stop and go on;
//!   [`divergence`]: what a run says that blew up
//! - [`walls`]: what the fluid exerts on walls
//! - [`measure`]: what an experimenter would measure; [`theory`]: exact results to set beside it
//!
//! Who adds physics needs:
//! - [`real`], [`vector`]: the arithmetic that formulas are written in
//! - [`term`]: a formula for one pair, [`PairTerm`]; [`smoothing`]: the pair's smoothing length; [`mod@reference`]: its sum in O(N^2), for tests
//! - [`physics`]: one file per equation; [`rates`]: their order in a step; [`time`]: the integrator
//!
//! Who makes it fast needs [`pairs`], the engine, which physics never sees.
//!
//! The result of a simulation is the same, bit by bit, on any number of threads.

#![deny(missing_docs)]

mod cells;
pub mod divergence;
pub mod domain;
pub mod fluid;
pub mod kernel;
pub mod measure;
pub mod pairs;
pub mod particles;
pub mod physics;
pub mod rates;
pub mod real;
pub mod reference;
pub mod scheme;
pub mod setup;
pub mod shape;
pub mod simulation;
pub mod smoothing;
pub mod snapshot;
pub mod term;
pub mod theory;
pub mod time;
pub mod vector;
pub mod walls;

pub use domain::Domain;
pub use fluid::Fluid;
pub use kernel::Kernel;
pub use pairs::Precision;
pub use particles::{Particle, Particles};
pub use physics::surface_tension::SurfaceTension;
pub use real::Real;
pub use scheme::Scheme;
pub use setup::Setup;
pub use simulation::Simulation;
pub use snapshot::Snapshot;
pub use term::PairTerm;
pub use vector::Vector;
