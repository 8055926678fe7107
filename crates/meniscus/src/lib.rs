//! Flows ruled by surface tension, by smoothed particle hydrodynamics.

pub mod kernel;
pub mod real;
pub mod scheme;
pub mod vector;

pub use kernel::Kernel;
pub use real::Real;
pub use vector::Vector;
