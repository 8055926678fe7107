//! What artificial viscosity is worth.

/// Kinematic viscosity, m^2/s, of the artificial viscosity with coefficient
/// alpha: nu = alpha c h / (2 (D + 2)), so alpha c h / 8 in 2D and
/// alpha c h / 10 in 3D.
///
/// Monaghan (2005), Rep. Prog. Phys. 68, 1703, sec. 4.1. The term
/// -alpha c h / rho (v_ij . x_ij) / r^2 is expanded about one particle in a
/// smooth flow; the integral of r dW/dr is -D for any kernel, so that no
/// other property of the kernel enters, apart from the small constant that
/// many authors add to r^2 and that lowers nu by a few per cent, more the
/// narrower the kernel in units of h. Left are nu (laplacian v + 2 grad div v):
/// shear as with the stress form of viscosity, and a bulk part. Applied to
/// approaching pairs only, the term acts on half of the pairs: halve the result.
///
/// Sound speed in m/s, smoothing length in m.
///
/// ```
/// // alpha = 0.1, c = 5 m/s, h = 0.075 mm in 2D: nearly five times that of water.
/// let nu = meniscus::theory::artificial_kinematic_viscosity(0.1, 5.0, 0.075e-3, 2);
/// assert!((nu - 4.6875e-6).abs() < 1e-18);
/// ```
pub fn artificial_kinematic_viscosity(
    alpha: f64,
    sound_speed: f64,
    smoothing_length: f64,
    dimension: usize,
) -> f64 {
    alpha * sound_speed * smoothing_length / (2.0 * (dimension as f64 + 2.0))
}
