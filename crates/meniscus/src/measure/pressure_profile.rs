//! Pressure against depth in a liquid at rest.

use crate::vector::Vector;

/// How pressure grows downwards. The last axis points up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PressureProfile {
    /// The largest difference, Pa, of a particle's pressure from the weight above it.
    pub largest_error: f64,
    /// Slope of a straight line fitted to pressure over depth, Pa/m; NaN for fewer than two
    /// depths.
    pub gradient: f64,
    /// That line at the surface, Pa.
    pub at_surface: f64,
}

impl PressureProfile {
    /// From the positions (m) and pressures (Pa) of the particles of a liquid that weighs `weight`
    /// (N/m^3) and has its surface at the height `level` (m). The line is fitted where the depth is
    /// within `fitted` (m).
    ///
    /// ```
    /// use meniscus::Vector;
    /// use meniscus::measure::PressureProfile;
    /// let positions = [Vector([0.0, 1.5]), Vector([0.0, 1.0]), Vector([0.0, 0.5])];
    /// let profile = PressureProfile::measure(&positions, &[6.0, 11.0, 16.0], 10.0, 2.0, 0.0..2.0);
    /// assert_eq!((profile.largest_error, profile.gradient, profile.at_surface), (1.0, 10.0, 1.0));
    /// ```
    pub fn measure<const D: usize>(
        positions: &[Vector<f64, D>],
        pressures: &[f64],
        weight: f64,
        level: f64,
        fitted: std::ops::Range<f64>,
    ) -> Self {
        let depths = || positions.iter().map(|x| level - x[D - 1]).zip(pressures);
        let largest_error = depths()
            .map(|(depth, pressure)| (pressure - weight * depth).abs())
            .fold(0.0, f64::max);
        let inner = || depths().filter(|(depth, _)| fitted.contains(depth));
        let count = inner().count() as f64;
        let mean_depth = inner().map(|(depth, _)| depth).sum::<f64>() / count;
        let mean_pressure = inner().map(|(_, pressure)| pressure).sum::<f64>() / count;
        let moment = |of: &dyn Fn(f64, f64) -> f64| -> f64 {
            inner()
                .map(|(depth, pressure)| of(depth - mean_depth, pressure - mean_pressure))
                .sum()
        };
        let gradient =
            moment(&|depth, pressure| depth * pressure) / moment(&|depth, _| depth * depth);
        Self {
            largest_error,
            gradient,
            at_surface: mean_pressure - gradient * mean_depth,
        }
    }
}
