//! Dimensionless numbers. `length` is the diameter D wherever a drop or rod is
//! meant; some authors take the radius.

/// La = sigma rho D / mu^2 = 1 / Oh^2: surface tension and inertia against viscosity.
///
/// N/m, kg/m^3, m, Pa s; infinite without viscosity.
///
/// ```
/// // A millimetre of water at 20 degrees Celsius.
/// let la = meniscus::theory::laplace_number(0.0728, 998.0, 1e-3, 1.002e-3);
/// assert!((la / 72_364.0 - 1.0).abs() < 1e-4);
/// ```
pub fn laplace_number(surface_tension: f64, density: f64, length: f64, viscosity: f64) -> f64 {
    surface_tension * density * length / viscosity.powi(2)
}

/// Oh = mu / sqrt(sigma rho D): the time of viscosity against that of surface tension.
///
/// N/m, kg/m^3, m, Pa s.
///
/// ```
/// // The same millimetre of water: 1 / sqrt(72 364).
/// let oh = meniscus::theory::ohnesorge_number(0.0728, 998.0, 1e-3, 1.002e-3);
/// assert!((oh - 0.003717).abs() < 1e-6);
/// ```
pub fn ohnesorge_number(surface_tension: f64, density: f64, length: f64, viscosity: f64) -> f64 {
    viscosity / (surface_tension * density * length).sqrt()
}

/// We = rho U^2 D / sigma: inertia against surface tension.
///
/// kg/m^3, m/s, m, N/m.
///
/// ```
/// // Water at 1 m/s, 0.0728 m across, has We = 1000.
/// assert!((meniscus::theory::weber_number(1000.0, 1.0, 0.0728, 0.0728) - 1000.0).abs() < 1e-9);
/// ```
pub fn weber_number(density: f64, speed: f64, length: f64, surface_tension: f64) -> f64 {
    density * speed.powi(2) * length / surface_tension
}

/// Re = rho U D / mu: inertia against viscosity.
///
/// kg/m^3, m/s, m, Pa s.
///
/// ```
/// // Water at 1 mm/s, 1 mm across: about one.
/// assert!((meniscus::theory::reynolds_number(1000.0, 1e-3, 1e-3, 1e-3) - 1.0).abs() < 1e-12);
/// ```
pub fn reynolds_number(density: f64, speed: f64, length: f64, viscosity: f64) -> f64 {
    density * speed * length / viscosity
}

/// Bo (or Eo) = rho g D^2 / sigma: gravity against surface tension. The density is the
/// difference between inside and outside.
///
/// kg/m^3, m/s^2, m, N/m.
///
/// ```
/// // One at the capillary length.
/// let length = meniscus::theory::capillary_length(0.0728, 998.0, 9.81);
/// assert!((meniscus::theory::bond_number(998.0, 9.81, length, 0.0728) - 1.0).abs() < 1e-12);
/// ```
pub fn bond_number(density: f64, gravity: f64, length: f64, surface_tension: f64) -> f64 {
    density * gravity * length.powi(2) / surface_tension
}

/// Ca = mu U / sigma: viscosity against surface tension. Equal to We / Re.
///
/// Pa s, m/s, N/m.
///
/// ```
/// // The capillary velocity of water, sigma / mu, is about 73 m/s: there Ca = 1.
/// assert!((meniscus::theory::capillary_number(1.002e-3, 72.65, 0.0728) - 1.0).abs() < 1e-3);
/// ```
pub fn capillary_number(viscosity: f64, speed: f64, surface_tension: f64) -> f64 {
    viscosity * speed / surface_tension
}
