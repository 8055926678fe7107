//! Caps and lenses cut from lattices.

use super::*;
use crate::measure::base::Plane;
use crate::measure::samples::cut;
use crate::physics::wall::layout::Side;
use crate::shape::Rotation;
use crate::theory::{Cap, CapOnBall};

fn floor() -> Base<2> {
    Base::Plane(Plane::new(Vector::ZERO, Vector([0.0, 1.0])).unwrap())
}

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
    let wall = Base::Plane(Plane::new(point, tilted.apply(&up)).unwrap());
    (
        cap,
        DropOnWall::measure(&x, &vec![1.0; x.len()], 1.0, &wall),
    )
}

/// Angle of the lattice, and its disorder.
const LATTICES: [(f64, f64); 5] = [(0.0, 0.0), (0.4, 0.0), (0.0, 0.2), (1.2, 0.2), (0.2, 0.1)];

/// An angle in degrees, a radius and a height are found: the angle by the tangent within `local` degrees.
fn assert_right(
    found: &DropOnWall,
    degrees: f64,
    [radius, height]: [f64; 2],
    local: f64,
    shown: &str,
) {
    let (circle, tangent) = (found.circle, found.tangent);
    let off = circle.value.to_degrees() - degrees;
    assert!(off.abs() < 1.2, "{shown}");
    assert!(off.abs() < 2.0 * circle.half_width.to_degrees(), "{shown}");
    assert!(
        (tangent.value.to_degrees() - degrees).abs() < local,
        "{shown}"
    );
    let at_circle = (found.circle_radius - radius).abs();
    assert!(at_circle < 0.6, "{at_circle}: {shown}");
    let wide = (found.wetted_radius.value - radius).abs();
    assert!(
        wide < 1.0 || wide < found.wetted_radius.half_width,
        "{shown}"
    );
    assert!((found.height - height).abs() < 0.5, "{shown}");
}

fn check<const D: usize>(degrees: f64, volume: f64, local: f64) {
    for (lattice, tilt) in LATTICES.into_iter().zip([0.0, 0.5, 2.0, 4.0, 5.5]) {
        let (cap, found) = drop::<D>(degrees, volume, lattice, tilt);
        let found = found.unwrap();
        let shown = format!("{D}D, {degrees}, {lattice:?}: {found:?}");
        assert_right(
            &found,
            degrees,
            [cap.base_radius, cap.height],
            local,
            &shown,
        );
    }
}

#[test]
fn caps_of_circles_have_the_angle_that_they_were_cut_with() {
    check::<2>(10.0, 1200.0, 2.0);
    for (degrees, local) in [
        (30.0, 6.0),
        (60.0, 6.0),
        (90.0, 6.0),
        (120.0, 9.0),
        (150.0, 12.0),
    ] {
        check::<2>(degrees, 600.0, local);
    }
}

#[test]
fn caps_of_spheres_have_the_angle_that_they_were_cut_with() {
    for degrees in [30.0, 60.0, 90.0, 120.0, 150.0] {
        check::<3>(degrees, 8000.0, 3.0);
    }
}

/// A lens between a ball, or a round vessel, and the sphere of a drop on it, along a direction.
fn lens<const D: usize>(
    degrees: f64,
    volume: f64,
    wall_radius: f64,
    (turn, jitter): (f64, f64),
    way: Vector<f64, D>,
) -> (CapOnBall, Option<DropOnWall>) {
    let cap = CapOnBall::of_volume(volume, degrees.to_radians(), wall_radius, D);
    let side = match wall_radius > 0.0 {
        true => Side::Inside,
        false => Side::Outside,
    };
    let wall = Base::Ball {
        centre: Vector::ZERO,
        radius: wall_radius.abs(),
        side,
    };
    let way = way * (1.0 / way.norm());
    // On the axis, the wall's surface is at its signed radius; height and radius go on from there.
    let foot = wall_radius.abs() * if wall_radius > 0.0 { 1.0 } else { -1.0 };
    let drop = way * (foot + cap.height - cap.curvature_radius);
    let inside = |x: &Vector<f64, D>| {
        let within = (*x - drop).norm() < cap.curvature_radius.abs();
        wall.height(*x) > 0.0 && within == (cap.curvature_radius > 0.0)
    };
    let x = cut(
        wall_radius.abs() + cap.height.max(0.0) + 1.0,
        turn,
        jitter,
        inside,
    );
    (
        cap,
        DropOnWall::measure(&x, &vec![1.0; x.len()], 1.0, &wall),
    )
}

