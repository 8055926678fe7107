//! What the forces on a drop add up to, and what they do not depend on.

use std::f64::consts::PI;

use meniscus::rates::{Dimension, Space};
use meniscus::scheme::TimeStep;
use meniscus::shape::{Pattern, Rotation, Shape};
use meniscus::theory::equivalent_radius;
use meniscus::{Setup, Simulation, Vector};

use crate::{ball, liquid, volume};

/// The sum of all forces, in units of sigma R^(D-2).
fn net_force<const D: usize>(setup: Setup<D>) -> f64
where
    Space: Dimension<D>,
{
    let radius = equivalent_radius(volume(&setup), D);
    let simulation = Simulation::new(setup).expect("a sound setup");
    let p = simulation.particles();
    let mut sum = Vector::<f64, D>::ZERO;
    for i in 0..p.len() {
        sum += p.acceleration[i] * p.mass[i];
    }
    sum.norm() / radius.powi(D as i32 - 2)
}

#[test]
fn the_forces_on_a_symmetric_drop_cancel() {
    for pattern in [Pattern::Cubic, Pattern::ClosePacked] {
        // Rounding, of forces that add up to 2 pi and 8 pi in magnitude.
        let net = net_force(ball::<2>(13.376, pattern, 0.0));
        assert!(net < 1e-12, "2D, {pattern:?}: {net:e}");
        let net = net_force(ball::<3>(7.0, Pattern::Cubic, 0.0));
        assert!(net < 1e-12, "3D, {pattern:?}: {net:e}");
    }
}

/// Without symmetry they need not: the model is no sum of pairs that push
/// each other. With particles displaced by up to a tenth of a spacing a net
/// force of a part of sigma is left, which the forces' magnitudes exceed tenfold.
#[test]
fn the_forces_on_a_disordered_drop_nearly_cancel() {
    for radius in [8.0, 10.0, 12.0, 13.376] {
        let net = net_force(ball::<2>(radius, Pattern::ClosePacked, 0.1));
        assert!(net < 1.0, "2D, R = {radius} dx: {net}");
        assert!(
            net > 1e-3,
            "2D, R = {radius} dx: {net}: did the model change?"
        );
    }
    let net = net_force(ball::<3>(7.0, Pattern::ClosePacked, 0.1));
    assert!(net < 1.0, "3D: {net}");
}

/// The pressure that the forces hold in balance inside a round drop, over
/// (D - 1) sigma / R: what they add up to on the way in through the surface.
fn inner_pressure<const D: usize>(setup: Setup<D>) -> f64
where
    Space: Dimension<D>,
{
    let radius = equivalent_radius(volume(&setup), D);
    let simulation = Simulation::new(setup).expect("a sound setup");
    let p = simulation.particles();
    let pressure: f64 = (0..p.len())
        .filter(|&i| p.position[i].norm() > 0.0)
        .map(|i| {
            let r = p.position[i].norm();
            let shell = if D == 2 {
                2.0 * PI * r
            } else {
                4.0 * PI * r * r
            };
            -p.acceleration[i].dot(&p.position[i]) / r * p.mass[i] / shell
        })
        .sum();
    pressure * radius / (D as f64 - 1.0)
}

#[test]
fn the_forces_ask_for_the_pressure_of_the_paper() {
    // Table 1, N = 649, 1165 and 2259. The lattice has not settled yet: 0.025.
    for (radius, published) in [(13.376, 1.124), (18.001, 1.066), (24.954, 1.025)] {
        let found = inner_pressure(ball::<2>(radius, Pattern::ClosePacked, 0.0));
        assert!(
            (found - published).abs() < 0.025,
            "R = {radius} dx: {found}, {published}"
        );
    }
}

