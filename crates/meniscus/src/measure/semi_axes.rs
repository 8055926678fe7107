//! The semi-axes of a body of particles, and the surface energy of the ellipse
//! or ellipsoid that has them.

use crate::theory::{ellipse_perimeter, ellipsoid_area};
use crate::vector::Vector;

use super::centre_of_mass;

/// The uniform ellipse or ellipsoid that has the second moments of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PrincipalAxes<const D: usize> {
    /// Semi-axes, m, the longest first.
    pub semi_axes: [f64; D],
    /// Their directions: unit vectors of either sign. Of axes of equal length
    /// any that are orthogonal.
    pub directions: [Vector<f64, D>; D],
}

impl<const D: usize> PrincipalAxes<D> {
    /// By second moments about the centre of mass: a semi-axis is
    /// sqrt((D + 2) eigenvalue) of the mean of x x^T, so 2 sqrt(eigenvalue) in 2D and
    /// sqrt(5 eigenvalue) in 3D. `None` without mass.
    ///
    /// Particles count as points. The cell of spacing dx that each stands for
    /// would add (D + 2) dx^2 / 12 to the square of a semi-axis (square or cubic
    /// lattice): 0.1 % at 13 particles to the radius in 2D.
    pub fn by_moments(positions: &[Vector<f64, D>], masses: &[f64]) -> Option<Self> {
        let mut moments = second_moments(positions, masses)?;
        let directions = diagonalise(&mut moments);
        let mut order: [usize; D] = std::array::from_fn(|d| d);
        order.sort_by(|&d, &e| moments[e][e].total_cmp(&moments[d][d]));
        Some(PrincipalAxes {
            semi_axes: order.map(|d| semi_axis::<D>(moments[d][d])),
            directions: order.map(|d| directions[d]),
        })
    }
}

/// Semi-axes along x, y (and z) by second moments, m: as
/// [`PrincipalAxes::by_moments`], of the diagonal instead of the eigenvalues.
/// For a body whose axes lie along the coordinates, where each must keep its
/// name when another outgrows it. `None` without mass.
pub fn semi_axes_along_coordinates<const D: usize>(
    positions: &[Vector<f64, D>],
    masses: &[f64],
) -> Option<[f64; D]> {
    let moments = second_moments(positions, masses)?;
    Some(std::array::from_fn(|d| semi_axis::<D>(moments[d][d])))
}

/// Semi-axes along x, y (and z) by tips, m: half of the distance between the
/// outermost particles, plus half a spacing, because the surface lies about half
/// a spacing outside the outermost centres. `None` without particles.
pub fn semi_axes_by_tips<const D: usize>(
    positions: &[Vector<f64, D>],
    spacing: f64,
) -> Option<[f64; D]> {
    let first = *positions.first()?;
    Some(std::array::from_fn(|d| {
        let (low, high) = positions
            .iter()
            .fold((first[d], first[d]), |(low, high), x| {
                (low.min(x[d]), high.max(x[d]))
            });
        0.5 * (high - low) + 0.5 * spacing
    }))
}

/// Surface energy, J: surface tension (N/m) times the perimeter (2D) or area (3D)
/// of the ellipse or ellipsoid with these semi-axes (m). For a body that is
/// not one, this is an estimate from below: shapes of higher mode have more surface.
pub fn surface_energy<const D: usize>(semi_axes: [f64; D], surface_tension: f64) -> f64 {
    surface_tension
        * match semi_axes[..] {
            [a, b] => ellipse_perimeter(a, b),
            [a, b, c] => ellipsoid_area(a, b, c),
            _ => f64::NAN,
        }
}

fn semi_axis<const D: usize>(moment: f64) -> f64 {
    ((D as f64 + 2.0) * moment.max(0.0)).sqrt()
}

/// The mean of (x - centre) (x - centre)^T, weighted by mass.
fn second_moments<const D: usize>(
    positions: &[Vector<f64, D>],
    masses: &[f64],
) -> Option<[[f64; D]; D]> {
    let centre = centre_of_mass(positions, masses)?;
    let (mut sum, mut mass) = ([[0.0; D]; D], 0.0);
    for (&x, &m) in positions.iter().zip(masses) {
        let r = x - centre;
        for d in 0..D {
            for e in 0..D {
                sum[d][e] += m * r[d] * r[e];
            }
        }
        mass += m;
    }
    Some(sum.map(|row| row.map(|entry| entry / mass)))
}

