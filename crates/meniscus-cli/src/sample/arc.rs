//! Curvature along a round part of the surface.

use std::f64::consts::PI;

use meniscus_case::Arc;

/// Column of `curvature_along`.
pub const DEVIATION: (&str, &str) = ("curvature deviation", "");

/// Of the particles within half a `spacing` (m) of the arc, in its part: the angle from the x axis (rad), and what
/// belongs to them.
pub fn along(
    arc: &Arc,
    spacing: f64,
    places: impl Iterator<Item = ([f64; 3], f64)>,
) -> Vec<(f64, f64)> {
    let seen = places.filter_map(|(at, value)| {
        let [x, y, z] = [0, 1, 2].map(|d| at[d] - arc.centre[d]);
        let radius = (x * x + y * y + z * z).sqrt();
        // In 3D the polar angle about the x axis.
        let angle = match z == 0.0 {
            true => y.atan2(x).rem_euclid(2.0 * PI),
            false => (x / radius).clamp(-1.0, 1.0).acos(),
        };
        let near = (radius - arc.radius).abs() <= 0.5 * spacing;
        (near && angle >= arc.from && angle <= arc.to).then_some((angle, value))
    });
    seen.collect()
}

/// Root mean square of curvature times radius, less what a round surface has.
pub fn deviation(arc: &Arc, dimension: usize, along: &[(f64, f64)]) -> f64 {
    let exact = (dimension - 1) as f64;
    let square = |(_, curvature): &(f64, f64)| (curvature * arc.radius / exact - 1.0).powi(2);
    (along.iter().map(square).sum::<f64>() / along.len() as f64).sqrt()
}
