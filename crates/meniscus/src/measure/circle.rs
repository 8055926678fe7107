//! The circle or sphere that passes nearest to given points.

use nalgebra::{DMatrix, DVector};

use crate::vector::Vector;

/// A fitted circle (2D) or sphere (3D).
#[derive(Clone, Debug)]
pub struct Circle<const D: usize> {
    pub centre: Vector<f64, D>,
    pub radius: f64,
    /// Covariance of the centre's coordinates and the radius, in the square of their unit.
    pub covariance: DMatrix<f64>,
    /// Points beyond the D + 1 that determine it.
    pub freedom: usize,
}

impl<const D: usize> Circle<D> {
    /// Least squares of the distances from the circle, by Gauss and Newton from the algebraic fit;
    /// `None` for fewer than D + 3 points, or points on a line.
    pub fn fit(points: &[Vector<f64, D>]) -> Option<Self> {
        let freedom = points.len().checked_sub(D + 1).filter(|&n| n >= 2)?;
        // About their mean and in units of their extent, all numbers are of the order of one.
        let count = points.len() as f64;
        let mut middle = Vector::ZERO;
        points.iter().for_each(|&x| middle += x * (1.0 / count));
        let squares = points.iter().map(|&x| (x - middle).norm_squared());
        let unit = (squares.sum::<f64>() / count).sqrt();
        let scaled: Vec<_> = points
            .iter()
            .map(|&x| (x - middle) * (1.0 / unit))
            .collect();

        // |x|^2 = 2 c.x + (R^2 - |c|^2): linear in c and the last bracket.
        let row = |x: &Vector<f64, D>, d: usize| if d < D { 2.0 * x[d] } else { 1.0 };
        let matrix = DMatrix::from_fn(scaled.len(), D + 1, |i, d| row(&scaled[i], d));
        let right = DVector::from_fn(scaled.len(), |i, _| scaled[i].norm_squared());
        let start = solve(&matrix, &right)?.0;
        let mut centre = Vector::<f64, D>(std::array::from_fn(|d| start[d]));
        let mut radius = (start[D] + centre.norm_squared()).sqrt();
        let mut covariance = DMatrix::zeros(D + 1, D + 1);
        for _ in 0..50 {
            let slopes = DMatrix::from_fn(scaled.len(), D + 1, |i, d| {
                let arm = scaled[i] - centre;
                if d < D { arm[d] / arm.norm() } else { 1.0 }
            });
            let left = DVector::from_fn(scaled.len(), |i, _| (scaled[i] - centre).norm() - radius);
            let (step, inverse) = solve(&slopes, &left)?;
            (0..D).for_each(|d| centre[d] += step[d]);
            radius += step[D];
            covariance = inverse * (left.norm_squared() / freedom as f64 * unit * unit);
            if step.norm() < 1e-10 * radius {
                break;
            }
        }
        (radius.is_finite() && radius > 0.0).then(|| Circle {
            centre: middle + centre * unit,
            radius: radius * unit,
            covariance,
            freedom,
        })
    }
}

/// Least squares, and the inverse of the normal matrix.
pub fn solve(matrix: &DMatrix<f64>, right: &DVector<f64>) -> Option<(DVector<f64>, DMatrix<f64>)> {
    let inverse = matrix.tr_mul(matrix).try_inverse()?;
    let solution = &inverse * matrix.tr_mul(right);
    (solution.iter().all(|x| x.is_finite())).then_some((solution, inverse))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::samples::Random;

    #[test]
    fn points_of_an_arc_give_their_circle_back() {
        let centre = Vector([3e3, -1e3]);
        let arc: Vec<_> = (0..12)
            .map(|i| (0.5 + 0.05 * f64::from(i)).sin_cos())
            .map(|(sin, cos)| centre + Vector([7.0 * cos, 7.0 * sin]))
            .collect();
        let found = Circle::fit(&arc).unwrap();
        assert!((found.centre - centre).norm() < 1e-6 && (found.radius - 7.0).abs() < 1e-6);
        // On a line, or too few.
        let line: Vec<_> = (0..12).map(|i| Vector([f64::from(i), 1.0])).collect();
        assert!(Circle::fit(&line).is_none_or(|found| found.radius > 1e6));
        assert!(Circle::fit(&arc[..4]).is_none());
    }

    #[test]
    fn the_spread_of_many_fits_is_the_stated_one() {
        let mut random = Random(11);
        let (mut within, trials) = (0, 400);
        for _ in 0..trials {
            let cap: Vec<Vector<f64, 3>> = (0..80)
                .map(|i| (0.5 * (f64::from(i) / 80.0).sqrt(), 2.4 * f64::from(i)))
                .map(|(polar, turn)| {
                    let radius = 5.0 + 0.05 * random.normal();
                    Vector([
                        radius * polar.sin() * turn.cos(),
                        radius * polar.sin() * turn.sin(),
                        radius * polar.cos(),
                    ])
                })
                .collect();
            let found = Circle::fit(&cap).unwrap();
            let deviation = found.covariance[(3, 3)].sqrt();
            within += i32::from((found.radius - 5.0).abs() < 1.96 * deviation);
        }
        // 380 expected, give or take 4.4.
        assert!((362..=396).contains(&within), "{within}");
    }
}
