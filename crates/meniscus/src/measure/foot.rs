//! Where a profile of liquid meets a wall, and at what angle.
//!
//! Places are (x, y) in a frame whose origin is a point of the wall, the drop's axis y going from there into
//! the liquid. A wall of curvature k, positive where it bulges into the liquid, is the circle
//! y + k (x^2 + y^2) / 2 = 0, a flat one the line y = 0.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use nalgebra::{DMatrix, DVector};

use super::circle::solve;
use super::estimate::{Estimate, student_t};

/// How far outside of the outermost particle centres the surface lies, in spacings, and
/// by how much that may be wrong: its 95 % interval.
pub const DEPTH: f64 = 0.5;
pub const DEPTH_UNKNOWN: f64 = 0.2;

/// Where and how a profile meets the wall.
pub struct Foot {
    /// Contact angle through the liquid, rad.
    pub angle: Estimate,
    /// How far from the axis, m.
    pub place: Estimate,
}

/// How far the surface lies outside of the profile, m, and by how much that may be wrong, its 95 % interval.
#[derive(Clone, Copy)]
pub struct Shift {
    /// m
    pub outwards: f64,
    /// m
    pub unknown: f64,
}

impl Foot {
    /// By a parabola over the straight line along points of the surface near the wall, x growing
    /// towards the outside of the liquid. `None` for fewer than five, or none that meets the wall, whose
    /// curvature is in 1/m.
    pub fn fit(near: &[[f64; 2]], shift: Shift, wall_curvature: f64) -> Option<Self> {
        let freedom = near.len().checked_sub(3).filter(|&n| n >= 2)?;
        let count = near.len() as f64;
        let mean = |d: usize| near.iter().map(|p| p[d]).sum::<f64>() / count;
        let middle = [mean(0), mean(1)];
        let moment = |d: usize, e: usize| {
            near.iter()
                .map(|p| (p[d] - middle[d]) * (p[e] - middle[e]))
                .sum::<f64>()
        };
        let level = |[x, y]: [f64; 2]| y + 0.5 * wall_curvature * (x * x + y * y);
        let normal = |[x, y]: [f64; 2]| [wall_curvature * x, 1.0 + wall_curvature * y];
        let climb = |up: [f64; 2], along: [f64; 2]| up[0] * along[0] + up[1] * along[1];
        // Direction of the line along the points, away from the wall.
        let mut lean = 0.5 * (2.0 * moment(0, 1)).atan2(moment(0, 0) - moment(1, 1));
        if climb(normal(middle), [lean.cos(), lean.sin()]) < 0.0 {
            lean += PI;
        }
        let (sin, cos) = lean.sin_cos();
        // Coordinates along the line, and across it, out of the liquid.
        let turned: Vec<[f64; 2]> = near
            .iter()
            .map(|p| [p[0] - middle[0], p[1] - middle[1]])
            .map(|[a, b]| [a * cos + b * sin, a * sin - b * cos])
            .collect();
        let matrix = DMatrix::from_fn(turned.len(), 3, |i, k| turned[i][0].powi(k as i32));
        let right = DVector::from_fn(turned.len(), |i, _| turned[i][1]);
        let (curve, inverse) = solve(&matrix, &right)?;
        let left = (&matrix * &curve - right).norm_squared() / freedom as f64;
        // A place of the parabola, and its direction.
        let at = |s: f64| {
            let y = curve[0] + s * (curve[1] + s * curve[2]) + shift.outwards;
            let slope = curve[1] + 2.0 * s * curve[2];
            (
                [middle[0] + s * cos + y * sin, middle[1] + s * sin - y * cos],
                [cos + slope * sin, sin - slope * cos],
                slope,
            )
        };
        // To the wall by Newton, from where the straight line points to it.
        let mut s = -level(middle) / climb(normal(middle), [cos, sin]);
        for _ in 0..30 {
            let (place, along, _) = at(s);
            s -= level(place) / climb(normal(place), along);
        }
        let (place, along, slope) = at(s);
        let up = normal(place);
        // Between the profile and the wall that the liquid covers.
        let angle = PI - (along[1].atan2(along[0]) - (-up[0]).atan2(up[1]));
        // Of all that differ by whole turns the one about 90 degrees.
        let angle = (angle + FRAC_PI_2).rem_euclid(TAU) - FRAC_PI_2;
        let t = student_t(freedom.max(4) as f64);
        let spread = |gradient: [f64; 3]| {
            let g = DVector::from_row_slice(&gradient);
            t * (left * (g.transpose() * &inverse * &g)[0]).sqrt()
        };
        let found = Foot {
            angle: Estimate {
                value: angle,
                half_width: spread([0.0, 1.0, 2.0 * s]) / (1.0 + slope * slope),
            },
            place: Estimate {
                value: place[0],
                half_width: spread([1.0, s, s * s]).hypot(shift.unknown) * up[1].abs()
                    / angle.sin().abs(),
            },
        };
        (found.angle.value.is_finite() && found.place.value.is_finite()).then_some(found)
    }
}
