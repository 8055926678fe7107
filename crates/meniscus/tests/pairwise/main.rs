//! What surface tension by forces between pairs promises.
//!
//! - `momentum`: what the forces on a disordered drop, and on a wall, add up to
//! - `plate`: a drop stays at a wall
//! - `work`: cohesion pressure, surface tension and adhesion, against what forces do
//! - `stiff`: two particles swing as the potential says, in steps that are short enough

#[path = "../common/mod.rs"]
mod common;

mod momentum;
mod plate;
mod stiff;
mod work;

use meniscus::physics::surface_tension::pairwise::Pairwise;
use meniscus::physics::surface_tension::pairwise::akinci::Akinci;
use meniscus::physics::surface_tension::pairwise::cosine::Cosine;
use meniscus::physics::surface_tension::pairwise::estimate::Resolution;
use meniscus::physics::surface_tension::pairwise::gaussian_pair::GaussianPair;
use meniscus::physics::surface_tension::pairwise::kordilla::Kordilla;
use meniscus::physics::surface_tension::pairwise::lennard_jones::LennardJones;
use meniscus::{Kernel, Setup};

/// Akinci's cohesion.
pub fn cohesion() -> Pairwise {
    Pairwise::Akinci(Akinci::default())
}

/// The models whose forces stay finite for two particles at one place.
pub fn soft() -> [Pairwise; 5] {
    [
        cohesion(),
        Pairwise::Cosine(Cosine),
        Pairwise::GaussianPair(GaussianPair::Plain),
        Pairwise::GaussianPair(GaussianPair::TimesDistance),
        Pairwise::Kordilla(Kordilla),
    ]
}

/// The model of Lennard and Jones, for particles `spacing` apart.
pub fn lennard_jones(spacing: f64) -> Pairwise {
    Pairwise::LennardJones(LennardJones {
        rest_distance: spacing,
    })
}

/// What the forces in a setup are summed with: Wendland C2, h = 2 dx.
pub fn resolution<const D: usize>(setup: &Setup<D>) -> Resolution {
    Resolution {
        kernel: Kernel::WendlandC2,
        smoothing_length: setup.scheme.smoothing_length,
        spacing: setup.spacing,
        dimension: D,
    }
}
