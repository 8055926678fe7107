//! The shape of a drop on a flat or round wall, and the angle at which it meets the wall.

#[cfg(test)]
mod tests;

use nalgebra::DVector;

use crate::vector::Vector;

use super::base::Base;
use super::centre_of_mass;
use super::circle::Circle;
use super::estimate::{Estimate, student_t};
use super::foot::{DEPTH, Foot, Shift};
use super::fragments::fragments;
use super::level::{depth, surface_points};
use super::surface::surface_particles;

/// How high above the wall the surface is used, in spacings.
const LOWEST: f64 = 1.5;
/// What the place of the surface may be off, in spacings: a 95 % interval.
const UNKNOWN: f64 = 0.2;
const UNKNOWN_AT_FOOT: f64 = 0.3;
/// And what that of the wall may be, from which the first particles are half a spacing away but for disorder.
const WALL_UNKNOWN: f64 = 0.1;
/// How thick the layer beside the wall is, in spacings.
const LAYER: f64 = 0.75;
/// How far from the contact line the local fit reaches: so many spacings, and up to these parts of
/// the height and of the wetted radius.
const LOCAL: f64 = 14.0;
const LOCAL_HEIGHT: f64 = 0.75;
const LOCAL_RADIUS: f64 = 0.75;
/// How far particles of one piece are apart at most, in spacings, and the part of all that the largest
/// piece of a drop holds at least.
const LINK: f64 = 1.6;
const ONE_DROP: f64 = 0.8;
/// How far, in spacings, a profile may meet the wall from the outermost particle beside it. Farther
/// off, a ragged edge has led the fit astray.
const ASTRAY: f64 = 8.0;

/// A drop on a wall as an experimenter sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DropOnWall {
    /// Contact angle, rad, through the liquid, of the circle (2D) or sphere (3D) fitted to
    /// the whole surface: right for drops that gravity does not flatten.
    pub circle: Estimate,
    /// Contact angle, rad, by the profile near the contact line alone: right for flattened
    /// drops too. NaN where its edge is too ragged to tell.
    pub tangent: Estimate,
    /// Radius of the line in which that circle or sphere meets the wall, m: steadier than
    /// `wetted_radius`, and blind to a foot that is not as the rest of the drop.
    pub circle_radius: f64,
    /// Radius of the contact line, m, by the profile near it, or a ragged one's outermost particle beside the
    /// wall; in 2D half of the straight way between its two points.
    pub wetted_radius: Estimate,
    /// Height of the drop above the wall, m: its largest distance from it.
    pub height: f64,
}

