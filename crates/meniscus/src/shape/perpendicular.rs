//! What is perpendicular to a direction.

use crate::vector::Vector;

/// Two unit vectors across a unit vector and each other; the second counts in 3D alone.
pub(crate) fn perpendiculars<const D: usize>(normal: &Vector<f64, D>) -> [Vector<f64, D>; 2] {
    let n = normal.to_3d();
    if D == 2 {
        return [Vector::from_3d([-n[1], n[0], 0.0]), Vector::ZERO];
    }
    // From the axis that is farthest from the normal, so that planes along axes stay so.
    let mut axis = [0.0; 3];
    let least = (0..3).min_by(|&a, &b| n[a].abs().total_cmp(&n[b].abs()));
    axis[least.unwrap_or(0)] = 1.0;
    let along = axis[0] * n[0] + axis[1] * n[1] + axis[2] * n[2];
    let first: [f64; 3] = std::array::from_fn(|d| axis[d] - along * n[d]);
    let length = Vector(first).norm();
    let first = first.map(|x| x / length);
    let second = [
        n[1] * first[2] - n[2] * first[1],
        n[2] * first[0] - n[0] * first[2],
        n[0] * first[1] - n[1] * first[0],
    ];
    [Vector::from_3d(first), Vector::from_3d(second)]
}
