//! How wide a body is across a direction.

use std::f64::consts::PI;

use crate::vector::Vector;

/// Directions in 3D, over half a turn.
const DIRECTIONS: usize = 8;

/// Mean width of a body across a direction of any length, m: that between the outermost of its
/// particles, and the spacing (m) that they stand for. In 3D the mean over eight directions. `None`
/// without particles.
///
/// ```
/// use meniscus::{Vector, measure::width_across};
/// let row: Vec<_> = (0..10).map(|i| Vector([f64::from(i), 3.0])).collect();
/// assert_eq!(width_across(&row, Vector([0.0, -1.0]), 1.0), Some(10.0));
/// ```
pub fn width_across<const D: usize>(
    position: &[Vector<f64, D>],
    direction: Vector<f64, D>,
    spacing: f64,
) -> Option<f64> {
    let normal = (direction * (1.0 / direction.norm())).to_3d();
    let cross = |a: [f64; 3], b: [f64; 3]| {
        [0, 1, 2].map(|d| a[(d + 1) % 3] * b[(d + 2) % 3] - a[(d + 2) % 3] * b[(d + 1) % 3])
    };
    // A first direction across: in 2D the only one.
    let other = match D {
        2 => [0.0, 0.0, 1.0],
        _ if normal[0].abs() < 0.8 => [1.0, 0.0, 0.0],
        _ => [0.0, 1.0, 0.0],
    };
    let first = cross(normal, other);
    let length = first.iter().map(|x| x * x).sum::<f64>().sqrt();
    let first = first.map(|x| x / length);
    let second = cross(normal, first);
    let count = if D == 2 { 1 } else { DIRECTIONS };
    let width = |k: usize| {
        let (sin, cos) = (PI * k as f64 / count as f64).sin_cos();
        let unit: Vector<f64, D> =
            Vector::from_3d([0, 1, 2].map(|d| cos * first[d] + sin * second[d]));
        let along = || position.iter().map(|x| x.dot(&unit));
        let low = along().fold(f64::INFINITY, f64::min);
        along().fold(f64::NEG_INFINITY, f64::max) - low + spacing
    };
    (!position.is_empty()).then(|| (0..count).map(width).sum::<f64>() / count as f64)
}

#[cfg(test)]
mod tests {
    use super::width_across;
    use crate::measure::samples::cut;
    use crate::vector::Vector;

    #[test]
    fn a_flat_ellipsoid_is_as_wide_as_its_disc_from_whatever_side() {
        for (axis, jitter) in [(0, 0.0), (1, 0.2), (2, 0.2)] {
            let flat = |x: &Vector<f64, 3>| {
                let square = |d: usize| (x[d] / if d == axis { 3.0 } else { 10.0 }).powi(2);
                (0..3).map(square).sum::<f64>() < 1.0
            };
            let points = cut(12.0, 0.3, jitter, flat);
            let mut normal = Vector::ZERO;
            normal[axis] = -2.0;
            // The outermost particle centre lies up to a spacing inside of a thin edge.
            let found = width_across(&points, normal, 1.0).unwrap();
            assert!((found - 20.0).abs() < 1.0, "{axis}: {found}");
        }
        assert_eq!(width_across::<2>(&[], Vector([0.0, 1.0]), 1.0), None);
    }
}