fn check_lens<const D: usize>(degrees: f64, volume: f64, wall_radius: f64, local: f64) {
    let ways = [[0.0, 1.0, 0.0], [0.8, 0.6, 0.2], [-0.3, 0.4, -0.9]];
    for (lattice, way) in LATTICES.into_iter().zip(ways.into_iter().cycle()) {
        let way = Vector::from_3d(way);
        let (cap, found) = lens::<D>(degrees, volume, wall_radius, lattice, way);
        let found = found.unwrap();
        let shown = format!("{D}D, {degrees} on {wall_radius}, {lattice:?}: {cap:?}, {found:?}");
        assert_right(
            &found,
            degrees,
            [cap.base_radius, cap.height],
            local,
            &shown,
        );
    }
}

#[test]
fn lenses_on_round_walls_have_the_angle_that_they_were_cut_with() {
    for (degrees, local) in [
        (30.0, 6.0),
        (60.0, 6.0),
        (90.0, 6.0),
        (120.0, 9.0),
        (150.0, 12.0),
    ] {
        check_lens::<2>(degrees, 600.0, 30.0, local);
        check_lens::<2>(degrees, 600.0, -40.0, local);
    }
    for degrees in [60.0, 120.0] {
        check_lens::<3>(degrees, 8000.0, 20.0, 3.0);
        check_lens::<3>(degrees, 8000.0, -30.0, 3.0);
    }
}

#[test]
fn a_flattened_drop_meets_the_wall_as_its_foot_does() {
    // Half an ellipse: 90 degrees there, and no circle. It bends faster at its foot than
    // over the fourteen spacings of the fit, so that some degrees are lost.
    let x = cut(42.0, 0.4, 0.1, |x: &Vector<f64, 2>| {
        x[1] > 0.0 && (x[0] / 35.0).powi(2) + (x[1] / 22.0).powi(2) < 1.0
    });
    let wall = floor();
    let found = DropOnWall::measure(&x, &vec![1.0; x.len()], 1.0, &wall).unwrap();
    assert!(found.circle.value.to_degrees() < 70.0, "{found:?}");
    assert!(
        (found.tangent.value.to_degrees() - 90.0).abs() < 8.0,
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
    let wall = floor();
    let found = DropOnWall::measure(&x, &vec![1.0; x.len()], 1.0, &wall).unwrap();
    assert!(
        (9.0..18.0).contains(&found.wetted_radius.value),
        "{found:?}"
    );
}

#[test]
fn what_has_broken_has_no_angle() {
    let two = |apart: f64| {
        let mut x = cut(12.0, 0.0, 0.1, |x: &Vector<f64, 2>| {
            x[1] > 0.0 && x.norm() < 10.0
        });
        let half: Vec<_> = x.iter().map(|x| *x + Vector([apart, 0.0])).collect();
        x.extend(half);
        DropOnWall::measure(&x, &vec![1.0; x.len()], 1.0, &floor())
    };
    assert_eq!(two(40.0), None);
    assert!(two(19.0).is_some());
}

#[test]
fn what_is_no_drop_has_no_angle() {
    let wall = floor();
    let few = [Vector([0.0, 0.5]), Vector([1.0, 0.5])];
    assert_eq!(DropOnWall::measure(&few, &[1.0; 2], 1.0, &wall), None);
}
