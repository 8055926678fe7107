//! How a thread of liquid breaks into drops.

/// Rate at which a wave on a thread at rest grows, 1/s; NaN for waves that do not, shorter than the
/// circumference. Without viscosity that of Rayleigh (1878),
/// omega_0^2 = sigma / (rho R^3) x (1 - x^2) I_1(x) / I_0(x) with x = k R; viscosity slows it as in
/// the slender threads of Weber (1931): omega = sqrt(omega_0^2 + b^2) - b, b = 3 mu k^2 / (2 rho).
///
/// Wavelength and radius in m, surface tension in N/m, density in kg/m^3, dynamic viscosity in Pa s.
///
/// ```
/// use meniscus::theory::thread_growth_rate;
/// // The wave that grows fastest is nine radii long, and grows at 0.343.
/// let of = |length: f64| thread_growth_rate(length, 1.0, 1.0, 0.0, 1.0);
/// assert!((of(9.01) - 0.343).abs() < 1e-3 && of(8.0) < of(9.01) && of(10.0) < of(9.01));
/// ```
pub fn thread_growth_rate(
    wavelength: f64,
    surface_tension: f64,
    density: f64,
    viscosity: f64,
    radius: f64,
) -> f64 {
    let wave = std::f64::consts::TAU / wavelength;
    let x = wave * radius;
    let scale = surface_tension / (density * radius.powi(3));
    let ideal = scale * x * (1.0 - x * x) * bessel_ratio(x);
    let friction = 1.5 * viscosity / density * wave * wave;
    if ideal > 0.0 {
        (ideal + friction * friction).sqrt() - friction
    } else {
        f64::NAN
    }
}

/// I_1(x) / I_0(x) by their series, for x up to 1.
fn bessel_ratio(x: f64) -> f64 {
    let square = 0.25 * x * x;
    let (mut term, mut zero, mut one) = (1.0, 0.0, 0.0);
    for k in 0..20 {
        zero += term;
        one += term * 0.5 * x / f64::from(k + 1);
        term *= square / f64::from((k + 1) * (k + 1));
    }
    one / zero
}

#[cfg(test)]
mod tests {
    use super::{bessel_ratio, thread_growth_rate};

    #[test]
    fn the_ratio_is_that_of_tables() {
        // Abramowitz and Stegun, table 9.8: I_0(1) = 1.266066, I_1(1) = 0.565159.
        assert!((bessel_ratio(1.0) - 0.565_159 / 1.266_066).abs() < 1e-6);
    }

    #[test]
    fn short_waves_do_not_grow_and_honey_grows_slowly() {
        assert!(thread_growth_rate(6.0, 1.0, 1.0, 0.0, 1.0).is_nan());
        // Without inertia: sigma (1 - x^2) / (6 mu R).
        let slow = thread_growth_rate(62.8319, 1.0, 1.0, 100.0, 1.0);
        assert!((slow / ((1.0 - 0.01) / 600.0) - 1.0).abs() < 0.02, "{slow}");
    }
}
