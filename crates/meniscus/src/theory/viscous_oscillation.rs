//! Small oscillations of a body of viscous liquid in a void.

use nalgebra::{Complex, ComplexField};

use super::oscillation::angular_frequency;

/// Damping rate b of mode n for small viscosity, 1/s (amplitude falls as exp(-b t)):
/// 2 n (n - 1) nu / R^2 for a rod (2D), (n - 1) (2 n + 1) nu / R^2 for a drop (3D).
///
/// Lamb, Hydrodynamics, art. 355, by the dissipation of the potential flow.
/// Kinematic viscosity in m^2/s, radius in m.
///
/// ```
/// // Lamb's example: a water globe of 1 cm radius (nu = 0.0178 cm^2/s, cold water)
/// // takes 11.2 s to fall to 1/e in mode 2.
/// let rate = meniscus::theory::lamb_damping_rate(2, 1.78e-6, 0.01, 3);
/// assert!((1.0 / rate - 11.2).abs() < 0.05);
/// ```
pub fn lamb_damping_rate(
    mode: u32,
    kinematic_viscosity: f64,
    radius: f64,
    dimension: usize,
) -> f64 {
    let n = f64::from(mode);
    let factor = if dimension == 2 {
        2.0 * n * (n - 1.0)
    } else {
        (n - 1.0) * (2.0 * n + 1.0)
    };
    factor * kinematic_viscosity / radius.powi(2)
}

/// A motion exp(-b t) cos(omega t).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ViscousOscillation {
    /// omega, rad/s.
    pub angular_frequency: f64,
    /// b, 1/s.
    pub damping_rate: f64,
}

/// The least damped oscillation of mode n of a rod (2D) or drop (3D) of any
/// viscosity, from the linearised Navier-Stokes equations; `None` where
/// viscosity is so high that the body creeps back without swinging.
///
/// With s = -b + i omega, k^2 = s R^2 / nu, omega_0 the frequency without
/// viscosity, and g = k I'(k) / I(k) for the modified Bessel function I_n
/// (2D) or the modified spherical one i_n (3D):
/// s^2 + 2 n (nu s / R^2) (n - 1 - Q (g - 1)) + omega_0^2 (1 - Q) = 0, where
/// Q = 2 n (n - 1) / (k^2 + 2 n^2 - 2 g) in 2D and
/// Q = 2 (n^2 - 1) / (k^2 + 2 (n^2 + n - 1) - 2 g) in 3D.
/// In 3D this is Chandrasekhar, Hydrodynamic and Hydromagnetic Stability,
/// sec. 98 (also Reid 1960 and Prosperetti 1980, J. Fluid Mech. 100, 333, at
/// late times); the rod follows in the same way from the stream function.
///
/// Surface tension in N/m, density in kg/m^3, kinematic viscosity in m^2/s,
/// radius in m.
///
/// ```
/// use meniscus::theory::viscous_oscillation;
/// // Chandrasekhar: mode 2 of a drop swings while omega_0 R^2 / nu > 3.69.
/// let at = |alpha2: f64| viscous_oscillation(2, 1.0, 8.0, 1.0 / alpha2, 1.0, 3);
/// assert!(at(3.68).is_none() && at(3.70).is_some());
/// ```
pub fn viscous_oscillation(
    mode: u32,
    surface_tension: f64,
    density: f64,
    kinematic_viscosity: f64,
    radius: f64,
    dimension: usize,
) -> Option<ViscousOscillation> {
    let natural = angular_frequency(mode, surface_tension, density, radius, dimension);
    let target = kinematic_viscosity / (natural * radius.powi(2));
    // In units of 1/omega_0 and R only the dimensionless viscosity is left. The root
    // is followed from one so small that Lamb's rate is its start.
    let mut viscosity = target.min(1e-4);
    let rate = lamb_damping_rate(mode, viscosity, 1.0, dimension);
    let mut root = Complex::new(-rate, 1.0);
    loop {
        root = newton(root, |s| characteristic(s, mode, viscosity, dimension))?;
        if viscosity >= target {
            break;
        }
        viscosity = (viscosity * 1.05).min(target);
    }
    Some(ViscousOscillation {
        angular_frequency: root.im * natural,
        damping_rate: -root.re * natural,
    })
}

/// The left side of the characteristic equation, omega_0 = R = 1.
fn characteristic(s: Complex<f64>, mode: u32, viscosity: f64, dimension: usize) -> Complex<f64> {
    let n = f64::from(mode);
    if viscosity == 0.0 {
        return s * s + 1.0;
    }
    let k2 = s / viscosity;
    let g = log_derivative(k2, mode, dimension);
    let q = if dimension == 2 {
        Complex::from(2.0 * n * (n - 1.0)) / (k2 + 2.0 * n * n - g * 2.0)
    } else {
        Complex::from(2.0 * (n * n - 1.0)) / (k2 + 2.0 * (n * n + n - 1.0) - g * 2.0)
    };
    s * s + s * (2.0 * n * viscosity) * (-(q * (g - 1.0)) + (n - 1.0)) + 1.0 - q
}

