//! Models of surface tension.
//!
//! - [`balanced`]: in balance with the pressure gradient, for one fluid with a free surface
//! - [`capillary_pressure`]: the pressure that the surface asks for, found on a mesh and taken into the pressure gradient
//! - [`jancik_hyhlik`]: continuum surface force of a free surface
//! - [`continuum`]: continuum surface force of a free surface or between two fluids
//! - [`pairwise`]: forces between pairs of particles, that of walls among them
//! - [`total_variation`]: the derivative of an energy on a mesh, at walls too
//!
//! What they share:
//!
//! - [`bodies`]: free bodies, whose forces add up to nothing
//! - [`gradient`], [`curvature`]: normals and curvature, plain and corrected
//! - [`matrix`]: small square matrices
//! - [`mesh`]: a mesh under particles, and what models on it act in
//! - [`surface`]: what a model finds on the way

pub mod balanced;
pub mod bodies;
pub mod capillary_pressure;
pub mod continuum;
pub mod curvature;
pub mod gradient;
pub mod jancik_hyhlik;
pub mod matrix;
pub mod mesh;
pub mod pairwise;
pub mod surface;
pub mod total_variation;

use balanced::Balanced;
use capillary_pressure::CapillaryPressure;
use continuum::Continuum;
use jancik_hyhlik::JancikHyhlik;
use pairwise::Pairwise;
use total_variation::TotalVariation;

/// A model of surface tension.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SurfaceTension {
    /// In balance with the pressure gradient: one fluid with a free surface.
    Balanced(Balanced),
    /// Capillary pressure of a smoothed colour, on a mesh.
    CapillaryPressure(CapillaryPressure),
    /// Free-surface continuum surface force of Jancik and Hyhlik.
    JancikHyhlik(JancikHyhlik),
    /// Continuum surface force of Morris, or of Qiang, Chen and Gao.
    Continuum(Continuum),
    /// Forces between pairs of particles.
    Pairwise(Pairwise),
    /// Total variation of a smoothed colour, on a mesh.
    TotalVariation(TotalVariation),
}

impl Default for SurfaceTension {
    fn default() -> Self {
        SurfaceTension::CapillaryPressure(CapillaryPressure)
    }
}
