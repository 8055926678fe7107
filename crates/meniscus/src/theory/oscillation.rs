//! Small oscillations of a body of liquid without viscosity, in a void.

/// The factor beside sigma / (rho R^3).
fn stiffness(mode: u32, dimension: usize) -> f64 {
    let n = f64::from(mode);
    if dimension == 2 {
        n * (n * n - 1.0)
    } else {
        n * (n - 1.0) * (n + 2.0)
    }
}

/// Angular frequency of mode n (2, 3, ...) of a rod (2D) or drop (3D), rad/s:
/// omega^2 = n (n^2 - 1) sigma / (rho R^3) in 2D,
/// omega^2 = n (n - 1) (n + 2) sigma / (rho R^3) in 3D.
///
/// Rayleigh (1879), Proc. R. Soc. 29, 71; Lamb, Hydrodynamics, arts. 273 to 275.
/// Jancik and Hyhlik's eq. 16 is mode 2 in 2D, with R = D / 2.
/// Surface tension in N/m, density in kg/m^3, radius in m.
///
/// ```
/// use std::f64::consts::PI;
/// // Lamb (art. 275): a water drop of 2.47 cm radius swings once a second (74 dyn/cm).
/// let drop = meniscus::theory::angular_frequency(2, 0.074, 1000.0, 0.02474, 3);
/// assert!((drop / (2.0 * PI) - 1.0).abs() < 0.02);
/// // A rod 1.338 mm across, by the formula with the diameter.
/// let rod = meniscus::theory::angular_frequency(2, 0.0727, 1000.0, 0.669e-3, 2);
/// assert!((rod - (48.0 * 0.0727 / (1.338e-3_f64.powi(3) * 1000.0)).sqrt()).abs() < 1e-9);
/// ```
pub fn angular_frequency(
    mode: u32,
    surface_tension: f64,
    density: f64,
    radius: f64,
    dimension: usize,
) -> f64 {
    (stiffness(mode, dimension) * surface_tension / (density * radius.powi(3))).sqrt()
}

/// The inverse of [`angular_frequency`]: the surface tension, N/m, with which
/// mode n of a body of this density (kg/m^3) and radius (m) has this angular
/// frequency (rad/s).
///
/// ```
/// let omega = meniscus::theory::angular_frequency(3, 0.0727, 998.0, 1e-3, 3);
/// let sigma = meniscus::theory::surface_tension_from_frequency(3, omega, 998.0, 1e-3, 3);
/// assert!((sigma - 0.0727).abs() < 1e-15);
/// ```
pub fn surface_tension_from_frequency(
    mode: u32,
    angular_frequency: f64,
    density: f64,
    radius: f64,
    dimension: usize,
) -> f64 {
    angular_frequency.powi(2) * density * radius.powi(3) / stiffness(mode, dimension)
}
