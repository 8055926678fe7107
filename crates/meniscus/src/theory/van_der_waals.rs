//! A van der Waals fluid at rest: liquid beside vapour, and the tension of a sharp surface.
//!
//! In units of the critical point, p = 8 T rho / (3 - rho) - 3 rho^2 for every such fluid.

use crate::kernel::Kernel;

/// Liquid and vapour that can stand beside each other, in units of the critical point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coexistence {
    /// Density of the liquid over that of the critical point
    pub liquid: f64,
    /// Density of the vapour likewise
    pub vapour: f64,
    /// Pressure of both likewise
    pub pressure: f64,
}

/// Pressure over the critical one at this density and temperature over the critical ones.
pub fn reduced_pressure(density: f64, temperature: f64) -> f64 {
    8.0 * temperature * density / (3.0 - density) - 3.0 * density * density
}

/// What Maxwell's construction gives at this temperature, in units of the critical point; none
/// at 1 and above, where there is one phase.
///
/// By half of the entropy of evaporation, y, everything is known in closed form (Lekner 1982, Am. J. Phys.
/// 50, 161): f = (y cosh y - sinh y) / (sinh y cosh y - y), v = b (1 + exp(-+y) / f).
///
/// ```
/// use meniscus::theory::{coexistence, reduced_pressure};
/// let both = coexistence(0.85).expect("below the critical point");
/// // The same pressure on either side, and under the isotherm between them (equal areas).
/// for density in [both.liquid, both.vapour] {
///     assert!((reduced_pressure(density, 0.85) / both.pressure - 1.0).abs() < 1e-9);
/// }
/// let (from, to) = (1.0 / both.liquid, 1.0 / both.vapour);
/// let step = (to - from) / 1e5;
/// let area: f64 = (0..100_000).map(|k| {
///     reduced_pressure(1.0 / (from + (k as f64 + 0.5) * step), 0.85) * step
/// }).sum();
/// assert!((area / (both.pressure * (to - from)) - 1.0).abs() < 1e-8);
/// // Tables of the van der Waals fluid give p = 0.50449, densities 1.8071 and 0.31973.
/// assert!((both.pressure - 0.50449).abs() < 1e-5);
/// assert!((both.liquid - 1.8071).abs() < 1e-4 && (both.vapour - 0.31973).abs() < 1e-5);
/// assert_eq!(coexistence(1.0), None);
/// ```
pub fn coexistence(temperature: f64) -> Option<Coexistence> {
    if !(temperature > 0.0 && temperature < 1.0) {
        return None;
    }
    // Temperature falls with y, from 1 at 0; beyond 300 vapour is thinner than any number.
    let (mut low, mut high) = (0.0, 300.0);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if of_entropy(middle).0 > temperature {
            low = middle;
        } else {
            high = middle;
        }
    }
    Some(of_entropy(0.5 * (low + high)).1)
}

/// Temperature and phases for half of an entropy of evaporation over R.
fn of_entropy(y: f64) -> (f64, Coexistence) {
    let f = if y < 0.05 {
        // Both differences begin with the third power.
        let square = y * y;
        (1.0 / 3.0 + square / 30.0 + square * square / 840.0)
            / (2.0 / 3.0 + square * 2.0 / 15.0 + square * square * 4.0 / 315.0)
    } else {
        (y * y.cosh() - y.sinh()) / (y.sinh() * y.cosh() - y)
    };
    let g = 1.0 + 2.0 * f * y.cosh() + f * f;
    let temperature = 27.0 * f * (f + y.cosh()) / (4.0 * g * g);
    let phases = Coexistence {
        liquid: 3.0 / (1.0 + (-y).exp() / f),
        vapour: 3.0 / (1.0 + y.exp() / f),
        pressure: 27.0 * f * f * (1.0 - f * f) / (g * g),
    };
    (temperature, phases)
}

/// Between these densities over that of the critical point, the lower first, a fluid of this
/// temperature over the critical one falls apart by itself: the spinodal,
/// 4 T = rho (3 - rho)^2. None at 1 and above.
///
/// ```
/// use meniscus::theory::{reduced_pressure, spinodal};
/// for density in spinodal(0.8).expect("below the critical point") {
///     let slope = reduced_pressure(density + 1e-6, 0.8) - reduced_pressure(density - 1e-6, 0.8);
///     assert!(slope.abs() < 1e-10);
/// }
/// assert_eq!(spinodal(1.2), None);
/// ```
pub fn spinodal(temperature: f64) -> Option<[f64; 2]> {
    if !(temperature > 0.0 && temperature < 1.0) {
        return None;
    }
    let excess = |rho: f64| rho * (3.0 - rho).powi(2) - 4.0 * temperature;
    let root = |mut unstable: f64, mut stable: f64| {
        for _ in 0..100 {
            let middle = 0.5 * (unstable + stable);
            if excess(middle) > 0.0 {
                unstable = middle;
            } else {
                stable = middle;
            }
        }
        0.5 * (unstable + stable)
    };
    Some([root(1.0, 0.0), root(1.0, 3.0)])
}

/// Surface tension, N/m, of a liquid of this density that ends in a step, by cohesion of this
/// strength a (Pa m^6/kg^2) through a kernel of this smoothing length (m):
/// 2 a rho^2 times the integral of W r^2 dr in two dimensions, pi a rho^2 times that of W r^3 dr in three.
///
/// The energy that the half of each pair lacks which would be beyond the step. A surface that is
/// free to soften has less.
///
/// ```
/// use meniscus::{Kernel, theory::step_surface_tension};
/// // Lucy's kernel: the integral of W r^2 dr in two dimensions is 0.06063 H.
/// let sigma = step_surface_tension(2.0, 1.8, Kernel::LucyQuartic, 4.5, 2);
/// assert!((sigma / (2.0 * 2.0 * 1.8 * 1.8 * 0.06063 * 4.5) - 1.0).abs() < 1e-4);
/// ```
pub fn step_surface_tension(
    cohesion: f64,
    density: f64,
    kernel: Kernel,
    smoothing_length: f64,
    dimension: usize,
) -> f64 {
    let support = kernel.support() * smoothing_length;
    // By Simpson's rule; kernels are smooth but for a knot or two.
    let intervals = 3000;
    let width = support / intervals as f64;
    let integral: f64 = (0..=intervals)
        .map(|k| {
            let r = k as f64 * width;
            let weight = match k {
                0 => 1.0,
                k if k == intervals => 1.0,
                k if k % 2 == 1 => 4.0,
                _ => 2.0,
            };
            weight * kernel.value(r, smoothing_length, dimension) * r.powi(dimension as i32)
        })
        .sum::<f64>()
        * width
        / 3.0;
    let angles = if dimension == 2 {
        2.0
    } else {
        std::f64::consts::PI
    };
    angles * cohesion * density * density * integral
}
