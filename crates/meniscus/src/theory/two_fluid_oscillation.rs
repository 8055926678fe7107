//! Small oscillations of a drop in another viscous fluid.

use nalgebra::{Complex, ComplexField, Matrix4};

use super::viscous_oscillation::{ViscousOscillation, log_derivative, newton};

/// One of two fluids.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Medium {
    /// kg/m^3
    pub density: f64,
    /// Dynamic viscosity, Pa s.
    pub viscosity: f64,
}

/// Angular frequency, rad/s, of mode n (2, 3, ...) of a rod (2D) or drop (3D) in an unbounded
/// fluid, without viscosity:
/// omega^2 = n (n^2 - 1) sigma / ((rho + rho_o) R^3) in 2D,
/// omega^2 = n (n^2 - 1) (n + 2) sigma / (((n + 1) rho + n rho_o) R^3) in 3D.
///
/// Lamb, Hydrodynamics, art. 275. Surface tension in N/m, densities of drop and
/// surroundings in kg/m^3, radius in m.
///
/// ```
/// use meniscus::theory::{angular_frequency, immersed_angular_frequency};
/// // In a void the drop swings alone; in a fluid of its own density slower.
/// let alone = angular_frequency(2, 0.03, 900.0, 1e-3, 3);
/// assert!((immersed_angular_frequency(2, 0.03, 900.0, 0.0, 1e-3, 3) / alone - 1.0).abs() < 1e-14);
/// let equal = immersed_angular_frequency(2, 0.03, 900.0, 900.0, 1e-3, 3);
/// assert!((equal / alone - (3.0_f64 / 5.0).sqrt()).abs() < 1e-14);
/// ```
pub fn immersed_angular_frequency(
    mode: u32,
    surface_tension: f64,
    density: f64,
    density_outside: f64,
    radius: f64,
    dimension: usize,
) -> f64 {
    let n = f64::from(mode);
    let ratio = if dimension == 2 {
        n * (n * n - 1.0) / (density + density_outside)
    } else {
        n * (n * n - 1.0) * (n + 2.0) / ((n + 1.0) * density + n * density_outside)
    };
    (ratio * surface_tension / radius.powi(3)).sqrt()
}

/// The least damped oscillation of mode n (2, 3, ...) of a rod (2D) or drop (3D) in an unbounded
/// fluid, both viscous, from the linearised Navier-Stokes equations; `None` where
/// viscosity is so high that it creeps back without swinging.
///
/// In each fluid the flow is a potential one and one of vorticity with k^2 = s / nu, I_n inside
/// and K_n outside (spherical ones in 3D). s = -b + i omega makes velocity and
/// tangential stress continuous and normal stress jump by sigma times the change of
/// curvature: the normal modes of Lamb, Miller and Scriven (1968), J. Fluid Mech. 32, 417, and
/// Prosperetti (1980), J. Math. Phys. 19, 149. Both densities and viscosities must be
/// above zero.
///
/// Surface tension in N/m, radius in m.
///
/// ```
/// use meniscus::theory::{Medium, two_fluid_oscillation};
/// // A drop of heptane, 2 mm across, in water: without viscosity 87.1 Hz.
/// let heptane = Medium { density: 684.0, viscosity: 0.4e-3 };
/// let water = Medium { density: 998.0, viscosity: 1e-3 };
/// let found = two_fluid_oscillation(2, 0.0505, heptane, water, 1e-3, 3).unwrap();
/// let frequency = found.angular_frequency / (2.0 * std::f64::consts::PI);
/// assert!((83.0..87.0).contains(&frequency));
/// ```
pub fn two_fluid_oscillation(
    mode: u32,
    surface_tension: f64,
    inside: Medium,
    outside: Medium,
    radius: f64,
    dimension: usize,
) -> Option<ViscousOscillation> {
    let [rho, rho_outside] = [inside.density, outside.density];
    let natural =
        immersed_angular_frequency(mode, surface_tension, rho, rho_outside, radius, dimension);
    // In units of R, 1/omega_0 and the mass of both fluids in R^3.
    let total = rho + rho_outside;
    let scaled = |medium: Medium| Medium {
        density: medium.density / total,
        viscosity: medium.viscosity / (total * natural * radius.powi(2)),
    };
    let (inside, outside) = (scaled(inside), scaled(outside));
    let tension = surface_tension / (total * natural.powi(2) * radius.powi(3));
    // The root is followed from viscosities so small that the one without is its start.
    let largest = (inside.viscosity / inside.density).max(outside.viscosity / outside.density);
    let mut part = (1e-5 / largest).min(1.0);
    let mut root = Complex::new(-0.5 * (largest * part).sqrt(), 1.0);
    loop {
        let with = |medium: Medium| Medium {
            viscosity: medium.viscosity * part,
            ..medium
        };
        let fluids = [with(inside), with(outside)];
        root = newton(root, |s| determinant(s, mode, tension, fluids, dimension))?;
        if part >= 1.0 {
            break;
        }
        part = (part * 1.05).min(1.0);
    }
    Some(ViscousOscillation {
        angular_frequency: root.im * natural,
        damping_rate: -root.re * natural,
    })
}

