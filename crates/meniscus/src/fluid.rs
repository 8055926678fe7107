//! What a liquid is made of.

/// One liquid. All SI.
#[derive(Clone, Debug, PartialEq)]
pub struct Fluid {
    /// Name, for messages and output.
    pub name: String,
    /// Density at zero pressure above background, rho_0, kg/m^3.
    pub density: f64,
    /// Numerical speed of sound c, m/s.
    pub sound_speed: f64,
    /// Exponent gamma of Tait's equation of state.
    pub stiffness_exponent: f64,
    /// Pressure added everywhere, Pa.
    pub background_pressure: f64,
    /// Dynamic viscosity mu, Pa s; zero for none.
    pub viscosity: f64,
    /// Surface tension sigma against the surroundings, N/m; zero for none.
    pub surface_tension: f64,
    /// Strength of pairwise forces over that of a sharp surface of this surface tension: one, unless
    /// measured otherwise.
    pub cohesion_factor: f64,
}

impl Fluid {
    /// A fluid of this density, kg/m^3, without viscosity or surface tension;
    /// Tait's exponent 7, sound speed 10 m/s: set it to at least ten times the
    /// fastest flow.
    pub fn new(name: &str, density: f64) -> Self {
        Self {
            name: name.to_owned(),
            density,
            sound_speed: 10.0,
            stiffness_exponent: 7.0,
            background_pressure: 0.0,
            viscosity: 0.0,
            surface_tension: 0.0,
            cohesion_factor: 1.0,
        }
    }
}
