//! Models of surface tension, one file each.
//!
//! - [`jancik_hyhlik`]: continuum surface force of a free surface

pub mod jancik_hyhlik;

use jancik_hyhlik::JancikHyhlik;

/// A model of surface tension.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SurfaceTension {
    /// Free-surface continuum surface force of Jancik and Hyhlik.
    JancikHyhlik(JancikHyhlik),
}

impl Default for SurfaceTension {
    fn default() -> Self {
        SurfaceTension::JancikHyhlik(JancikHyhlik::default())
    }
}
