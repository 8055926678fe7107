//! The pressure inside a drop at rest.

/// Pressure inside a circular rod (2D) or a spherical drop (3D) above that
/// outside, Pa: (D - 1) sigma / R.
///
/// Young and Laplace; Landau and Lifshitz, Fluid Mechanics, eq. 61.3.
/// Surface tension in N/m, radius in m.
///
/// ```
/// // A water drop of one micrometre radius: 1.44 bar.
/// let jump = meniscus::theory::pressure_jump(0.072, 1e-6, 3);
/// assert!((jump - 1.44e5).abs() < 1e-6);
/// // A rod has one curvature where a drop has two.
/// assert_eq!(meniscus::theory::pressure_jump(0.072, 1e-6, 2), jump / 2.0);
/// ```
pub fn pressure_jump(surface_tension: f64, radius: f64, dimension: usize) -> f64 {
    (dimension as f64 - 1.0) * surface_tension / radius
}

/// The inverse of [`pressure_jump`]: surface tension in N/m that holds a rod
/// (2D) or drop (3D) of this radius (m) at this pressure (Pa) above the outside.
///
/// ```
/// // A drop two millimetres across with 145 Pa inside is a water drop.
/// let sigma = meniscus::theory::surface_tension_from_pressure(145.0, 1e-3, 3);
/// assert!((sigma - 0.0725).abs() < 1e-12);
/// ```
pub fn surface_tension_from_pressure(pressure_jump: f64, radius: f64, dimension: usize) -> f64 {
    pressure_jump * radius / (dimension as f64 - 1.0)
}
