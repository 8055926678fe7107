//! Where wall particles lie.

use meniscus::Vector;
use meniscus::physics::wall::layout::{Layers, Side};
use meniscus::shape::FillError;

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