/// Of one flow in one fluid, at r = R = 1.
struct Flow {
    radial: Complex<f64>,
    tangential: Complex<f64>,
    /// Tangential stress over viscosity.
    shear: Complex<f64>,
    /// d u_r / dr
    stretch: Complex<f64>,
    /// Pressure over rho s.
    pressure: f64,
}

impl Flow {
    /// With the stream function x sin(n phi), or the poloidal scalar x Y_n, and its derivatives.
    fn new(
        [x, slope, bend]: [Complex<f64>; 3],
        pressure: f64,
        mode: u32,
        dimension: usize,
    ) -> Self {
        let n = f64::from(mode);
        if dimension == 2 {
            // u_r = n x / r, u_phi = -x'.
            Flow {
                radial: x * n,
                tangential: -slope,
                shear: slope - bend - x * (n * n),
                stretch: (slope - x) * n,
                pressure,
            }
        } else {
            // u_r = n (n + 1) x / r, u_t = x' + x / r.
            let l = n * (n + 1.0);
            Flow {
                radial: x * l,
                tangential: slope + x,
                shear: bend + x * (l - 2.0),
                stretch: (slope - x) * l,
                pressure,
            }
        }
    }
}

/// Zero where the four conditions at the surface can be met. R = 1.
fn determinant(
    s: Complex<f64>,
    mode: u32,
    tension: f64,
    fluids: [Medium; 2],
    dimension: usize,
) -> Complex<f64> {
    let n = f64::from(mode);
    let real = |x: f64| Complex::from(x);
    // r^n and r^-n, or r^-(n+1).
    let power = |p: f64| [real(1.0), real(p), real(p * (p - 1.0))];
    let (fall, at_rest) = if dimension == 2 {
        (-n, [-1.0, 1.0])
    } else {
        (-n - 1.0, [-(n + 1.0), n])
    };
    let [inside, outside] = fluids;
    let k2 = fluids.map(|medium| s * (medium.density / medium.viscosity));
    // x'' by the equation of the Bessel functions.
    let vortical = |k2: Complex<f64>, slope: Complex<f64>| {
        let bend = if dimension == 2 {
            k2 + n * n - slope
        } else {
            k2 + n * (n + 1.0) - slope * 2.0
        };
        [real(1.0), slope, bend]
    };
    let inner_slope = log_derivative(k2[0], mode, dimension);
    let outer_slope = outer_log_derivative(k2[1].sqrt(), mode, dimension);
    let flow = |x, pressure| Flow::new(x, pressure, mode, dimension);
    let flows = [
        (flow(power(n), at_rest[0]), inside, 1.0),
        (flow(vortical(k2[0], inner_slope), 0.0), inside, 1.0),
        (flow(power(fall), at_rest[1]), outside, -1.0),
        (flow(vortical(k2[1], outer_slope), 0.0), outside, -1.0),
    ];
    let curvature = if dimension == 2 {
        n * n - 1.0
    } else {
        (n - 1.0) * (n + 2.0)
    };
    let column = |i: usize| {
        let (flow, medium, side) = &flows[i];
        let normal = s * (medium.density * flow.pressure) - flow.stretch * (2.0 * medium.viscosity);
        let pull = if *side > 0.0 {
            flow.radial * (tension * curvature)
        } else {
            real(0.0)
        };
        // Vortical columns by their shear, which grows as k^2.
        let scale = real(1.0) / flow.shear;
        [
            flow.radial * *side * scale,
            flow.tangential * *side * scale,
            flow.shear * (medium.viscosity * side) * scale,
            (s * normal * *side - pull) * scale,
        ]
    };
    let columns = [0, 1, 2, 3].map(column);
    Matrix4::from_fn(|row, i| columns[i][row]).determinant()
}

/// k K'(k) / K(k) of the modified Bessel function K_n (2D), or the modified spherical one k_n
/// (3D), that falls off; the real part of k above zero.
fn outer_log_derivative(k: Complex<f64>, mode: u32, dimension: usize) -> Complex<f64> {
    let n = f64::from(mode);
    let one = Complex::from(1.0);
    if dimension == 3 {
        // k_0 = 1/k, k_1 = 1/k + 1/k^2 times exp(-k); upwards all terms add.
        let (mut before, mut last) = (one / k, one / k + one / (k * k));
        for m in 1..mode {
            let next = before + last * f64::from(2 * m + 1) / k;
            (before, last) = (last, next);
        }
        return -(k * before / last + n + 1.0);
    }
    // K_n = integral of exp(-k cosh t) cosh(n t) over t > 0, by the trapezoidal rule, which
    // converges exponentially. Where exp falls below 1e-18 of its largest, it ends.
    let end = (1.0 + (42.0 + 8.0 * n) / k.re).acosh();
    let steps = 800;
    let (mut sum, mut slope) = (Complex::from(0.0), Complex::from(0.0));
    for i in 0..=steps {
        let t = end * f64::from(i) / f64::from(steps);
        let weight = if i == 0 { 0.5 } else { 1.0 };
        let term = (-k * (t.cosh() - 1.0)).exp() * ((n * t).cosh() * weight);
        sum += term;
        slope -= term * t.cosh();
    }
    k * slope / sum
}

