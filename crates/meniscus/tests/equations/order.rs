//! What halving the time step gains.

use std::f64::consts::TAU;

use meniscus::scheme::TimeStep;
use meniscus::{Setup, Simulation, Vector};

use crate::common::{fluid, periodic_box};
use crate::wave::strip;

/// Velocities and densities after `steps` steps of `dt`, by number of the particle.
fn march(setup: &Setup<2>, dt: f64, steps: u32) -> Vec<[f64; 3]> {
    let mut setup = setup.clone();
    setup.scheme.time_step = TimeStep::Fixed(dt);
    let mut simulation = Simulation::new(setup).expect("a sound setup");
    for _ in 0..steps {
        simulation.step().expect("the flow is calm");
    }
    let p = simulation.particles();
    let mut state = vec![[0.0; 3]; p.len()];
    for i in 0..p.len() {
        state[p.id[i] as usize] = [p.velocity[i][0], p.velocity[i][1], p.density[i]];
    }
    state
}

/// By how much a state at a fixed time moves when `dt` is halved, over how much
/// when it is halved again: two to the order of the scheme. Root mean squares,
/// of velocity and of density.
fn gain(setup: &Setup<2>, dt: f64, steps: u32) -> [f64; 2] {
    let runs = [1, 2, 4].map(|k| march(setup, dt / f64::from(k), steps * k));
    let difference = |a: &[[f64; 3]], b: &[[f64; 3]], columns: std::ops::Range<usize>| {
        (a.iter().zip(b))
            .flat_map(|(a, b)| columns.clone().map(move |k| (a[k] - b[k]).powi(2)))
            .sum::<f64>()
            .sqrt()
    };
    [0..2, 2..3].map(|columns| {
        difference(&runs[0], &runs[1], columns.clone()) / difference(&runs[1], &runs[2], columns)
    })
}

const N: usize = 24;

#[test]
fn without_viscosity_the_scheme_is_of_second_order() {
    // A wave of 0.3 % of the speed of sound, and vortices that turn fluid round.
    let wave = strip::<2>(N, 1, 0.03, fluid(0.0, 0.0));
    let vortices = periodic_box::<2>(
        N,
        |x| {
            let [x, y] = x.0.map(|x| TAU * x);
            Vector([x.sin() * y.cos(), -x.cos() * y.sin()])
        },
        fluid(0.0, 0.0),
    );
    for (name, setup) in [("wave", wave), ("vortices", vortices)] {
        for gain in gain(&setup, 0.02 / N as f64, 50) {
            // Nearer to four than to two or eight.
            assert_eq!(gain.log2().round(), 2.0, "{name}: {gain}");
        }
    }
}

#[test]
fn viscosity_is_of_first_order() {
    let setup = strip::<2>(N, 0, 1e-4, fluid(0.05, 0.0));
    let [velocity, _] = gain(&setup, 0.02 / N as f64, 50);
    // Two, and the next order in nu k^2 dt = 1.6e-3.
    assert!((velocity - 2.0).abs() < 0.03, "{velocity}");
}
