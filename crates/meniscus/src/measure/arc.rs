//! The arc of a circle, or the straight line, that passes nearest to points of a plane.

use std::f64::consts::PI;

use nalgebra::{DMatrix, DVector};

use super::circle::solve;

/// An arc through `middle`, where its length s is zero and its direction is that of `lean` from the x axis. It bends to
/// the left by its curvature; a straight line has none.
#[derive(Clone, Debug)]
pub struct Arc {
    /// m
    middle: [f64; 2],
    /// rad
    lean: f64,
    /// 1/m
    curvature: f64,
    /// Inverse of the normal matrix of the three: shift to the left, turn, curvature.
    inverse: DMatrix<f64>,
    /// Square of the points' distance from it over `freedom`, m^2.
    variance: f64,
    /// Points beyond the three that determine it.
    pub freedom: usize,
}

/// A place of an arc, m, and the direction there, rad from the x axis.
#[derive(Clone, Copy, Debug)]
pub struct OnArc {
    pub place: [f64; 2],
    pub direction: f64,
}

impl Arc {
    /// Least squares of the distances from it, by Gauss and Newton from the principal axis of the points (m), in the
    /// direction that is `up` for their mean; `None` for fewer than five, or all at one place.
    pub fn fit(points: &[[f64; 2]], up: impl Fn([f64; 2]) -> [f64; 2]) -> Option<Self> {
        let freedom = points.len().checked_sub(3).filter(|&n| n >= 2)?;
        let count = points.len() as f64;
        let mean = |d: usize| points.iter().map(|p| p[d]).sum::<f64>() / count;
        let middle = [mean(0), mean(1)];
        let moment = |d: usize, e: usize| {
            let products = points
                .iter()
                .map(|p| (p[d] - middle[d]) * (p[e] - middle[e]));
            products.sum::<f64>() / count
        };
        let unit = (moment(0, 0) + moment(1, 1)).sqrt();
        let mut lean = 0.5 * (2.0 * moment(0, 1)).atan2(moment(0, 0) - moment(1, 1));
        let [right, above] = up(middle);
        if right * lean.cos() + above * lean.sin() < 0.0 {
            lean += PI;
        }
        let mut arc = Self {
            middle,
            lean,
            curvature: 0.0,
            inverse: DMatrix::zeros(3, 3),
            variance: f64::NAN,
            freedom,
        };
        for _ in 0..50 {
            let left = DVector::from_iterator(points.len(), points.iter().map(|&p| arc.left_by(p)));
            // In units of the points' extent all columns are of the order of one.
            let slopes = DMatrix::from_fn(points.len(), 3, |i, k| {
                arc.moves(points[i])[k] / unit.powi(k as i32)
            });
            let (step, inverse) = solve(&slopes, &(&left / unit))?;
            let scale = DVector::from_fn(3, |k, _| unit.powi(1 - k as i32));
            arc.inverse = DMatrix::from_fn(3, 3, |j, k| {
                inverse[(j, k)] * scale[j] * scale[k] / unit.powi(2)
            });
            arc.variance = left.norm_squared() / freedom as f64;
            let (sin, cos) = arc.lean.sin_cos();
            let shift = step[0] * unit;
            arc.middle = [arc.middle[0] - shift * sin, arc.middle[1] + shift * cos];
            arc.lean += step[1];
            arc.curvature += step[2] / unit;
            if step.norm() < 1e-10 {
                break;
            }
        }
        let found = [arc.middle[0], arc.middle[1], arc.lean, arc.curvature];
        found.iter().all(|x| x.is_finite()).then_some(arc)
    }

    /// 1/m, positive where it bends to the left.
    pub fn curvature(&self) -> f64 {
        self.curvature
    }

    /// A point in the frame of the middle: along the arc's direction there, and to the left of it.
    fn local(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let (sin, cos) = self.lean.sin_cos();
        let (a, b) = (x - self.middle[0], y - self.middle[1]);
        [a * cos + b * sin, b * cos - a * sin]
    }

    /// How far the circle's centre is from a point, over its radius.
    fn arm(&self, [a, b]: [f64; 2]) -> f64 {
        let k = self.curvature;
        (1.0 - 2.0 * k * b + k * k * (a * a + b * b)).sqrt()
    }

    /// How far a point lies to the left of the arc, m.
    fn left_by(&self, point: [f64; 2]) -> f64 {
        let [a, b] = self.local(point);
        2.0 * (b - 0.5 * self.curvature * (a * a + b * b)) / (1.0 + self.arm([a, b]))
    }

