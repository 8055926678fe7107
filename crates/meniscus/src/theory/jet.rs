//! A jet whose speed is modulated at the nozzle: where it breaks, and how fast its drops go.

use std::f64::consts::TAU;

use super::thread_growth_rate;

/// Distance from the nozzle at which a jet breaks, m, by linear waves on a thread that moves on at
/// `speed`: L = U t with t = arsinh(2 omega / (k u)) / omega, omega the rate of
/// [`thread_growth_rate`] (Rayleigh, Weber) for k = 2 pi f / U. NaN where waves do not grow.
///
/// At the nozzle the radius R is given and the speed is U + u cos(2 pi f t). There the wave has no
/// amplitude and, by continuity, grows at k u R / 2: so a = R k u / (2 omega) sinh(omega t), and it
/// breaks where that is R. Waves that travel upwind along the jet, and the others of its two branches, are left out: an error of
/// order We^(-1/2).
///
/// `modulation` is u / U; speed in m/s, frequency in Hz, surface tension in N/m, density in kg/m^3,
/// viscosity in Pa s, radius in m.
///
/// ```
/// use meniscus::theory::jet_breakup_length;
/// // A tenth of the amplitude is ln(10) / omega later; Plateau and Rayleigh's fastest wave, 0.343.
/// let of = |modulation| jet_breakup_length(4.0, modulation, 4.0 / 9.01, 1.0, 1.0, 0.0, 1.0);
/// assert!(((of(1e-4) - of(1e-3)) / 4.0 - 10_f64.ln() / 0.343).abs() < 0.02);
/// ```
pub fn jet_breakup_length(
    speed: f64,
    modulation: f64,
    frequency: f64,
    surface_tension: f64,
    density: f64,
    viscosity: f64,
    radius: f64,
) -> f64 {
    let wavelength = speed / frequency;
    let rate = thread_growth_rate(wavelength, surface_tension, density, viscosity, radius);
    let seed = TAU / wavelength * modulation * speed;
    speed * (2.0 * rate / seed).asinh() / rate
}

/// Speed of the drops of a jet of this `speed`, m/s: v = U - sigma / (rho U R), exact for a steady jet
/// in the mean, without drag and weight.
///
/// What passes a plane across the jet carries rho pi R^2 U^2 of momentum, and the surface pulls back by
/// 2 pi R sigma, of which the pressure sigma / R gives back half; drops, which nothing
/// pulls, carry rho pi R^2 U v. Surface tension in N/m, density in kg/m^3, radius in m.
///
/// ```
/// use meniscus::theory::jet_drop_speed;
/// // Where that is nothing a jet cannot leave: it drips.
/// assert_eq!(jet_drop_speed(1.0, 1.0, 1.0, 1.0), 0.0);
/// ```
pub fn jet_drop_speed(speed: f64, surface_tension: f64, density: f64, radius: f64) -> f64 {
    speed - surface_tension / (density * speed * radius)
}
