//! Which way the particles of a wall face.
//!
//! Their layers reach further along the wall than into it, whichever layer a particle is of: the normal is the axis of the least
//! variance of places around. Sign it has none. Where a wall ends, or bends sharply, there is no normal: places around a particle have
//! their middle off it along the wall. Nor is there one where another part of the wall lies before it within the kernel's support: what is
//! missing there of the liquid is not beyond its edge.

use nalgebra::{DMatrix, SymmetricEigen};

use crate::cells::Cells;
use crate::domain::Domain;
use crate::vector::Vector;

/// How far particles look around, in spacings.
const REACH: f64 = 3.2;
/// Most of the second least variance that the least one may be.
const THIN: f64 = 0.7;
/// How much thicker than the kernel's support a wall is at most, in spacings, its bend within the support included.
const THICKER: f64 = 0.6;
/// How far along the wall the middle may be off, in spacings.
const OFF: f64 = 0.3;

/// Unit normals of walls at `places`, m, whose particles are about `spacing`, m, apart, in layers as thick as the kernel's
/// `support`, m; zero where there is none.
///
/// ```
/// use meniscus::Vector;
/// use meniscus::domain::Domain;
/// use meniscus::physics::wall::normals;
///
/// // Three layers on the x axis.
/// let plane: Vec<_> = (0..60).map(|k| Vector([f64::from(k % 20), f64::from(-(k / 20))])).collect();
/// let found = normals(&plane, 1.0, 3.0, &Domain::default());
/// assert!([10, 30, 50].iter().all(|&k: &usize| found[k][1].abs() > 1.0 - 1e-12));
/// assert_eq!(found[0], Vector([0.0, 0.0]));
/// ```
pub fn normals<const D: usize>(
    places: &[Vector<f64, D>],
    spacing: f64,
    support: f64,
    domain: &Domain<D>,
) -> Vec<Vector<f64, D>> {
    let reach = support.max(REACH * spacing);
    let mut cells = Cells::new(reach);
    for (i, &x) in places.iter().enumerate() {
        domain.for_each_image(x, reach, &mut |x| cells.add(i, x));
    }
    let axes: Vec<_> = places
        .iter()
        .map(|x| thinnest(&cells, x, spacing, support))
        .collect();
    // The mean over those around: layers of round walls do not fit each other.
    let mean = |x: &Vector<f64, D>| {
        let mut sum = [[0.0; D]; D];
        cells.near(x, |j, _| {
            let (axis, has_one) = axes[j];
            if has_one {
                add_square(&mut sum, &axis);
            }
        });
        sorted(DMatrix::from_fn(D, D, |d, e| sum[d][e]))
            .1
            .pop()
            .unwrap_or(Vector::ZERO)
    };
    (places.iter().zip(&axes))
        .map(|(x, (_, has_one))| if *has_one { mean(x) } else { Vector::ZERO })
        .collect()
}

/// Adds the products of a vector's components.
fn add_square<const D: usize>(sum: &mut [[f64; D]; D], vector: &Vector<f64, D>) {
    for (d, row) in sum.iter_mut().enumerate() {
        for (e, product) in row.iter_mut().enumerate() {
            *product += vector[d] * vector[e];
        }
    }
}

/// Eigenvalues of a symmetric matrix, from the least, and their unit vectors.
fn sorted<const D: usize>(matrix: DMatrix<f64>) -> (Vec<f64>, Vec<Vector<f64, D>>) {
    let found = SymmetricEigen::new(matrix);
    let mut order: Vec<usize> = (0..D).collect();
    order.sort_by(|&a, &b| found.eigenvalues[a].total_cmp(&found.eigenvalues[b]));
    let vector = |&k: &usize| Vector(std::array::from_fn(|d| found.eigenvectors[(d, k)]));
    (
        order.iter().map(|&k| found.eigenvalues[k]).collect(),
        order.iter().map(vector).collect(),
    )
}

/// The axis along which places around one vary the least, and whether it is a normal.
fn thinnest<const D: usize>(
    cells: &Cells<D>,
    x: &Vector<f64, D>,
    spacing: f64,
    support: f64,
) -> (Vector<f64, D>, bool) {
    let (mut middle, mut count) = (Vector::ZERO, 0.0);
    let mut square = [[0.0; D]; D];
    let mut arms = Vec::new();
    cells.near(x, |_, y| {
        let arm = (y - *x) * (1.0 / spacing);
        arms.push(arm);
        if arm.norm() > REACH {
            return;
        }
        middle += arm;
        add_square(&mut square, &arm);
        count += 1.0;
    });
    middle = middle * (1.0 / count);
    let variance = DMatrix::from_fn(D, D, |d, e| square[d][e] / count - middle[d] * middle[e]);
    let (values, axes) = sorted::<D>(variance);
    let off = middle - axes[0] * axes[0].dot(&middle);
    let along = arms.iter().map(|arm| arm.dot(&axes[0]));
    let (low, high) = along.fold((0.0_f64, 0.0_f64), |(low, high), z| {
        (low.min(z), high.max(z))
    });
    let one = high - low < support / spacing + THICKER;
    (
        axes[0],
        one && values[0] < THIN * values[1] && off.norm() < OFF,
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::wall::layout::{Layers, Side};

    /// Rings do not fit each other; where a wall bends sharply is left out.
    #[test]
    fn walls_face_outwards() {
        let layers = Layers::new(1.0, 4.0, 100_000);
        let along = |place: Vector<f64, 2>, normal: Vector<f64, 2>| {
            (place.dot(&normal) / place.norm()).abs()
        };
        for (radius, side) in [(12.5, Side::Inside), (10.0, Side::Outside)] {
            let ring = layers.ball(Vector([0.0, 0.0]), radius, side).unwrap();
            let found = normals(&ring, 1.0, 4.0, &Domain::default());
            for (place, normal) in ring.into_iter().zip(found) {
                assert!(
                    along(place, normal) > 5_f64.to_radians().cos(),
                    "{place:?} {normal:?}"
                );
            }
        }
        let (low, high) = (Vector([0.0, 0.0]), Vector([20.0, 20.0]));
        let tank = layers.tank(low, high, &[(1, true)]).unwrap();
        let within = |place: Vector<f64, 2>| (-place[0]).max(place[0] - 20.0).max(-place[1]);
        let found = normals(&tank, 1.0, 4.0, &Domain::default());
        for (place, normal) in tank.into_iter().zip(found) {
            let beside = place[0] < 0.0 || place[0] > 20.0;
            let [along, across] = if beside { [1, 0] } else { [0, 1] };
            let from_end = place[along].min(20.0 - place[along]);
            if from_end > 4.0 {
                assert!(normal[across].abs() > 0.999, "{place:?} {normal:?}");
            }
            let from_corner = if beside { place[1] } else { from_end };
            if from_corner > 0.0 && from_corner < 3.0 && within(place) < 1.0 {
                // Deeper layers see less of what stands before them.
                assert_eq!(normal, Vector::ZERO, "{place:?}");
            }
        }
    }
}