    /// By how much the arc comes nearer to a point on its left, for each parameter.
    fn moves(&self, point: [f64; 2]) -> [f64; 3] {
        let [a, b] = self.local(point);
        let arm = self.arm([a, b]);
        let left = self.left_by(point);
        [
            (1.0 - self.curvature * b) / arm,
            a / arm,
            0.5 * (a * a + b * b - left * left) / arm,
        ]
    }

    /// The length at which the arc is nearest to a point.
    pub fn nearest(&self, point: [f64; 2]) -> f64 {
        let [a, b] = self.local(point);
        let k = self.curvature;
        // The angle at the centre over the curvature, on a straight line a.
        let (sin, cos) = (k * a, 1.0 - k * b);
        let turn = sin.atan2(cos);
        match turn.abs() < 1e-6 {
            true => a / cos,
            false => turn / k,
        }
    }

    /// The place at length s from the middle, moved by `right` (m) to the right.
    pub fn at(&self, s: f64, right: f64) -> OnArc {
        let turn = self.curvature * s;
        // Along the chord: it is sin(turn / 2) / (turn / 2) of the arc's length, and half the turn off its direction.
        let half = 0.5 * turn;
        let chord = match half.abs() < 1e-6 {
            true => s,
            false => s * half.sin() / half,
        };
        let (sin, cos) = (self.lean + half).sin_cos();
        let direction = self.lean + turn;
        let (up, along) = direction.sin_cos();
        OnArc {
            place: [
                self.middle[0] + chord * cos + right * up,
                self.middle[1] + chord * sin - right * along,
            ],
            direction,
        }
    }

    /// Standard errors at length s: of the place across the arc, m, and of the direction, rad.
    pub fn errors(&self, s: f64) -> [f64; 2] {
        let place = self.at(s, 0.0).place;
        [self.moves(place), [0.0, 1.0, s]].map(|gradient| {
            let g = DVector::from_row_slice(&gradient);
            (self.variance * (g.transpose() * &self.inverse * &g)[0]).sqrt()
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::samples::Random;

    /// Points of an arc of this curvature through (3, 1), at 45 degrees there.
    fn points(curvature: f64, noise: f64, random: &mut Random) -> Vec<[f64; 2]> {
        let exact = Arc {
            middle: [3.0, 1.0],
            lean: 0.25 * PI,
            curvature,
            inverse: DMatrix::zeros(3, 3),
            variance: 0.0,
            freedom: 0,
        };
        (0..20)
            .map(|i| (exact.at(0.3 * f64::from(i), noise * random.normal())).place)
            .collect()
    }

    #[test]
    fn points_of_an_arc_or_a_line_give_it_back() {
        for curvature in [0.2, 0.1, 1e-5, 0.0, -1e-9, -0.3] {
            let points = points(curvature, 0.0, &mut Random(3));
            let arc = Arc::fit(&points, |_| [1.0, 1.0]).unwrap();
            assert!(
                (arc.curvature - curvature).abs() < 1e-9,
                "{curvature}: {arc:?}"
            );
            let found = arc.at(arc.nearest([3.0, 1.0]), 0.0);
            assert!((found.place[0] - 3.0).hypot(found.place[1] - 1.0) < 1e-8);
            assert!((found.direction - 0.25 * PI).abs() < 1e-8);
        }
        let nothing = points(0.1, 0.0, &mut Random(3));
        assert!(Arc::fit(&nothing[..4], |_| [1.0, 1.0]).is_none());
        assert!(Arc::fit(&[[1.0, 2.0]; 9], |_| [1.0, 1.0]).is_none());
    }

    #[test]
    fn errors_beyond_the_end_are_those_of_many_fits() {
        let mut random = Random(5);
        let (mut within, trials) = ([0; 2], 400);
        for _ in 0..trials {
            let arc = Arc::fit(&points(0.1, 0.05, &mut random), |_| [1.0, 1.0]).unwrap();
            let s = arc.nearest([3.0, 1.0]);
            let found = arc.at(s, 0.0);
            let off = [
                (found.place[0] - 3.0).hypot(found.place[1] - 1.0),
                (found.direction - 0.25 * PI).abs(),
            ];
            for (k, error) in arc.errors(s).into_iter().enumerate() {
                // Student's t of 17 freedoms.
                within[k] += i32::from(off[k] < 2.11 * error);
            }
        }
        // 380 expected, give or take 4.4.
        for within in within {
            assert!((362..=396).contains(&within), "{within}");
        }
    }
}
