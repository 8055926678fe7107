//! Where wall particles lie.

use std::f64::consts::PI;

use meniscus::Vector;
use meniscus::physics::wall::layout::{Layers, Side};
use meniscus::shape::{FillError, Revolved};

/// Closest two of a set of points.
fn closest<const D: usize>(points: &[Vector<f64, D>]) -> f64 {
    let mut least = f64::INFINITY;
    for (i, a) in points.iter().enumerate() {
        for b in &points[..i] {
            least = least.min((*a - *b).norm());
        }
    }
    least
}

#[test]
fn a_tank_has_its_corners_and_loses_its_open_faces() {
    let layers = Layers::new(1.0, 3.0, 40_000);
    let (low, high) = (Vector([0.0, 0.0]), Vector([10.0, 8.0]));
    let closed = layers.tank(low, high, &[]).unwrap();
    assert_eq!(closed.len(), 16 * 14 - 10 * 8);
    let open = layers.tank(low, high, &[(1, true)]).unwrap();
    assert_eq!(open.len(), 16 * 11 - 10 * 8);
    assert!(open.iter().all(|x| x[1] < 8.0));
    let cube = layers
        .tank(Vector([0.0; 3]), Vector([4.0; 3]), &[(2, true)])
        .unwrap();
    assert_eq!(cube.len(), 10 * 10 * 7 - 64);
    // The wall of 6.1 of Qiang, Chen and Gao: three layers around 51 x 36 x 36.
    let paper = layers
        .tank(Vector([0.0; 3]), Vector([51.0, 36.0, 36.0]), &[])
        .unwrap();
    assert_eq!(paper.len(), 57 * 42 * 42 - 51 * 36 * 36);
    // No whole number of spacings: still half a spacing behind either face.
    let odd = layers.tank(low, Vector([10.3, 8.0]), &[]).unwrap();
    for face in [-0.5, 10.8] {
        assert!(odd.iter().any(|x| (x[0] - face).abs() < 1e-12));
    }
}

#[test]
fn the_first_layer_is_half_a_spacing_behind_any_surface_and_none_is_crowded() {
    let layers = Layers::new(0.1, 0.4, 100_000);
    let first = |distances: Vec<f64>| {
        let least = distances.iter().copied().fold(f64::INFINITY, f64::min);
        let most = distances.iter().copied().fold(0.0, f64::max);
        assert!(
            (least - 0.05).abs() < 1e-9 && most < 0.4,
            "{least} to {most}"
        );
    };
    let centre = Vector([0.3, -0.2]);
    for side in [Side::Inside, Side::Outside] {
        let disc = layers.ball(centre, 1.03, side).unwrap();
        first(
            disc.iter()
                .map(|x| ((*x - centre).norm() - 1.03).abs())
                .collect(),
        );
        assert!(closest(&disc) > 0.08);
        let ball = layers.ball(Vector([0.0; 3]), 0.6, side).unwrap();
        first(ball.iter().map(|x| (x.norm() - 0.6).abs()).collect());
        // A slanted triangle and the notched square.
        for corners in [
            vec![Vector([0.0, 0.0]), Vector([2.0, 0.3]), Vector([0.7, 1.9])],
            [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [1.0, 1.0], [0.0, 2.0]]
                .map(Vector)
                .to_vec(),
        ] {
            let mut turned = corners.clone();
            turned.reverse();
            let wall = layers.polygon(&corners, side).unwrap();
            assert_eq!(wall.len(), layers.polygon(&turned, side).unwrap().len());
            assert!(closest(&wall) > 0.04, "{}", closest(&wall));
        }
    }
    let normal = Vector([3.0, 4.0]);
    let plane = layers.plane(centre, normal, 1.0).unwrap();
    assert_eq!(plane.len(), 4 * 10);
    first(
        plane
            .iter()
            .map(|x| -(*x - centre).dot(&normal) / 5.0)
            .collect(),
    );
    assert!((closest(&plane) - 0.1).abs() < 1e-9);
    let floor = layers
        .plane(Vector([0.0; 3]), Vector([0.0, 0.0, 2.0]), 1.0)
        .unwrap();
    assert_eq!(floor.len(), 4 * 100);
    first(floor.iter().map(|x| -x[2]).collect());
}

#[test]
fn what_is_revolved_has_the_volume_of_its_profile_and_lies_behind_it() {
    let layers = Layers::new(0.1, 0.4, 100_000);
    let (point, axis) = (Vector([1.0, 2.0, 3.0]), Vector([1.0, -2.0, 2.0]));
    let of = |corners: &[[f64; 2]], side| {
        let corners = corners.iter().map(|corner| Vector(*corner)).collect();
        let shape = Revolved {
            corners,
            point,
            axis,
        };
        let wall = layers.revolved(&shape, side).unwrap();
        let place = |x: &Vector<f64, 3>| {
            let arm = *x - point;
            let along = arm.dot(&axis) / 3.0;
            (along, (arm - axis * (along / 3.0)).norm())
        };
        // Where the rings of a disc's face and of its edge meet they are two thirds of a spacing apart.
        assert!(closest(&wall) > 0.06, "{}", closest(&wall));
        wall.iter().map(place).collect::<Vec<_>>()
    };
    // Whole numbers of particles in each ring: some per cent of the volume of small ones.
    let near = |wall: &[(f64, f64)], volume: f64| {
        let found = wall.len() as f64 * 1e-3;
        assert!((found / volume - 1.0).abs() < 0.02, "{found} for {volume}");
    };
    let tube = of(
        &[[0.0, 0.8], [2.0, 0.8], [2.0, 1.2], [0.0, 1.2]],
        Side::Inside,
    );
    near(&tube, PI * (1.44 - 0.64) * 2.0);
    let inner = tube.iter().map(|at| at.1).fold(f64::INFINITY, f64::min);
    assert!((inner - 0.85).abs() < 1e-9, "{inner}");
    // A disc has no surface on its axis, and no hole.
    let disc = of(
        &[[0.0, 0.0], [0.0, 0.8], [0.4, 0.8], [0.4, 0.0]],
        Side::Inside,
    );
    near(&disc, PI * 0.64 * 0.4);
    assert!(disc.iter().any(|at| at.1 < 0.06) && disc.iter().all(|at| at.1 < 0.76));
    assert!(disc.iter().all(|at| at.0 > 0.04 && at.0 < 0.36));
    // A round box with lids, from inside: 0.4 of wall all around.
    let vessel = of(
        &[[0.0, 0.0], [0.0, 0.8], [2.0, 0.8], [2.0, 0.0]],
        Side::Outside,
    );
    near(&vessel, PI * (1.44 * 2.8 - 0.64 * 2.0));
    assert!(
        vessel
            .iter()
            .all(|at| at.0 < 0.0 || at.0 > 2.0 || at.1 > 0.8)
    );
}

#[test]
fn walls_of_nothing_or_without_end_are_refused() {
    let layers = Layers::new(0.1, 0.4, 1000);
    let (a, b) = (Vector([0.0, 0.0]), Vector([1.0, 1.0]));
    assert_eq!(layers.tank(b, a, &[]), Err(FillError::Empty));
    assert_eq!(layers.plane(a, a, 1.0), Err(FillError::Empty));
    assert_eq!(layers.polygon(&[a, b], Side::Inside), Err(FillError::Empty));
    assert!(matches!(
        layers.ball(a, f64::INFINITY, Side::Inside),
        Err(FillError::Unbounded)
    ));
    assert!(matches!(
        layers.ball(a, 1e9, Side::Inside),
        Err(FillError::TooMany { .. })
    ));
}
