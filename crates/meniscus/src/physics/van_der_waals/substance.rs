//! The van der Waals equation of state, per unit of mass (Sigalotti, Daza and Donoso, eq. 7, 8):
//!
//! - p = rho R T / (1 - b rho) - a rho^2
//! - U = xi/2 R T - a rho
//!
//! with R = k_B / m the specific gas constant, a the strength of cohesion, b the volume that is
//! out of reach, xi the degrees of freedom of a molecule. In units of the critical point,
//! rho_c = 1 / (3 b), T_c = 8 a / (27 R b), p_c = a / (27 b^2), it is the same for all fluids:
//! p_r = 8 T_r rho_r / (3 - rho_r) - 3 rho_r^2.

use crate::theory::coexistence;

/// Least value that 1 - b rho is taken to have. Particles that are thrown together may pass
/// density 1/b, where the pressure of the fluid has no bound; that of the particles has this one.
pub const LEAST_FREE_VOLUME: f64 = 0.03;

/// R of an ideal gas per mole, J/(mol K): exact, by the definition of the mole and the kelvin.
const MOLAR_GAS_CONSTANT: f64 = 8.314_462_618_153_24;

/// What a van der Waals fluid is made of. SI; in two dimensions a density is in kg/m^2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Substance {
    /// Specific gas constant R = k_B / m, J/(kg K)
    pub gas_constant: f64,
    /// Cohesion a, Pa m^6/kg^2
    pub cohesion: f64,
    /// Excluded volume b, m^3/kg: density stays below 1/b
    pub excluded_volume: f64,
    /// Degrees of freedom xi of a molecule
    pub degrees_of_freedom: f64,
}

/// Where liquid and vapour become one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CriticalPoint {
    /// T_c, K
    pub temperature: f64,
    /// p_c, Pa
    pub pressure: f64,
    /// rho_c, kg/m^3
    pub density: f64,
}

impl Substance {
    /// The substance of this critical temperature (K) and pressure (Pa) and molar mass (kg/mol).
    ///
    /// ```
    /// use meniscus::physics::van_der_waals::Substance;
    /// // Carbon dioxide: handbooks give a = 0.364 J m^3/mol^2 and b = 42.7 cm^3/mol.
    /// let molar_mass = 0.04401;
    /// let carbon_dioxide = Substance::of_critical_point(304.13, 7.377e6, molar_mass, 6.0);
    /// let a = carbon_dioxide.cohesion * molar_mass.powi(2);
    /// let b = carbon_dioxide.excluded_volume * molar_mass;
    /// assert!((a / 0.364 - 1.0).abs() < 0.01 && (b / 42.7e-6 - 1.0).abs() < 0.01);
    /// ```
    pub fn of_critical_point(
        temperature: f64,
        pressure: f64,
        molar_mass: f64,
        degrees_of_freedom: f64,
    ) -> Self {
        let gas_constant = MOLAR_GAS_CONSTANT / molar_mass;
        let thermal = gas_constant * temperature;
        Self {
            gas_constant,
            cohesion: 27.0 * thermal * thermal / (64.0 * pressure),
            excluded_volume: thermal / (8.0 * pressure),
            degrees_of_freedom,
        }
    }

    /// The substance of cohesion `cohesion` (Pa m^6/kg^2) whose liquid is of this density, kg/m^3, where it stands beside
    /// its vapour at `temperature` K, which is `reduced_temperature` of that of the critical point. None unless that
    /// lies between 0 and 1.
    ///
    /// ```
    /// use meniscus::physics::van_der_waals::Substance;
    /// let fluid = Substance::of_liquid(2.0, 1.8071, 290.0, 0.85, 3.0).expect("below the critical point");
    /// let critical = fluid.critical_point();
    /// assert!((critical.temperature * 0.85 / 290.0 - 1.0).abs() < 1e-12);
    /// // Tables of the van der Waals fluid give a liquid of 1.8071 critical densities, and its pressure.
    /// assert!((critical.density - 1.0).abs() < 1e-4);
    /// assert!((fluid.pressure(1.8071, 290.0) / critical.pressure - 0.50449).abs() < 1e-3);
    /// ```
    pub fn of_liquid(
        cohesion: f64,
        density: f64,
        temperature: f64,
        reduced_temperature: f64,
        degrees_of_freedom: f64,
    ) -> Option<Self> {
        let critical_density = density / coexistence(reduced_temperature)?.liquid;
        let excluded_volume = 1.0 / (3.0 * critical_density);
        let critical_temperature = temperature / reduced_temperature;
        Some(Self {
            gas_constant: 8.0 * cohesion / (27.0 * excluded_volume * critical_temperature),
            cohesion,
            excluded_volume,
            degrees_of_freedom,
        })
    }

