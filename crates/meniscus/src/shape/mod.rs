//! Where the particles of a body begin: a [`Shape`] is filled by an
//! [`Arrangement`].
//!
//! - `geometry`: shapes, and whether a point is inside
//! - `polygon`: the same for a polygon
//! - `axis`: the axis of round shapes
//! - `revolved`: a polygon turned about an axis
//! - `perpendicular`: unit vectors across a direction
//! - `rotation`: how a shape or a lattice is turned
//! - `arrangement`: lattices and rings, and filling a shape with them
//! - `origin`: where these start
//! - `rings`: the sites of rings, shells and stacked discs
//! - `mesh`: surfaces of triangles; `stl`: files of them
//! - `jitter`: small random displacements, the same for ever
//!
//! ```
//! use meniscus::Vector;
//! use meniscus::shape::{Arrangement, Pattern, Shape};
//!
//! let drop = Shape::Ball { centre: Vector([0.0, 0.0]), radius: 1e-3 };
//! let lattice = Arrangement::new(Pattern::ClosePacked, 5e-5);
//! let positions = lattice.fill(&drop, 10_000).unwrap();
//! // The particles' volume is the disc's, up to the ragged edge.
//! let volume = positions.len() as f64 * lattice.particle_volume();
//! assert!((volume / (std::f64::consts::PI * 1e-6) - 1.0).abs() < 0.01);
//! ```

mod arrangement;
mod axis;
mod geometry;
mod jitter;
mod mesh;
mod origin;
mod perpendicular;
mod polygon;
mod revolved;
mod rings;
mod rotation;
mod stl;

pub use arrangement::{Arrangement, FillError, Pattern};
pub use geometry::Shape;
pub use mesh::{Mesh, MeshError};
pub(crate) use mesh::{Nearest, bounds};
pub(crate) use perpendicular::perpendiculars;
pub use revolved::Revolved;
pub use rotation::Rotation;

#[cfg(test)]
mod tests;