/// Brings a symmetric matrix to diagonal form by Jacobi's rotations, which stay
/// accurate for equal eigenvalues, and returns the eigenvectors in the order of
/// the diagonal. Golub and Van Loan, Matrix Computations, sec. 8.5.
fn diagonalise<const D: usize>(matrix: &mut [[f64; D]; D]) -> [Vector<f64, D>; D] {
    let mut directions: [Vector<f64, D>; D] =
        std::array::from_fn(|d| Vector(std::array::from_fn(|e| f64::from(u8::from(d == e)))));
    // Convergence is quadratic: a handful of sweeps reaches rounding.
    for _ in 0..12 {
        for p in 0..D {
            for q in p + 1..D {
                let off = matrix[p][q];
                if off == 0.0 {
                    continue;
                }
                let ratio = (matrix[q][q] - matrix[p][p]) / (2.0 * off);
                let tangent = ratio.signum() / (ratio.abs() + ratio.hypot(1.0));
                let cos = 1.0 / tangent.hypot(1.0);
                let sin = tangent * cos;
                let turn =
                    |at_p: f64, at_q: f64| (cos * at_p - sin * at_q, sin * at_p + cos * at_q);
                for row in matrix.iter_mut() {
                    (row[p], row[q]) = turn(row[p], row[q]);
                }
                let (row_p, row_q) = (matrix[p], matrix[q]);
                for (d, (at_p, at_q)) in row_p.into_iter().zip(row_q).enumerate() {
                    (matrix[p][d], matrix[q][d]) = turn(at_p, at_q);
                }
                (matrix[p][q], matrix[q][p]) = (0.0, 0.0);
                let (at_p, at_q) = (directions[p], directions[q]);
                directions[p] = at_p * cos - at_q * sin;
                directions[q] = at_p * sin + at_q * cos;
            }
        }
    }
    directions
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    /// Points of a square or cubic lattice inside the ellipsoid of these semi-axes,
    /// its first axis turned by `angle` from x towards y, then moved by `shift`.
    fn filled<const D: usize>(
        semi_axes: [f64; D],
        spacing: f64,
        angle: f64,
        shift: f64,
    ) -> Vec<Vector<f64, D>> {
        let reach = (semi_axes.iter().copied().fold(0.0, f64::max) / spacing) as i64 + 1;
        let side = 2 * reach + 1;
        let (sin, cos) = angle.sin_cos();
        (0..side.pow(D as u32))
            .map(|mut index| {
                Vector(std::array::from_fn(|_| {
                    let step = index % side - reach;
                    index /= side;
                    step as f64 * spacing
                }))
            })
            .filter(|x: &Vector<f64, D>| {
                (0..D).map(|d| (x[d] / semi_axes[d]).powi(2)).sum::<f64>() <= 1.0
            })
            .map(|mut x| {
                (x[0], x[1]) = (cos * x[0] - sin * x[1], sin * x[0] + cos * x[1]);
                x.0 = x.0.map(|component| component + shift);
                x
            })
            .collect()
    }

    #[test]
    fn a_filled_ellipse_has_its_own_semi_axes() {
        let spacing = 0.01;
        let x = filled([1.25, 1.0], spacing, 0.0, 0.0);
        let m = vec![0.1; x.len()];
        let found = PrincipalAxes::by_moments(&x, &m).unwrap().semi_axes;
        let along = semi_axes_along_coordinates(&x, &m).unwrap();
        let tips = semi_axes_by_tips(&x, spacing).unwrap();
        for (d, exact) in [1.25, 1.0].into_iter().enumerate() {
            // The points in a curved outline miss its area by about (spacing / size)^(3/2).
            assert!((found[d] / exact - 1.0).abs() < 1e-3, "{found:?}");
            assert!((along[d] - found[d]).abs() < 1e-12);
            // A tip lies on a row of the lattice: within half a spacing.
            assert!((tips[d] - exact).abs() <= 0.51 * spacing, "{tips:?}");
        }
    }

    #[test]
    fn a_filled_ellipsoid_has_its_own_semi_axes() {
        let x = filled([0.6, 1.0, 0.8], 0.025, 0.0, 0.0);
        let m = vec![2.0; x.len()];
        let axes = PrincipalAxes::by_moments(&x, &m).unwrap();
        for (found, exact) in axes.semi_axes.into_iter().zip([1.0, 0.8, 0.6]) {
            // As in 2D, with 25 to 40 spacings to a semi-axis: (1/25)^(3/2) = 8e-3.
            assert!((found / exact - 1.0).abs() < 8e-3, "{:?}", axes.semi_axes);
        }
        assert!(axes.directions[0][1].abs() > 1.0 - 1e-12);
        assert!(axes.directions[2][0].abs() > 1.0 - 1e-12);
    }

    #[test]
    fn turning_and_moving_a_body_changes_directions_only() {
        let (angle, shift) = (0.7_f64, 1e3);
        let before = filled([1.25, 1.0, 0.5], 0.05, 0.0, 0.0);
        let after = filled([1.25, 1.0, 0.5], 0.05, angle, shift);
        let m = vec![1.0; before.len()];
        let [before, after] = [before, after].map(|x| PrincipalAxes::by_moments(&x, &m).unwrap());
        for d in 0..3 {
            // Rounding of positions a thousand sizes away from the origin.
            assert!((before.semi_axes[d] - after.semi_axes[d]).abs() < 1e-9);
        }
        let turned = Vector([angle.cos(), angle.sin(), 0.0]);
        assert!(after.directions[0].dot(&turned).abs() > 1.0 - 1e-9);
    }

    #[test]
    fn a_disc_a_point_and_nothing() {
        // The lattice disc is symmetric under a quarter turn: its axes agree to rounding.
        let disc = filled([1.0, 1.0], 0.05, 0.3, 0.0);
        let axes = PrincipalAxes::by_moments(&disc, &vec![1.0; disc.len()]).unwrap();
        assert!((axes.semi_axes[0] - axes.semi_axes[1]).abs() < 1e-12);
        assert!(axes.directions[0].dot(&axes.directions[1]).abs() < 1e-14);
        let point = PrincipalAxes::by_moments(&[Vector([3.0, 4.0])], &[1.0]).unwrap();
        assert_eq!(point.semi_axes, [0.0, 0.0]);
        assert_eq!(PrincipalAxes::<2>::by_moments(&[], &[]), None);
        assert_eq!(semi_axes_by_tips::<3>(&[], 1.0), None);
    }

    #[test]
    fn surface_energy_of_circle_and_sphere() {
        assert!((surface_energy([2.0, 2.0], 0.5) - 2.0 * PI).abs() < 1e-14);
        assert!((surface_energy([2.0, 2.0, 2.0], 0.5) - 8.0 * PI).abs() < 1e-13);
        // Deformed at constant area, the surface grows.
        assert!(surface_energy([2.5, 1.6], 0.5) > 2.0 * PI);
    }
}