#[cfg(test)]
mod tests {
    use std::f64::consts::SQRT_2;

    use super::*;
    use crate::theory::viscous_oscillation;

    fn medium(density: f64, viscosity: f64) -> Medium {
        Medium { density, viscosity }
    }

    #[test]
    fn in_a_thin_gas_a_drop_swings_as_in_a_void() {
        for dimension in [2, 3] {
            for (mode, viscosity) in [(2, 1e-3), (2, 0.05), (4, 0.01)] {
                let alone = viscous_oscillation(mode, 1.0, 1.0, viscosity, 1.0, dimension).unwrap();
                let (drop, gas) = (medium(1.0, viscosity), medium(1e-7, 1e-8));
                let found = two_fluid_oscillation(mode, 1.0, drop, gas, 1.0, dimension).unwrap();
                let rate = found.damping_rate / alone.damping_rate;
                let frequency = found.angular_frequency / alone.angular_frequency;
                assert!((frequency - 1.0).abs() < 1e-5, "{dimension}D: {frequency}");
                assert!((rate - 1.0).abs() < 1e-3, "{dimension}D, {mode}: {rate}");
            }
        }
    }

    #[test]
    fn small_viscosities_damp_by_the_layers_beside_the_surface() {
        // 2D: what the layers dissipate by the slip between the two potential flows, over twice
        // the energy. 3D: Marston (1980), J. Acoust. Soc. Am. 67, 15. What comes next is of the
        // relative order of the square root of viscosity.
        let (drop, around) = (medium(0.8, 2e-9), medium(1.3, 0.5e-9));
        for mode in [2, 3, 5] {
            let n = f64::from(mode);
            let m = [drop, around].map(|medium| (medium.density * medium.viscosity).sqrt());
            let layers = m[0] * m[1] / (m[0] + m[1]);
            let mass = [
                drop.density + around.density,
                (n + 1.0) * drop.density + n * around.density,
            ];
            for (dimension, factor) in [
                (2, 2.0 * n / mass[0]),
                (3, (2.0 * n + 1.0).powi(2) / (2.0 * mass[1])),
            ] {
                let [rho, rho_outside] = [drop.density, around.density];
                let omega = immersed_angular_frequency(mode, 1.0, rho, rho_outside, 1.0, dimension);
                let rate = factor * layers * omega.sqrt() / SQRT_2;
                let found = two_fluid_oscillation(mode, 1.0, drop, around, 1.0, dimension).unwrap();
                let ratio = found.damping_rate / rate;
                assert!(
                    (ratio - 1.0).abs() < 2e-3,
                    "{dimension}D, mode {mode}: {ratio}"
                );
                // The layers slow it by as much as they damp it.
                let slower = (omega - found.angular_frequency) / rate;
                assert!(
                    (slower - 1.0).abs() < 2e-3,
                    "{dimension}D, mode {mode}: {slower}"
                );
            }
        }
    }

    #[test]
    fn where_the_outside_is_the_thicker_it_creeps() {
        for dimension in [2, 3] {
            let at = |viscosity: f64| {
                let (drop, around) = (medium(1.0, 0.01), medium(1.0, viscosity));
                two_fluid_oscillation(2, 1.0, drop, around, 1.0, dimension)
            };
            let (thin, thick) = (at(0.01).unwrap(), at(0.1).unwrap());
            assert!(thick.damping_rate > thin.damping_rate);
            assert!(thick.angular_frequency < thin.angular_frequency);
            assert!(at(100.0).is_none());
        }
    }

    #[test]
    fn the_outer_function_is_that_of_tables() {
        // K_2(1) = 1.6248388986, K_1(1) = 0.6019072302: k K_2' / K_2 = -2 - K_1 / K_2.
        let found = outer_log_derivative(Complex::from(1.0), 2, 2);
        assert!((found.re + 2.0 + 0.601_907_230_2 / 1.624_838_898_6).abs() < 1e-9);
        // Far out both fall as exp(-k).
        for dimension in [2, 3] {
            let k = Complex::new(300.0, 200.0);
            let found = outer_log_derivative(k, 2, dimension);
            let power = 0.5 * (dimension as f64 - 1.0);
            assert!(
                (found + k + power).modulus() < 0.01,
                "{dimension}D: {found}"
            );
        }
    }
}
