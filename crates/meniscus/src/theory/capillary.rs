//! Scales that surface tension sets.

/// Capillary time, s: sqrt(rho R^3 / sigma). Mode 2 of a rod has the period
/// 2 pi / sqrt(6) of these, of a drop 2 pi / sqrt(8).
///
/// Density in kg/m^3, length (commonly the radius) in m, surface tension in N/m.
///
/// ```
/// // A litre-and-a-bit of water, R = 0.1 m: 3.7 s.
/// assert!((meniscus::theory::capillary_time(0.073, 1000.0, 0.1) - 3.70).abs() < 0.01);
/// ```
pub fn capillary_time(surface_tension: f64, density: f64, length: f64) -> f64 {
    (density * length.powi(3) / surface_tension).sqrt()
}

/// Capillary velocity, m/s: sqrt(sigma / (rho R)), the length over the
/// [`capillary_time`]; also the speed at which a sheet of liquid of thickness
/// 2 R retracts (Taylor 1959, Culick 1960).
///
/// Density in kg/m^3, length in m, surface tension in N/m.
///
/// ```
/// // A soap film of 1 micrometre (two faces of 0.025 N/m) bursts at about 7 m/s.
/// assert!((meniscus::theory::capillary_velocity(0.025, 1000.0, 0.5e-6) - 7.07).abs() < 0.01);
/// ```
pub fn capillary_velocity(surface_tension: f64, density: f64, length: f64) -> f64 {
    (surface_tension / (density * length)).sqrt()
}

/// Capillary length, m: sqrt(sigma / (rho g)), the size above which gravity
/// flattens a drop.
///
/// Density (or the difference of densities) in kg/m^3, gravity in m/s^2.
///
/// ```
/// // Water on Earth: 2.7 mm.
/// assert!((meniscus::theory::capillary_length(0.0728, 998.0, 9.81) - 2.727e-3).abs() < 1e-6);
/// ```
pub fn capillary_length(surface_tension: f64, density: f64, gravity: f64) -> f64 {
    (surface_tension / (density * gravity)).sqrt()
}