#[test]
fn the_forces_on_a_ball_ask_for_twice_the_pressure_of_a_rod() {
    // Over 2 sigma / R; as in two dimensions the excess falls with h / R, and
    // is somewhat more for a layer that narrows in two directions.
    let (coarse, fine) = (
        inner_pressure(ball::<3>(7.0, Pattern::Cubic, 0.0)),
        inner_pressure(ball::<3>(14.0, Pattern::Cubic, 0.0)),
    );
    assert!((1.05..1.2).contains(&fine), "{fine}");
    assert!(fine - 1.0 < 0.5 * (coarse - 1.0), "{coarse}, {fine}");
}

/// An ellipse or ellipsoid of semi-axes 8 and 6 spacings that moves for 200 steps.
fn march<const D: usize>(spoil: impl Fn(&mut Setup<D>)) -> Vec<Vector<f64, D>>
where
    Space: Dimension<D>,
{
    let mut semi_axes = [6.0; D];
    semi_axes[0] = 8.0;
    let shape = Shape::Ellipsoid {
        centre: Vector::ZERO,
        semi_axes: Vector(semi_axes),
        rotation: Rotation::none(),
    };
    let mut setup = liquid(&shape, Pattern::Cubic, 0.05);
    setup.scheme.time_step = TimeStep::Fixed(0.05);
    spoil(&mut setup);
    let mut simulation = Simulation::new(setup).expect("a sound setup");
    for _ in 0..200 {
        simulation.step().expect("the flow is calm");
    }
    let p = simulation.particles();
    let mut positions = vec![Vector::ZERO; p.len()];
    for i in 0..p.len() {
        positions[p.id[i] as usize] = p.position[i];
    }
    positions
}

fn farthest<const D: usize>(a: &[Vector<f64, D>], b: &[Vector<f64, D>]) -> f64 {
    a.iter()
        .zip(b)
        .fold(0.0, |most: f64, (a, b)| most.max((*a - *b).norm()))
}

/// Rounding of places of 8, in 200 steps of a disordered flow that
/// makes about a thousand of it, in spacings.
const ROUNDING: f64 = 1e-10;

#[test]
fn lengths_times_and_masses_can_be_measured_in_any_unit() {
    // Lengths x 10, times x 3, densities x 7.
    let (length, time, density) = (10.0, 3.0, 7.0);
    let same = march::<2>(|_| ());
    let mut scaled = march::<2>(|setup| {
        for particle in &mut setup.particles {
            particle.position = particle.position * length;
            particle.mass *= density * length.powi(2);
        }
        setup.spacing *= length;
        setup.scheme.smoothing_length *= length;
        setup.scheme.time_step = TimeStep::Fixed(0.05 * time);
        let fluid = &mut setup.fluids[0];
        fluid.density *= density;
        fluid.sound_speed *= length / time;
        fluid.surface_tension *= density * length.powi(3) / time.powi(2);
    });
    for position in &mut scaled {
        *position = *position * (1.0 / length);
    }
    let apart = farthest(&same, &scaled);
    assert!(apart < ROUNDING, "{apart:e}");
    let start = march::<2>(|setup| setup.fluids[0].surface_tension = 0.0);
    assert!(farthest(&same, &start) > 0.1, "the drop must have moved");
}

#[test]
fn a_drop_turned_by_a_right_angle_moves_alike() {
    let turn = |x: Vector<f64, 2>| Vector([-x[1], x[0]]);
    let same: Vec<_> = march::<2>(|_| ()).into_iter().map(turn).collect();
    let turned = march::<2>(|setup| {
        for particle in &mut setup.particles {
            particle.position = turn(particle.position);
        }
    });
    let apart = farthest(&same, &turned);
    assert!(apart < ROUNDING, "2D: {apart:e}");
    let turn = |x: Vector<f64, 3>| Vector([x[1], x[2], x[0]]);
    let same: Vec<_> = march::<3>(|_| ()).into_iter().map(turn).collect();
    let turned = march::<3>(|setup| {
        for particle in &mut setup.particles {
            particle.position = turn(particle.position);
        }
    });
    let apart = farthest(&same, &turned);
    assert!(apart < ROUNDING, "3D: {apart:e}");
}