    /// The same fluid with all energies of its molecules `factor` times as large: its pressures and its surface
    /// tension are that many times as large at the same densities and temperatures, and so is the square of any speed.
    ///
    /// ```
    /// use meniscus::physics::van_der_waals::Substance;
    /// let fluid = Substance::of_liquid(2.0, 1.8, 300.0, 0.3, 3.0).expect("a liquid");
    /// let strong = fluid.stronger(4.0);
    /// assert_eq!(strong.critical_point().temperature, fluid.critical_point().temperature);
    /// assert_eq!(strong.pressure(1.9, 280.0), 4.0 * fluid.pressure(1.9, 280.0));
    /// assert_eq!(strong.sound_speed(1.9, 280.0), 2.0 * fluid.sound_speed(1.9, 280.0));
    /// ```
    pub fn stronger(self, factor: f64) -> Self {
        Self {
            gas_constant: factor * self.gas_constant,
            cohesion: factor * self.cohesion,
            ..self
        }
    }

    /// The critical point.
    ///
    /// ```
    /// use meniscus::physics::van_der_waals::Substance;
    /// // Sigalotti, Daza and Donoso: a = 2, b = 1/2, k_B/m = 1.
    /// let (gas_constant, cohesion, excluded_volume) = (1.0, 2.0, 0.5);
    /// let fluid = Substance { gas_constant, cohesion, excluded_volume, degrees_of_freedom: 2.0 };
    /// let critical = fluid.critical_point();
    /// assert!((critical.density - 2.0 / 3.0).abs() < 1e-15);
    /// assert!((critical.pressure - 8.0 / 27.0).abs() < 1e-15);
    /// assert!((critical.temperature - 32.0 / 27.0).abs() < 1e-15);
    /// // There the isotherm is flat.
    /// let p = |rho| fluid.pressure(rho, critical.temperature);
    /// assert!((p(2.0 / 3.0) - 8.0 / 27.0).abs() < 1e-15);
    /// assert!((p(0.67) - p(0.66)).abs() < 1e-6);
    /// ```
    pub fn critical_point(&self) -> CriticalPoint {
        let b = self.excluded_volume;
        CriticalPoint {
            temperature: 8.0 * self.cohesion / (27.0 * self.gas_constant * b),
            pressure: self.cohesion / (27.0 * b * b),
            density: 1.0 / (3.0 * b),
        }
    }

    /// Pressure, Pa, at a density (kg/m^3) and temperature (K).
    pub fn pressure(&self, density: f64, temperature: f64) -> f64 {
        self.repulsion(density, temperature) - self.cohesion * density * density
    }

    /// Its part rho R T / (1 - b rho), Pa, with [`LEAST_FREE_VOLUME`].
    pub fn repulsion(&self, density: f64, temperature: f64) -> f64 {
        density * self.gas_constant * temperature / self.free_volume(density)
    }

    /// Heat capacity at constant volume, xi/2 R, J/(kg K).
    pub fn heat_capacity(&self) -> f64 {
        0.5 * self.degrees_of_freedom * self.gas_constant
    }

    /// Internal energy, J/kg, at a density (kg/m^3) and temperature (K).
    pub fn internal_energy(&self, density: f64, temperature: f64) -> f64 {
        self.heat_capacity() * temperature - self.cohesion * density
    }

    /// Speed of sound, m/s, at a density (kg/m^3) and temperature (K):
    /// c^2 = (1 + 2/xi) R T / (1 - b rho)^2 - 2 a rho. NaN where the fluid is unstable.
    ///
    /// ```
    /// use meniscus::physics::van_der_waals::Substance;
    /// let (gas_constant, cohesion, excluded_volume) = (1.0, 2.0, 0.5);
    /// let fluid = Substance { gas_constant, cohesion, excluded_volume, degrees_of_freedom: 2.0 };
    /// // Along an adiabat T (1/rho - b)^(2/xi) stays; c^2 is the slope of p there.
    /// let adiabat = |rho: f64| 0.32 * (1.0 / 1.83 - 0.5) / (1.0 / rho - 0.5);
    /// let p = |rho: f64| fluid.pressure(rho, adiabat(rho));
    /// let slope = (p(1.8301) - p(1.8299)) / 2e-4;
    /// assert!((fluid.sound_speed(1.83, 0.32).powi(2) / slope - 1.0).abs() < 1e-4);
    /// ```
    pub fn sound_speed(&self, density: f64, temperature: f64) -> f64 {
        let stiff = self.stiff_sound_speed(density, temperature);
        (stiff * stiff - 2.0 * self.cohesion * density).sqrt()
    }

    /// That of the repulsive part alone, m/s: what short waves run at, which cohesion does not see.
    pub fn stiff_sound_speed(&self, density: f64, temperature: f64) -> f64 {
        let ratio = 1.0 + 2.0 / self.degrees_of_freedom;
        (ratio * self.gas_constant * temperature).sqrt() / self.free_volume(density)
    }

    fn free_volume(&self, density: f64) -> f64 {
        (1.0 - self.excluded_volume * density).max(LEAST_FREE_VOLUME)
    }
}
