//! What a scheme states of a van der Waals fluid.

use super::substance::Substance;

/// How heat is conducted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Conduction {
    /// Pairs exchange heat by their difference of temperature: rho_i dU_i/dt =
    /// sum_j V_j 4 kappa_i kappa_j / (kappa_i + kappa_j) (T_i - T_j) r . grad W / r^2. Brookshaw
    /// (1985), Proc. Astron. Soc. Aust. 6, 207; Cleary and Monaghan (1999), J. Comput. Phys. 148, 227.
    Brookshaw,
    /// The divergence of -kappa grad T, either by a sum of its own (Sigalotti, Daza and Donoso,
    /// eq. 4 and 6). Blind to differences from one particle to the next, which grow until
    /// temperatures fall below zero.
    DoubleSum,
}

/// A van der Waals fluid. SI; in two dimensions a density is in kg/m^2, and what follows from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VanDerWaals {
    /// Equation of state.
    pub substance: Substance,
    /// Temperature at the start, K.
    pub temperature: f64,
    /// Heat conductivity kappa, W/(m K); zero for none.
    pub conductivity: f64,
    /// Bulk viscosity zeta, Pa s; zero for none. The shear viscosity is that of the
    /// [`Fluid`](crate::Fluid).
    pub bulk_viscosity: f64,
    /// How heat is conducted.
    pub conduction: Conduction,
    /// Range H of cohesion over the smoothing length.
    pub cohesion_range: f64,
    /// Whether H follows smoothing lengths that adapt. Energy is then conserved with the grad-h
    /// terms of [`AdaptiveSmoothing`](crate::scheme::AdaptiveSmoothing) alone.
    pub cohesion_adapts: bool,
}

impl VanDerWaals {
    /// A fluid without bulk viscosity and conduction that starts at this temperature, K; cohesion
    /// over twice the smoothing length.
    pub fn new(substance: Substance, temperature: f64) -> Self {
        Self {
            substance,
            temperature,
            conductivity: 0.0,
            bulk_viscosity: 0.0,
            conduction: Conduction::Brookshaw,
            cohesion_range: 2.0,
            cohesion_adapts: false,
        }
    }
}
