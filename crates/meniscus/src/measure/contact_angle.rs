//! The shape of a drop on a flat wall, and the angle at which it meets the wall.

use nalgebra::DVector;

use crate::vector::Vector;

use super::centre_of_mass;
use super::circle::Circle;
use super::estimate::{Estimate, student_t};
use super::foot::{DEPTH, DEPTH_UNKNOWN, Foot};
use super::surface::{Plane, surface_particles};

/// How thick the layer beside the wall is, in spacings.
const LAYER: f64 = 0.75;
/// How far from the contact line the local fit reaches: so many spacings, and up to these parts of
/// the height and of the wetted radius.
const LOCAL: f64 = 10.0;
const LOCAL_HEIGHT: f64 = 0.75;
const LOCAL_RADIUS: f64 = 0.75;
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
    /// Radius of the wetted area, m, by the same profile, or a ragged one's outermost particle beside the
    /// wall; half of its width in 2D.
    pub wetted_radius: Estimate,
    /// Height of the drop above the wall, m.
    pub height: f64,
}

impl DropOnWall {
    /// Measures particles about `spacing` (m) apart that form one drop on `wall`; `None` where they
    /// show too little of a surface for a fit.
    ///
    /// Of drops at least eight spacings high, cut from lattices at any angle with and without
    /// disorder, `circle` finds 10 to 150 degrees within 1.5 degrees, and `wetted_radius`
    /// is good to a spacing, or at 10 degrees to two. `tangent` has only the points within ten
    /// spacings of the contact line and those of the lower outer profile: in 2D it is within
    /// 8 degrees (16 above 90), in 3D within 5; averages over time do better. Intervals are those
    /// of the fits, with 0.2 spacings for where the surface lies outside the particles. The
    /// height is good to half a spacing.
    pub fn measure<const D: usize>(
        positions: &[Vector<f64, D>],
        masses: &[f64],
        spacing: f64,
        wall: &Plane<D>,
    ) -> Option<Self> {
        let centre = centre_of_mass(positions, masses)?;
        let surface: Vec<_> = surface_particles(positions, spacing, std::slice::from_ref(wall))
            .into_iter()
            .map(|i| positions[i])
            .filter(|&x| wall.height(x) > spacing)
            .collect();
        let circle = Circle::fit(&surface)?;
        let radius = circle.radius + DEPTH * spacing;
        let rise = wall.height(circle.centre);
        let angle = (-rise / radius).clamp(-1.0, 1.0).acos();
        // -sin(angle) d angle = -d rise / R + rise dR / R^2.
        let sensitivity =
            DVector::from_fn(
                D + 1,
                |d, _| {
                    if d < D { wall.normal()[d] } else { angle.cos() }
                },
            );
        let variance = (sensitivity.transpose() * &circle.covariance * &sensitivity)[0];
        let lever = radius * angle.sin();
        let depth = DEPTH_UNKNOWN * spacing * angle.cos();
        let by_circle = Estimate {
            value: angle,
            half_width: (student_t(circle.freedom.max(4) as f64) * variance.sqrt()).hypot(depth)
                / lever,
        };

        // Profiles in the half planes that hold the drop's axis: distance from it, height.
        let axis = centre - wall.normal() * wall.height(centre);
        let in_profile = |x: Vector<f64, D>| {
            let height = wall.height(x);
            let arm = x - axis - wall.normal() * height;
            // In 2D on the one side or the other.
            let across = wall.normal()[0] * arm[1] - wall.normal()[1] * arm[0];
            (usize::from(D == 2 && across < 0.0), [arm.norm(), height])
        };
        let sides = if D == 2 { 2 } else { 1 };
        let mut profiles = vec![Vec::new(); sides];
        for &x in &surface {
            let (side, place) = in_profile(x);
            profiles[side].push(place);
        }
        let heights = positions.iter().map(|&x| wall.height(x));
        let lowest = heights.fold(f64::INFINITY, f64::min);
        let mut outermost = vec![[0.0; 2]; sides];
        for &x in positions {
            let (side, place) = in_profile(x);
            if place[1] < lowest + LAYER * spacing && place[0] > outermost[side][0] {
                outermost[side] = place;
            }
        }
        let tops = surface.iter().map(|&x| wall.height(x));
        let height = tops.fold(0.0, f64::max) + DEPTH * spacing;
        let foot = |(profile, outermost): (&Vec<[f64; 2]>, [f64; 2])| {
            let near = |[x, y]: &&[f64; 2]| {
                let distance = (x - outermost[0]).hypot(y - outermost[1]);
                distance < LOCAL * spacing
                    || (*y < LOCAL_HEIGHT * height && distance < LOCAL_RADIUS * outermost[0])
            };
            let near: Vec<_> = profile.iter().filter(near).copied().collect();
            let found = Foot::fit(&near, spacing)?;
            if (found.place.value - outermost[0]).abs() < ASTRAY * spacing {
                return Some(found);
            }
            Some(Foot {
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
        let feet: Vec<Foot> = (profiles.iter().zip(outermost))
            .map(foot)
            .collect::<Option<_>>()?;
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
            tangent: mean(|foot| foot.angle),
            wetted_radius: mean(|foot| foot.place),
            height,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::samples::cut;
    use crate::shape::Rotation;
    use crate::theory::Cap;

    /// A cap of a circle or sphere on a wall that is turned by `tilt`, from a lattice.
    fn drop<const D: usize>(
        degrees: f64,
        volume: f64,
        (turn, jitter): (f64, f64),
        tilt: f64,
    ) -> (Cap, Option<DropOnWall>) {
        let cap = Cap::of_volume(volume, degrees.to_radians(), D);
        let (top, radius) = (cap.height, cap.curvature_radius);
        let reach = 2.0
            + top.max(if degrees < 90.0 {
                cap.base_radius
            } else {
                radius
            });
        let mut x = cut(reach.max(1.2 * top), turn, jitter, |x: &Vector<f64, D>| {
            let mut arm = *x;
            arm[1] += radius - top;
            x[1] > 0.0 && arm.norm() < radius
        });
        let tilted = Rotation::about(Vector([0.3, 0.1, 1.0]), tilt);
        let mut up = Vector::ZERO;
        up[1] = 3.0;
        let point = Vector([40.0; D]);
        x.iter_mut().for_each(|x| *x = point + tilted.apply(x));
        let wall = Plane::new(point, tilted.apply(&up)).unwrap();
        (
            cap,
            DropOnWall::measure(&x, &vec![1.0; x.len()], 1.0, &wall),
        )
    }

    /// Angle of the lattice, and its disorder.
    const LATTICES: [(f64, f64); 5] = [(0.0, 0.0), (0.4, 0.0), (0.0, 0.2), (1.2, 0.2), (0.2, 0.1)];

    fn check<const D: usize>(degrees: f64, volume: f64, local: f64) {
        for (lattice, tilt) in LATTICES.into_iter().zip([0.0, 0.5, 2.0, 4.0, 5.5]) {
            let (cap, found) = drop::<D>(degrees, volume, lattice, tilt);
            let found = found.unwrap();
            let shown = format!("{D}D, {degrees}, {lattice:?}: {found:?}");
            let (circle, tangent) = (found.circle, found.tangent);
            let off = circle.value.to_degrees() - degrees;
            assert!(off.abs() < 1.5, "{shown}");
            assert!(off.abs() < 2.0 * circle.half_width.to_degrees(), "{shown}");
            assert!(
                (tangent.value.to_degrees() - degrees).abs() < local,
                "{shown}"
            );
            let wide = (found.wetted_radius.value - cap.base_radius).abs();
            assert!(
                wide < 1.0 || wide < found.wetted_radius.half_width,
                "{shown}"
            );
            assert!((found.height - cap.height).abs() < 0.5, "{shown}");
        }
    }

    #[test]
    fn caps_of_circles_have_the_angle_that_they_were_cut_with() {
        check::<2>(10.0, 1200.0, 2.0);
        for (degrees, local) in [
            (30.0, 6.0),
            (60.0, 7.0),
            (90.0, 8.0),
            (120.0, 16.0),
            (150.0, 16.0),
        ] {
            check::<2>(degrees, 600.0, local);
        }
    }

    #[test]
    fn caps_of_spheres_have_the_angle_that_they_were_cut_with() {
        for degrees in [30.0, 60.0, 90.0, 120.0, 150.0] {
            check::<3>(degrees, 8000.0, 5.0);
        }
    }

    #[test]
    fn a_flattened_drop_meets_the_wall_as_its_foot_does() {
        // Half an ellipse: 90 degrees there, and no circle. It bends faster at its foot than a
        // parabola, so that some degrees are lost.
        let x = cut(42.0, 0.4, 0.1, |x: &Vector<f64, 2>| {
            x[1] > 0.0 && (x[0] / 35.0).powi(2) + (x[1] / 22.0).powi(2) < 1.0
        });
        let wall = Plane::new(Vector::ZERO, Vector([0.0, 1.0])).unwrap();
        let found = DropOnWall::measure(&x, &vec![1.0; x.len()], 1.0, &wall).unwrap();
        assert!(found.circle.value.to_degrees() < 70.0, "{found:?}");
        assert!(
            (found.tangent.value.to_degrees() - 90.0).abs() < 12.0,
            "{found:?}"
        );
        assert!((found.wetted_radius.value - 35.0).abs() < 1.0, "{found:?}");
    }

    #[test]
    fn a_ragged_edge_leads_no_radius_astray() {
        // Half a disc, and a row of single particles beside its foot.
        let mut x = cut(12.0, 0.0, 0.0, |x: &Vector<f64, 2>| {
            x[1] > 0.0 && x.norm() < 10.0
        });
        for k in 0..6 {
            let away = 10.5 + 1.1 * f64::from(k);
            x.push(Vector([away, 0.5 + 1.2 * f64::from(k % 2)]));
            x.push(Vector([-away, 0.5 + 1.2 * f64::from(k % 3)]));
        }
        let wall = Plane::new(Vector::ZERO, Vector([0.0, 1.0])).unwrap();
        let found = DropOnWall::measure(&x, &vec![1.0; x.len()], 1.0, &wall).unwrap();
        assert!(
            (9.0..18.0).contains(&found.wetted_radius.value),
            "{found:?}"
        );
    }

    #[test]
    fn what_is_no_drop_has_no_angle() {
        let wall = Plane::new(Vector::ZERO, Vector([0.0, 1.0])).unwrap();
        let few = [Vector([0.0, 0.5]), Vector([1.0, 0.5])];
        assert_eq!(DropOnWall::measure(&few, &[1.0; 2], 1.0, &wall), None);
        assert_eq!(Plane::new(Vector([0.0, 1.0]), Vector::ZERO), None);
    }
}
