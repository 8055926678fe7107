//! Where a profile of liquid meets a wall, and at what angle.
//!
//! Places are (x, y) in a frame whose origin is a point of the wall, the drop's axis y going from there into
//! the liquid. A wall of curvature k, positive where it bulges into the liquid, is the circle
//! y + k (x^2 + y^2) / 2 = 0, a flat one the line y = 0.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::arc::{Arc, OnArc};
use super::estimate::{Estimate, student_t};

/// How far outside of the outermost particle centres the surface lies, in spacings, and
/// by how much that may be wrong: its 95 % interval.
pub const DEPTH: f64 = 0.5;
pub const DEPTH_UNKNOWN: f64 = 0.2;

/// How far down the wall is looked for: so many times as far as the lowest point of the profile is from the axis.
const FAR: f64 = 10.0;

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
    /// By the arc nearest to points of the surface near the wall, x growing
    /// towards the outside of the liquid. One that turns back before the wall is taken to touch it where it is nearest,
    /// at 180 degrees. `None` for fewer than five points, or an arc that leads nowhere. The wall's curvature is in 1/m.
    pub fn fit(near: &[[f64; 2]], shift: Shift, wall_curvature: f64) -> Option<Self> {
        let level = |[x, y]: [f64; 2]| y + 0.5 * wall_curvature * (x * x + y * y);
        let normal = |[x, y]: [f64; 2]| [wall_curvature * x, 1.0 + wall_curvature * y];
        // It climbs, with the liquid on its left.
        let arc = Arc::fit(near, normal)?;
        let lowest = (near.iter()).min_by(|p, q| level(**p).total_cmp(&level(**q)))?;
        let at = |s: f64| arc.at(s, shift.outwards);
        let above = |s: f64| level(at(s).place);
        let climbs = |s: f64| {
            let OnArc { place, direction } = at(s);
            let (up, (sin, cos)) = (normal(place), direction.sin_cos());
            up[0] * cos + up[1] * sin > 0.0
        };
        let start = arc.nearest(*lowest);
        let extent = lowest[0].hypot(lowest[1]);
        let end = start - (FAR * extent).min(PI / arc.curvature().abs());
        // Down to the wall, or to where it is nearest.
        let bottom = last(climbs, start, end);
        let s = match above(bottom) > 0.0 {
            true if bottom > end => bottom,
            true => return None,
            false => last(|s| above(s) > 0.0, start, bottom),
        };
        let OnArc { place, direction } = at(s);
        let up = normal(place);
        // Between the profile and the wall that the liquid covers.
        let angle = PI - (direction - (-up[0]).atan2(up[1]));
        // Of all that differ by whole turns the one about 90 degrees.
        let angle = (angle + FRAC_PI_2).rem_euclid(TAU) - FRAC_PI_2;
        let t = student_t(arc.freedom.max(4) as f64);
        let [across, turn] = arc.errors(s);
        Some(Foot {
            angle: Estimate {
                value: angle,
                half_width: t * turn,
            },
            place: Estimate {
                value: place[0],
                half_width: (t * across).hypot(shift.unknown) * up[1].abs() / angle.sin().abs(),
            },
        })
    }
}

/// Where a condition that holds at `from` ceases to, on the way to `to`; `to` if it never does.
fn last(holds: impl Fn(f64) -> bool, from: f64, to: f64) -> f64 {
    if holds(to) {
        return to;
    }
    let (mut yes, mut no) = (from, to);
    for _ in 0..60 {
        let middle = 0.5 * (yes + no);
        match holds(middle) {
            true => yes = middle,
            false => no = middle,
        }
    }
    yes
}
