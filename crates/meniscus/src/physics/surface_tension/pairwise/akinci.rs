//! Akinci, Akinci and Teschner (2013), ACM Trans. Graph. 32, 182 ("Versatile surface tension and
//! adhesion for SPH fluids"), as Gonzalez has it (MSc thesis, Imperial College), with s the support:
//!
//! - eq. 3.5  cohesion   F = -gamma m_i m_j C(r) e
//!   C = c_D/s^D { (1 - q)^3 q^3 from q = 1/2 on, 2 (1 - q)^3 q^3 - 1/64 below }, q = r / s
//! - eq. 3.6  curvature  F = -gamma m_i m_j / (1000 dx^D) (n_i - n_j), r < s, n_i = s sum_j V_j grad W_ij
//! - eq. 3.7  adhesion   F = -beta m_i Psi_j A(r) e, A = a_D/s^D (2 (1 - q)(2 q - 1))^(1/4) from q = 1/2 on
//! - eq. 3.8  Psi_j = rho_0 / sum_k W_jk over the wall's own particles
//! - eq. 3.9  K = 2 rho_0 / (rho_i + rho_j), where neighbours are missing
//! - eq. 3.10 F = K (cohesion + curvature) + adhesion
//!
//! In 3D c_3 = 32/pi and a_3 = 0.007. In 2D the print keeps the numbers of 3D with 1/s^3; here
//! c_2 and a_2 make the integrals of C and A over the plane what they are over space
//! ([`Normalisation`]), so that gamma and beta are in m^4/(kg s^2) in either.
//!
//! The print's curvature force, -gamma m_i (n_i - n_j), is in other units than cohesion: one gamma
//! can not serve both. Here m_j / dx^D, the density, is a factor, over that of water, for which it
//! is then as printed ([`Curvature`]).
//!
//! That force is not along e, so it keeps momentum, but not angular momentum: a disordered drop
//! that feels it as strongly as in the paper, a twentieth of cohesion where both are largest, begins
//! to turn, and does not stop. Cohesion alone makes drops as round; it is the default.

use super::Attraction;
use crate::real::Real;

/// The constants before the splines in 2D.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Normalisation {
    /// Their integrals over the plane are those over space.
    Proper,
    /// Those of 3D, as printed.
    Printed,
}

/// The force by differences of normals.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Curvature {
    /// In the units of cohesion: as printed for a density of 1000 kg/m^3.
    Consistent,
    /// As printed: gamma counts without its units.
    Printed,
    /// Cohesion alone.
    None,
}

/// What the forces of eqs. 3.5 to 3.7 are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reading {
    /// Forces: a = F / m.
    Force,
    /// Added to the acceleration as they are, a = F, as the thesis's figures suggest. Out of units.
    Acceleration,
}

/// The parameters of the model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Akinci {
    /// gamma, m^4/(kg s^2) (m^5/(kg s^2) in 2D where [`Normalisation::Printed`]); none if it is to
    /// follow from the fluid's surface tension.
    pub gamma: Option<f64>,
    /// The constants before the splines in 2D.
    pub normalisation: Normalisation,
    /// The force by differences of normals.
    pub curvature: Curvature,
    /// What the forces are.
    pub reading: Reading,
}

impl Default for Akinci {
    fn default() -> Self {
        Self {
            gamma: None,
            normalisation: Normalisation::Proper,
            curvature: Curvature::None,
            reading: Reading::Force,
        }
    }
}

/// C over its constant, at most 1/64.
impl Attraction for Akinci {
    #[inline(always)]
    fn attraction<R: Real, const D: usize>(&self, distance: R, support: f64) -> R {
        let q = distance * (1.0 / support);
        let bell = ((-q + 1.0).positive() * q).powi(3);
        let near = q.less(q.literal(0.5));
        R::select(near, bell * 2.0 - 1.0 / 64.0, bell)
    }
}

/// The shape of A.
#[inline(always)]
pub(super) fn adhesion<R: Real>(distance: R, support: f64) -> R {
    let q = distance * (1.0 / support);
    // Positive between one half and one alone.
    ((-q + 1.0) * (q * 2.0 - 1.0) * 2.0)
        .positive()
        .sqrt()
        .sqrt()
}
