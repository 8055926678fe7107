//! Models of surface tension.
//!
//! - [`jancik_hyhlik`]: continuum surface force of a free surface
//! - [`continuum`]: continuum surface force of a free surface or between two fluids
//!
//! What they share:
//!
//! - [`gradient`], [`curvature`]: normals and curvature, plain and corrected
//! - [`matrix`]: small square matrices
//! - [`surface`]: what a model finds on the way

pub mod continuum;
pub mod curvature;
pub mod gradient;
pub mod jancik_hyhlik;
pub mod matrix;
pub mod surface;

use continuum::Continuum;
use jancik_hyhlik::JancikHyhlik;

/// A model of surface tension.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SurfaceTension {
    /// Free-surface continuum surface force of Jancik and Hyhlik.
    JancikHyhlik(JancikHyhlik),
    /// Continuum surface force of Morris, or of Qiang, Chen and Gao.
    Continuum(Continuum),
}

impl Default for SurfaceTension {
    fn default() -> Self {
        SurfaceTension::JancikHyhlik(JancikHyhlik::default())
    }
}
