use super::*;

#[test]
fn points_at_no_place_have_no_mesh() {
    for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300] {
        let points = [Vector([0.0, 1.0]), Vector([x, 0.0])];
        assert!(Mesh::around(points.into_iter(), 1.0, 0.0, 5).is_none());
    }
}

/// A few points spread what they have, and feel the gradient of the same splines.
#[test]
fn splines_keep_what_is_spread_and_reproduce_linear_fields() {
    let mut points = Layered::<3>::default();
    let place = |k: usize| {
        Vector([0.7, 1.3, 2.1].map(|c: f64| (c * (k as f64 + 0.4)).fract() * 40.0 - 7.0))
    };
    for k in 0..50 {
        points.push(place(k), [1.0, 2.0]);
    }
    let mesh = Mesh::around((0..50).map(place), 1.5, 0.0, 12).unwrap();
    let mut fields = [vec![0.0; mesh.len()], vec![0.0; mesh.len()]];
    let [a, b] = &mut fields;
    mesh.spread(&mut points, [a, b]);
    let mut spare = Vec::new();
    mesh.smooth(a, &mut spare, 5);
    assert!((a.iter().sum::<f64>() - 50.0).abs() < 1e-12);
    assert!((b.iter().sum::<f64>() - 100.0).abs() < 1e-12);

    let slope = Vector([0.3, -1.0, 2.0]);
    let linear: Vec<f64> = (0..mesh.len())
        .map(|node| {
            let mut rest = node;
            (0..3)
                .map(|d| {
                    let index = rest / mesh.stride[d];
                    rest %= mesh.stride[d];
                    slope[d] * (index as i64 + mesh.low[d]) as f64 * 1.5
                })
                .sum()
        })
        .collect();
    let mut found = Vec::new();
    mesh.feel(&linear, &[place(3), place(8)], &mut found);
    for ((value, gradient), k) in found.into_iter().zip([3, 8]) {
        assert!((value - slope.dot(&place(k))).abs() < 1e-10, "{value}");
        assert!((gradient - slope).norm() < 1e-11, "{gradient:?}");
    }
}

/// Whatever number of layers is left for the last task.
#[test]
fn smoothing_keeps_what_is_spread_on_meshes_of_any_size() {
    for margin in 6..=6 + LAYERS_PER_TASK as i64 {
        let x = Vector([0.3, 0.6]);
        let mesh = Mesh::around([x].into_iter(), 1.0, 0.0, margin).unwrap();
        let (mut field, mut spare) = (vec![0.0; mesh.len()], Vec::new());
        mesh.spread_at(&mut field, &x, 1.0);
        mesh.smooth(&mut field, &mut spare, 3);
        assert!((field.iter().sum::<f64>() - 1.0).abs() < 1e-14);
        let (value, _) = mesh.feel_at(&field, &x);
        assert!((0.05..0.2).contains(&value), "{value}");
    }
}

/// What is the same where it is known is the same everywhere, and no field leaves its bounds; between two known lines a field is linear, and what is known
/// on a circle as cos(2 phi) goes inwards with r^2.
#[test]
fn fields_are_harmonic_where_they_are_not_known() {
    let points = [Vector([0.0, 0.0]), Vector([20.0, 33.0])];
    let mesh = Mesh::around(points.into_iter(), 1.0, 0.0, 3).unwrap();
    let mut harmonic = Harmonic::default();
    let mut extend = |known: &dyn Fn(usize) -> Option<f64>| {
        let mut values: Vec<f64> = (0..mesh.len()).map(|i| known(i).unwrap_or(9.0)).collect();
        let weight: Vec<f64> = (0..mesh.len())
            .map(|i| if known(i).is_some() { 1.0 } else { 0.0 })
            .collect();
        mesh.make_harmonic(&mut values, &weight, 0.001, 8, &mut harmonic);
        values
    };
    let same = extend(&|i| (i < mesh.len() / 3 && i.is_multiple_of(7)).then_some(3.0));
    assert!(same.iter().all(|value| (value - 3.0).abs() < 1e-12));
    let varied = extend(&|i| (i < mesh.len() / 3 && i.is_multiple_of(7)).then_some((i % 5) as f64));
    assert!(varied.iter().all(|value| (0.0..=4.0).contains(value)));
    let linear = extend(&|i| {
        let y = mesh.place(i)[1];
        (y == 2.0 || y == 30.0).then_some(y)
    });
    let centre = Vector([10.0, 16.0]);
    let saddle = extend(&|i| {
        let x = mesh.place(i) - centre;
        ((x.norm() - 9.0).abs() < 0.8).then(|| (x[0] * x[0] - x[1] * x[1]) / x.norm_squared())
    });
    for i in 0..mesh.len() {
        let x = mesh.place(i);
        if x[1] > 2.0 && x[1] < 30.0 {
            assert!((linear[i] - x[1]).abs() < 0.1, "{} {}", linear[i], x[1]);
        }
        let x = x - centre;
        if x.norm() < 8.0 {
            let exact = (x[0] * x[0] - x[1] * x[1]) / 81.0;
            assert!((saddle[i] - exact).abs() < 0.1, "{} {exact}", saddle[i]);
        }
    }
}

/// What is known on two circles, little on one of them, and of opposite sign: the first cycle takes the error to a twentieth or less, the others to a half.
#[test]
fn cycles_take_the_error_of_harmonic_fields_away() {
    let points = [Vector([0.0, 0.0]), Vector([70.0, 33.0])];
    let mesh = Mesh::around(points.into_iter(), 1.0, 0.0, 7).unwrap();
    let on = |i: usize, x: f64| ((mesh.place(i) - Vector([x, 16.0])).norm() - 9.0).abs() < 0.8;
    let weight: Vec<f64> = (0..mesh.len())
        .map(|i| match (on(i, 15.0), on(i, 50.0)) {
            (true, _) => 1.0,
            (_, true) => 0.002,
            _ => 0.0,
        })
        .collect();
    let mut harmonic = Harmonic::default();
    let mut after = |cycles| {
        let mut values: Vec<f64> = (0..mesh.len())
            .map(|i| if on(i, 15.0) { 1.0 } else { -1.0 })
            .collect();
        mesh.make_harmonic(&mut values, &weight, 0.025, cycles, &mut harmonic);
        values
    };
    let exact = after(40);
    let mut error = |cycles| {
        let differ = after(cycles).into_iter().zip(&exact);
        differ
            .map(|(value, exact)| (value - exact).abs())
            .fold(0.0, f64::max)
    };
    let errors: Vec<f64> = (0..5).map(&mut error).collect();
    assert!(
        errors[0] > 0.5 && errors[1] < 0.05 * errors[0],
        "{errors:?}"
    );
    assert!(
        errors.windows(2).all(|two| two[1] < 0.5 * two[0]),
        "{errors:?}"
    );
}
