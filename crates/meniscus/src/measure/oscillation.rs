//! The surface tension that an oscillating rod or drop shows.

use crate::theory::{equivalent_radius, surface_tension_from_frequency};

use super::damped_cosine::DampedCosine;
use super::estimate::Estimate;

/// Surface tension measured by the frequency of a small oscillation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OscillationSurfaceTension {
    /// Radius of the circle or sphere with the body's volume, m.
    pub radius: f64,
    /// Surface tension by Rayleigh's formula from the frequency as fitted, N/m:
    /// what Jancik and Hyhlik print.
    pub plain: Estimate,
    /// The same from sqrt(omega^2 + b^2), N/m: the frequency that a damping
    /// force proportional to velocity hides. To leading order in viscosity this is right
    /// for a body of liquid too ([`crate::theory::viscous_oscillation`] has all orders).
    pub damping_corrected: Estimate,
}

impl OscillationSurfaceTension {
    /// From the fit of an oscillation of this mode (2, 3, ...) of a rod (`dimension` 2) or
    /// drop (3) with this density (kg/m^3) and volume (m^3; m^2 in 2D).
    ///
    /// The intervals are those of the fit; density and volume count as exact.
    pub fn measure(
        fit: &DampedCosine,
        mode: u32,
        density: f64,
        volume: f64,
        dimension: usize,
    ) -> Self {
        let radius = equivalent_radius(volume, dimension);
        let of = |omega: Estimate| {
            let sigma =
                surface_tension_from_frequency(mode, omega.value, density, radius, dimension);
            omega.propagate(sigma, 2.0 * sigma / omega.value)
        };
        OscillationSurfaceTension {
            radius,
            plain: of(fit.angular_frequency),
            damping_corrected: of(fit.undamped_angular_frequency),
        }
    }
}
