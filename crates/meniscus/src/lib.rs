//! Flows ruled by surface tension, by smoothed particle hydrodynamics.

pub mod divergence;
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
pub mod shape;
pub mod simulation;
pub mod snapshot;
pub mod term;
pub mod theory;
pub mod time;
pub mod vector;

pub use kernel::Kernel;
pub use particles::{Particle, Particles};
pub use real::Real;
pub use pairs::Domain;
pub use simulation::{Setup, Simulation};
pub use snapshot::Snapshot;
pub use term::PairTerm;
pub use vector::Vector;
