//! Whether a point is inside a polygon.

use super::geometry::ROUNDING;
use crate::vector::Vector;

/// Whether `point` is inside the polygon with these corners, by the parity of
/// the edges that a ray along +x crosses. A point on an edge is outside.
pub(super) fn contains(corners: &[Vector<f64, 2>], point: Vector<f64, 2>) -> bool {
    let (low, high) = bounding_box(corners);
    let on_edge = ROUNDING * (high - low).norm();
    let mut inside = false;
    for (i, &end) in corners.iter().enumerate() {
        let start = corners[(i + corners.len() - 1) % corners.len()];
        if distance_to_segment(point, start, end) <= on_edge {
            return false;
        }
        let crosses = (start[1] > point[1]) != (end[1] > point[1]);
        if crosses {
            let along = (point[1] - start[1]) / (end[1] - start[1]);
            if point[0] < start[0] + along * (end[0] - start[0]) {
                inside = !inside;
            }
        }
    }
    inside
}

/// The lowest and the highest coordinates of the corners.
pub(super) fn bounding_box(corners: &[Vector<f64, 2>]) -> (Vector<f64, 2>, Vector<f64, 2>) {
    let mut low = Vector([f64::INFINITY; 2]);
    let mut high = Vector([f64::NEG_INFINITY; 2]);
    for corner in corners {
        for d in 0..2 {
            low[d] = low[d].min(corner[d]);
            high[d] = high[d].max(corner[d]);
        }
    }
    (low, high)
}

fn distance_to_segment(point: Vector<f64, 2>, start: Vector<f64, 2>, end: Vector<f64, 2>) -> f64 {
    let edge = end - start;
    let length_squared = edge.norm_squared();
    let along = if length_squared > 0.0 {
        (point - start).dot(&edge) / length_squared
    } else {
        0.0
    };
    (point - start - edge * along.clamp(0.0, 1.0)).norm()
}
