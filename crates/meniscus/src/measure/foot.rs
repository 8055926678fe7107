//! Where a profile of liquid meets a flat wall, and at what angle.

use std::f64::consts::PI;

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
    /// Where along the wall, m.
    pub place: Estimate,
}

impl Foot {
    /// By a parabola over the straight line along the outermost particle centres near the wall:
    /// where they lie along the wall, towards the outside of the liquid, and their
    /// distance from it. `None` for fewer than five, or none that meets the wall.
    pub fn fit(near: &[[f64; 2]], spacing: f64) -> Option<Self> {
        let freedom = near.len().checked_sub(3).filter(|&n| n >= 2)?;
        let count = near.len() as f64;
        let mean = |d: usize| near.iter().map(|p| p[d]).sum::<f64>() / count;
        let middle = [mean(0), mean(1)];
        let moment = |d: usize, e: usize| {
            near.iter()
                .map(|p| (p[d] - middle[d]) * (p[e] - middle[e]))
                .sum::<f64>()
        };
        // Direction of the line along the points, upwards along the profile.
        let mut lean = 0.5 * (2.0 * moment(0, 1)).atan2(moment(0, 0) - moment(1, 1));
        if lean < 0.0 {
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
        let depth = DEPTH * spacing;
        // Along the parabola to the wall: height = middle + s sin - (y + depth) cos = 0.
        let mut s = -middle[1] / sin;
        for _ in 0..30 {
            let y = curve[0] + s * (curve[1] + s * curve[2]) + depth;
            let slope = curve[1] + 2.0 * s * curve[2];
            let miss = middle[1] + s * sin - y * cos;
            s -= miss / (sin - slope * cos);
        }
        let slope = curve[1] + 2.0 * s * curve[2];
        let y = curve[0] + s * (curve[1] + s * curve[2]) + depth;
        // The profile's direction leans by `lean` and by its slope there, towards the outside.
        let angle = PI - (lean - slope.atan());
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
                value: middle[0] + s * cos + y * sin,
                half_width: spread([1.0, s, s * s]).hypot(DEPTH_UNKNOWN * spacing)
                    / angle.sin().abs(),
            },
        };
        (found.angle.value.is_finite() && found.place.value.is_finite()).then_some(found)
    }
}