/// k I'(k) / I(k), a function of k^2, by the continued fraction of neighbouring orders:
/// n + k^2 / (2 n + D + k^2 / (2 n + D + 2 + ...)).
pub(super) fn log_derivative(k2: Complex<f64>, mode: u32, dimension: usize) -> Complex<f64> {
    // Terms beyond the order |k| fall off fast; the tail is that of equal terms.
    let terms = 40 + 2 * k2.modulus().sqrt() as u32;
    let coefficient = |j: u32| f64::from(2 * (mode + j)) + dimension as f64;
    let half = 0.5 * coefficient(terms);
    let mut fraction = (k2 + half * half).sqrt() - half;
    for j in (0..terms).rev() {
        fraction = k2 / (fraction + coefficient(j));
    }
    fraction + f64::from(mode)
}

/// Newton's method with a derivative by central difference; `None` if it finds no
/// root above the real axis.
pub(super) fn newton(
    mut s: Complex<f64>,
    f: impl Fn(Complex<f64>) -> Complex<f64>,
) -> Option<Complex<f64>> {
    let d = 1e-6;
    for _ in 0..60 {
        let slope = (f(s + d) - f(s - d)) / (2.0 * d);
        let step = f(s) / slope;
        s -= step;
        if s.im <= 0.0 || !s.is_finite() {
            return None;
        }
        if step.modulus() < 1e-12 {
            return Some(s);
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_viscosity_gives_rayleigh_and_lamb() {
        // The next terms are of relative order viscosity^(1/2) in the rate and
        // viscosity^(3/2) in the frequency.
        for dimension in [2, 3] {
            for mode in 2..6 {
                let (nu, omega0) = (1e-6, angular_frequency(mode, 1.0, 1.0, 1.0, dimension));
                let found = viscous_oscillation(mode, 1.0, 1.0, nu, 1.0, dimension).unwrap();
                let lamb = lamb_damping_rate(mode, nu, 1.0, dimension);
                assert!((found.angular_frequency / omega0 - 1.0).abs() < 1e-6);
                let ratio = found.damping_rate / lamb;
                assert!(
                    (ratio - 1.0).abs() < 0.02,
                    "{dimension}D, mode {mode}: {ratio}"
                );
            }
        }
    }

    #[test]
    fn no_viscosity_no_damping() {
        let found = viscous_oscillation(2, 0.0727, 1000.0, 0.0, 1e-3, 2).unwrap();
        assert_eq!(found.damping_rate, 0.0);
        let omega0 = angular_frequency(2, 0.0727, 1000.0, 1e-3, 2);
        assert!((found.angular_frequency / omega0 - 1.0).abs() < 1e-12);
    }

    #[test]
    fn spherical_fraction_agrees_with_elementary_functions() {
        // i_0(k) = sinh(k) / k, so that k i_0'(k) / i_0(k) = k coth(k) - 1.
        for k in [
            Complex::new(0.1, 0.0),
            Complex::new(3.0, 2.0),
            Complex::new(0.0, 2.0),
            Complex::new(70.0, 71.0),
            Complex::new(700.0, 0.0),
        ] {
            let coth = if k.re > 300.0 {
                Complex::from(1.0)
            } else {
                k.cosh() / k.sinh()
            };
            let exact = k * coth - 1.0;
            let found = log_derivative(k * k, 0, 3);
            assert!(
                (found - exact).modulus() < 1e-12 * exact.modulus().max(1.0),
                "{k}: {found} {exact}"
            );
        }
    }

    #[test]
    fn without_inertia_the_body_creeps_back_at_the_known_rate() {
        // A rod: n sigma / (2 mu R) (Hopper 1990); a drop, mode 2: 20 sigma / (19 mu R)
        // (Rallison 1984). What inertia changes is of the order of s R^2 / nu = 1e-6.
        let nu = 1e3;
        for (mode, dimension, rate) in [
            (2, 2, 1.0),
            (3, 2, 1.5),
            (4, 2, 2.0),
            (2, 3, 20.0 / 19.0),
            (3, 3, 35.0 / 22.0),
        ] {
            // omega_0 = 1 fixes sigma / rho.
            let sigma = angular_frequency(mode, 1.0, 1.0, 1.0, dimension).powi(-2);
            let at = |factor: f64| {
                let s = Complex::from(-rate * sigma / nu * factor);
                characteristic(s, mode, nu, dimension).re
            };
            assert!(
                at(1.0 - 1e-5) * at(1.0 + 1e-5) < 0.0,
                "{dimension}D, mode {mode}"
            );
        }
    }

    #[test]
    fn viscosity_slows_and_finally_stops_the_swing() {
        for dimension in [2, 3] {
            let at = |nu: f64| viscous_oscillation(2, 1.0, 1.0, nu, 1.0, dimension);
            let (thin, thick) = (at(0.01).unwrap(), at(0.1).unwrap());
            assert!(thick.angular_frequency < thin.angular_frequency);
            assert!(thick.damping_rate > thin.damping_rate);
            assert!(at(100.0).is_none());
        }
    }
}
