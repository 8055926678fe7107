//! Viscous forces of one pair, as accelerations per unit mass of j.
//!
//! Artificial (Monaghan and Gingold 1983; Jancik and Hyhlik, eq. 5):
//!   Pi_ij = max(0, -alpha c_ij h / rho_ij (v_ij . x_ij) / (x_ij^2 + 0.01 h^2))
//! acting against grad W, with the means c_ij and rho_ij.
//!
//! Laminar, Morris, Fox and Zhu (1997), J. Comput. Phys. 136, 214, eq. 22:
//!   (mu_i + mu_j) / (rho_i rho_j) (x_ij . grad W) / x_ij^2 v_ij
//! a Laplacian. At a free surface it dissipates mu |grad v|^2, not the whole
//! of the viscous stress, and damps surface modes at half the true rate.
//!
//! Laminar, Monaghan (2005), Rep. Prog. Phys. 68, 1703, sect. 8.2, after
//! Cleary (1998):
//!   2 (D + 2) mu_ij / (rho_i rho_j) (v_ij . x_ij) / x_ij^2 grad W,
//!   mu_ij = 2 mu_i mu_j / (mu_i + mu_j)
//! along the line of centres, so that angular momentum is conserved; it
//! stands for the divergence of the viscous stress.

use crate::real::Real;
use crate::term::Pair;
use crate::vector::Vector;

/// How the laminar viscous force is discretised.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ViscosityForm {
    /// Morris: acts on the velocity difference (a Laplacian)
    Morris,
    /// Monaghan and Cleary: acts along the line of centres (the stress form)
    MonaghanCleary,
    /// The divergence of the stress of the velocity gradient, in sweeps of its own:
    /// [`crate::physics::viscous_stress`]
    Stress,
    /// The same, and Morris's form of what its gradient leaves of the velocity: acts on motion at the
    /// scale of particles too
    StressAndRest,
}

impl ViscosityForm {
    /// Whether it has sweeps of its own.
    pub fn is_stress(self) -> bool {
        matches!(self, ViscosityForm::Stress | ViscosityForm::StressAndRest)
    }
}

/// Pi_ij, m^5/(kg s^2), of the artificial viscosity with `alpha_h` = alpha h.
#[inline(always)]
pub fn artificial<R: Real, const D: usize>(
    alpha_h: f64,
    epsilon_h_squared: f64,
    velocity_difference: &Vector<R, D>,
    sum_of_sound_speeds: R,
    sum_of_densities: R,
    ij: &Pair<R, D>,
) -> R {
    let approach = velocity_difference.dot(&ij.offset);
    // One division for both denominators. The halves of the two means cancel.
    let denominator = (ij.distance_squared + epsilon_h_squared) * sum_of_densities;
    // The same for all pairs of one fluid.
    let strength = sum_of_sound_speeds * -alpha_h;
    (approach * strength / denominator).positive()
}

/// Harmonic mean, zero where both are.
#[inline(always)]
pub(crate) fn harmonic_mean<R: Real>(a: R, b: R) -> R {
    a * b * 2.0 / (a + b + a.tiny())
}

/// Acceleration per unit mass of j by Morris's form. `sum` is mu_i + mu_j, Pa s.
#[inline(always)]
pub fn morris<R: Real, const D: usize>(
    sum: R,
    velocity_difference: &Vector<R, D>,
    density_product: R,
    ij: &Pair<R, D>,
) -> Vector<R, D> {
    *velocity_difference * (sum / density_product * ij.slope_over_distance)
}

/// Acceleration per unit mass of j by Monaghan and Cleary's form. `mean` is mu_ij, Pa s.
#[inline(always)]
pub fn monaghan_cleary<R: Real, const D: usize>(
    mean: R,
    velocity_difference: &Vector<R, D>,
    density_product: R,
    ij: &Pair<R, D>,
) -> Vector<R, D> {
    let approach = velocity_difference.dot(&ij.offset);
    // One division; r = 0 for i = j.
    let denominator = (ij.distance_squared + mean.tiny()) * density_product;
    let strength = mean * (2.0 * (D as f64 + 2.0));
    ij.offset * (approach * strength / denominator * ij.slope_over_distance)
}
