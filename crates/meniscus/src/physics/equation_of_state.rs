//! Tait's equation of state:
//!
//! p = rho_0 c^2 / gamma ((rho / rho_0)^gamma - 1) + p_b
//!
//! with p_b the background pressure. Monaghan (1994), J. Comput. Phys. 110,
//! 399; Jancik and Hyhlik, eq. 6.

use crate::fluid::Fluid;

/// Tait's equation of state of one fluid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tait {
    /// rho_0, kg/m^3
    pub reference_density: f64,
    /// rho_0 c^2 / gamma, Pa
    pub stiffness: f64,
    /// gamma
    pub exponent: f64,
    /// p_b, Pa
    pub background: f64,
}

impl Tait {
    /// The equation of state of `fluid`.
    pub fn new(fluid: &Fluid) -> Self {
        Self {
            reference_density: fluid.density,
            stiffness: fluid.density * fluid.sound_speed.powi(2) / fluid.stiffness_exponent,
            exponent: fluid.stiffness_exponent,
            background: fluid.background_pressure,
        }
    }

    /// Pressure in Pa at `density` in kg/m^3.
    ///
    /// ```
    /// use meniscus::physics::equation_of_state::Tait;
    /// let water = Tait { reference_density: 1000.0, stiffness: 1000.0 * 25.0 / 7.0, exponent: 7.0, background: 0.0 };
    /// assert_eq!(water.pressure(1000.0), 0.0);
    /// // For a small excess of density, p = c^2 (rho - rho_0).
    /// assert!((water.pressure(1000.001) / (25.0 * 0.001) - 1.0).abs() < 1e-5);
    /// ```
    pub fn pressure(&self, density: f64) -> f64 {
        let ratio = density / self.reference_density;
        self.stiffness * (power(ratio, self.exponent) - 1.0) + self.background
    }

    /// Density in kg/m^3 at `pressure` in Pa; at least half of rho_0, where a liquid would
    /// long have torn.
    ///
    /// ```
    /// use meniscus::physics::equation_of_state::Tait;
    /// let water = Tait { reference_density: 1000.0, stiffness: 1000.0 * 25.0 / 7.0, exponent: 7.0, background: 2.0 };
    /// assert!((water.density(water.pressure(1005.0)) / 1005.0 - 1.0).abs() < 1e-14);
    /// assert_eq!(water.density(-1e9), 500.0);
    /// ```
    pub fn density(&self, pressure: f64) -> f64 {
        let power = 1.0 + (pressure - self.background) / self.stiffness;
        self.reference_density * power.max(0.0).powf(1.0 / self.exponent).max(0.5)
    }
}

/// A power by multiplication where the exponent is a small whole number, as it nearly always is.
fn power(base: f64, exponent: f64) -> f64 {
    if exponent.fract() == 0.0 && (1.0..=32.0).contains(&exponent) {
        crate::Real::powi(base, exponent as u32)
    } else {
        base.powf(exponent)
    }
}
