//! Surface tension by forces between pairs of particles, which attract each other far apart and,
//! most of them, repel each other near by. No surface is looked for: where half of the neighbours
//! are missing, the forces do not balance. With s the radius of the kernel's support,
//!
//! - F_ij = -G m_i m_j f(r_ij) e_ij, e_ij = (x_i - x_j) / r_ij, f of no dimension, zero from s on
//! - a_i  = sum_j F_ij / m_i
//!
//! The strength G follows from the fluid's surface tension, by what a sharp flat surface of evenly
//! spread particles pulls with ([`estimate`]), or from Akinci's coefficient gamma. Between two
//! fluids it is the geometric mean of theirs.
//!
//! Also in bulk the forces pull: they compress a liquid until its equation of state bears their
//! cohesion pressure, some 8 sigma / s. A background pressure of as much keeps a liquid at its
//! density at rest.
//!
//! - [`akinci`]: cohesion, curvature and adhesion of Akinci, Akinci and Teschner
//! - [`cosine`], [`gaussian_pair`], [`kordilla`], [`lennard_jones`]: other shapes f
//! - [`strength`]: how strong; [`estimate`]: what follows from it
//! - `term`: the sum over pairs; `pull`: all of it in a step

pub mod akinci;
pub mod cosine;
pub mod estimate;
pub mod gaussian_pair;
pub mod kordilla;
pub mod lennard_jones;
mod pull;
pub mod strength;
mod term;

use akinci::Akinci;
use cosine::Cosine;
use gaussian_pair::GaussianPair;
use kordilla::Kordilla;
use lennard_jones::LennardJones;
pub(crate) use pull::Pull;

use crate::real::Real;

/// The shape f of a force between two particles.
pub trait Attraction: Copy {
    /// f at a distance, m, for a kernel that reaches `support`, m: positive where two particles
    /// attract each other, zero from the support on, finite everywhere.
    fn attraction<R: Real, const D: usize>(&self, distance: R, support: f64) -> R;
}

/// A model of pairwise forces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pairwise {
    /// Cohesion, curvature and adhesion of Akinci, Akinci and Teschner.
    Akinci(Akinci),
    /// A cosine, of Tartakovsky and Meakin.
    Cosine(Cosine),
    /// Two Gaussians, of Tartakovsky and Panchenko.
    GaussianPair(GaussianPair),
    /// Two splines, of Kordilla, Tartakovsky and Geyer.
    Kordilla(Kordilla),
    /// The force of the Lennard-Jones potential.
    LennardJones(LennardJones),
}

impl Attraction for Pairwise {
    #[inline(always)]
    fn attraction<R: Real, const D: usize>(&self, distance: R, support: f64) -> R {
        match self {
            Pairwise::Akinci(f) => f.attraction::<R, D>(distance, support),
            Pairwise::Cosine(f) => f.attraction::<R, D>(distance, support),
            Pairwise::GaussianPair(f) => f.attraction::<R, D>(distance, support),
            Pairwise::Kordilla(f) => f.attraction::<R, D>(distance, support),
            Pairwise::LennardJones(f) => f.attraction::<R, D>(distance, support),
        }
    }
}

impl Pairwise {
    /// The shape of the force between fluid and wall: Akinci's own, for others that within the fluid.
    #[inline(always)]
    pub fn adhesion<R: Real, const D: usize>(&self, distance: R, support: f64) -> R {
        match self {
            Pairwise::Akinci(_) => akinci::adhesion(distance, support),
            other => other.attraction::<R, D>(distance, support),
        }
    }

    /// The name in case files and reports.
    pub fn name(&self) -> &'static str {
        match self {
            Pairwise::Akinci(_) => "akinci",
            Pairwise::Cosine(_) => "cosine",
            Pairwise::GaussianPair(_) => "gaussian-pair",
            Pairwise::Kordilla(_) => "kordilla",
            Pairwise::LennardJones(_) => "lennard-jones",
        }
    }

    /// Akinci's parameters, if it is that model.
    pub fn akinci(&self) -> Option<&Akinci> {
        match self {
            Pairwise::Akinci(akinci) => Some(akinci),
            _ => None,
        }
    }
}