impl DropOnWall {
    /// Measures particles about `spacing` (m) apart that form one drop on `wall`; `None` where they
    /// show too little of a surface for a fit, or lie in pieces.
    ///
    /// The surface is a level set of the liquid's smoothed colour, whatever the order of the particles. Of drops at least eight spacings
    /// high, cut from lattices at any angle with and without
    /// disorder, `circle` finds 10 to 150 degrees within 1.2 degrees. `circle_radius` is good to
    /// 0.6 spacings, `wetted_radius` to one, at 10 degrees to two and a half. `tangent` has only the points within fourteen
    /// spacings of the contact line and those of the lower outer profile: in 2D it is within 6 degrees, 9 above 90 and 12
    /// above 120, in 3D within 3; averages over time do better. Intervals are those
    /// of the fits, with 0.2 spacings for where the surface lies and 0.1 for the wall. The
    /// height is good to half a spacing. On round walls of twenty spacings or more it is the same.
    pub fn measure<const D: usize>(
        positions: &[Vector<f64, D>],
        masses: &[f64],
        spacing: f64,
        wall: &Base<D>,
    ) -> Option<Self> {
        let pieces = fragments(positions, LINK * spacing);
        let largest = pieces.iter().filter(|&&piece| piece == 0).count();
        if (largest as f64) < ONE_DROP * positions.len() as f64 {
            return None;
        }
        let centre = centre_of_mass(positions, masses)?;
        let outer = surface_particles(positions, spacing, std::slice::from_ref(wall));
        let mut surface = surface_points(positions, masses, spacing, wall, &outer);
        surface.retain(|&x| wall.height(x) > LOWEST * spacing);
        let circle = Circle::fit(&surface)?;
        // A liquid that wets a vessel has a hollow surface: all of it lies outside of the circle.
        let within = |x: &&Vector<f64, D>| (**x - circle.centre).norm() < circle.radius;
        let bulges = 2 * positions.iter().filter(within).count() >= positions.len();
        let sign = if bulges { 1.0 } else { -1.0 };
        let deep = depth((D as f64 - 1.0) * sign / circle.radius, spacing);
        let radius = sign * circle.radius + deep;
        // With the centre's height H above a wall of curvature k, by the triangle of both centres and
        // the contact line: cos(angle) = -H / R + k (R^2 - H^2) / (2 R).
        let (rise, bend) = (wall.height(circle.centre), wall.curvature());
        let cosine = -rise / radius + 0.5 * bend * (radius - rise * rise / radius);
        let angle = cosine.clamp(-1.0, 1.0).acos();
        // -sin(angle) d angle = -(1 + k H) dH / R + (H / R + k (R^2 + H^2) / (2 R)) dR / R.
        let by_radius = rise / radius + 0.5 * bend * (radius + rise * rise / radius);
        let up = wall.normal(circle.centre);
        let sensitivity = DVector::from_fn(D + 1, |d, _| {
            if d < D {
                (1.0 + bend * rise) * up[d]
            } else {
                -sign * by_radius
            }
        });
        let variance = (sensitivity.transpose() * &circle.covariance * &sensitivity)[0];
        let lever = (radius * angle.sin()).abs();
        let unknown = (UNKNOWN * by_radius).hypot(WALL_UNKNOWN * (1.0 + bend * rise)) * spacing;
        let by_circle = Estimate {
            value: angle,
            half_width: (student_t(circle.freedom.max(4) as f64) * variance.sqrt()).hypot(unknown)
                / lever,
        };

        // Profiles in the half planes that hold the drop's axis: distance from it, and how far along it.
        let axis = wall.normal(centre);
        let origin = centre - axis * wall.height(centre);
        let in_profile = |x: Vector<f64, D>| {
            let along = (x - origin).dot(&axis);
            let arm = x - origin - axis * along;
            // In 2D on the one side or the other.
            let across = axis[0] * arm[1] - axis[1] * arm[0];
            (usize::from(D == 2 && across < 0.0), [arm.norm(), along])
        };
        // The way along the wall from the axis to the place below one of a profile.
        let way = |[x, y]: [f64; 2]| match bend {
            0.0 => x,
            bend => (bend * x).atan2(1.0 + bend * y) / bend,
        };
        let sides = if D == 2 { 2 } else { 1 };
        let mut profiles = vec![Vec::new(); sides];
        for &x in &surface {
            let (side, place) = in_profile(x);
            profiles[side].push((place, wall.height(x)));
        }
        let heights = positions.iter().map(|&x| wall.height(x));
        let lowest = heights.fold(f64::INFINITY, f64::min);
        let mut outermost = vec![[0.0; 2]; sides];
        for &x in positions {
            let (side, place) = in_profile(x);
            let beside = wall.height(x) < lowest + LAYER * spacing;
            if beside && way(place) > way(outermost[side]) {
                outermost[side] = place;
            }
        }
        let tops = surface.iter().map(|&x| wall.height(x));
        let height = tops.fold(0.0, f64::max) + deep;
        let shift = Shift {
            outwards: deep,
            unknown: UNKNOWN_AT_FOOT * spacing,
        };
        let foot = |(profile, outermost): (&Vec<([f64; 2], f64)>, [f64; 2])| {
            let near = |([x, y], above): &&([f64; 2], f64)| {
                let distance = (x - outermost[0]).hypot(y - outermost[1]);
                distance < LOCAL * spacing
                    || (*above < LOCAL_HEIGHT * height && distance < LOCAL_RADIUS * outermost[0])
            };
            let near: Vec<_> = (profile.iter().filter(near).map(|(place, _)| *place)).collect();
            let found = Foot::fit(&near, shift, bend);
            let found = found.filter(|f| (f.place.value - outermost[0]).abs() < ASTRAY * spacing);
            found.unwrap_or(Foot {
                angle: Estimate {
                    value: f64::NAN,
                    half_width: f64::NAN,
                },
                place: Estimate {
                    value: outermost[0] + DEPTH * spacing,
                    half_width: spacing,
                },
            })
        };
        let feet: Vec<Foot> = profiles.iter().zip(outermost).map(foot).collect();
        let mean = |of: fn(&Foot) -> Estimate| {
            let count = feet.len() as f64;
            let squares = feet.iter().map(|foot| of(foot).half_width.powi(2));
            Estimate {
                value: feet.iter().map(|foot| of(foot).value).sum::<f64>() / count,
                half_width: squares.sum::<f64>().sqrt() / count,
            }
        };
        Some(DropOnWall {
            circle: by_circle,
            circle_radius: lever / (1.0 + bend * rise).abs(),
            tangent: mean(|foot| foot.angle),
            wetted_radius: mean(|foot| foot.place),
            height,
        })
    }
}
