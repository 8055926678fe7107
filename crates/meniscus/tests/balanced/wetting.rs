//! Drops on a plate.

use std::f64::consts::PI;

use meniscus::scheme::Slip;
use meniscus::{Setup, Simulation, Vector};

use crate::ball;
use crate::common::put_on_a_plate;

/// Half a disc on a plate of this contact angle.
fn half_disc(radius: f64, degrees: f64, slip: Slip) -> Setup<2> {
    let time = radius.powf(1.5);
    let mut setup = ball::<2>(Vector::ZERO, radius, 0.1, 0.14 * radius * radius / time);
    setup
        .particles
        .retain(|particle| particle.position[1] > 0.0);
    put_on_a_plate(&mut setup, 4.0 * radius, degrees, slip);
    setup
}

/// The angle in degrees of a cap of circle that is as high, in the mean, as the liquid.
fn angle(simulation: &Simulation<2>) -> f64 {
    let p = simulation.particles();
    let (mut area, mut moment) = (0.0, 0.0);
    for i in (0..p.len()).filter(|&i| p.body[i] == 0) {
        area += p.volume(i);
        moment += p.volume(i) * p.position[i][1];
    }
    let height = |angle: f64| {
        let part = angle - angle.sin() * angle.cos();
        let radius = (area / part).sqrt();
        radius * (2.0 / 3.0 * angle.sin().powi(3) / part - angle.cos())
    };
    let (mut low, mut high) = (0.05, PI - 0.05);
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        if height(middle) < moment / area {
            low = middle;
        } else {
            high = middle;
        }
    }
    low.to_degrees()
}

#[test]
fn a_drop_spreads_to_its_contact_angle() {
    let radius = 8.0_f64;
    let setup = half_disc(radius, 60.0, Slip::NoSlip);
    let mut simulation = Simulation::new(setup).expect("a sound setup");
    let start = angle(&simulation);
    simulation
        .advance_to(8.0 * radius.powf(1.5))
        .expect("the drop is calm");
    let end = angle(&simulation);
    // Eight spacings to the radius, six to the height: a particle in one spot or its neighbour.
    assert!(
        (start - 90.0).abs() < 3.0 && (end - 60.0).abs() < 6.0,
        "{start}, {end}"
    );
}

#[test]
fn a_plane_wall_does_not_drag_a_drop_along() {
    let radius = 7.0_f64;
    let setup = half_disc(radius, 90.0, Slip::FreeSlip);
    let mut simulation = Simulation::new(setup).expect("a sound setup");
    let time = radius.powf(1.5);
    let momentum = |simulation: &Simulation<2>| {
        let p = simulation.particles();
        let along = (0..p.len()).map(|i| p.velocity[i][0] * p.mass[i]);
        along.sum::<f64>() / (p.len() as f64 * radius / time)
    };
    for _ in 0..200 {
        simulation.step().expect("the drop is calm");
    }
    // Surface tension adds none; particles of the wall, by their lattice, a little: without
    // the balance it is several times as much.
    let found = momentum(&simulation);
    assert!(found.abs() < 2e-3, "{found}");
}
