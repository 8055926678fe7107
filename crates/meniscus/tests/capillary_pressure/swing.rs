//! A drop that swings.

use meniscus::theory::{equivalent_radius, viscous_oscillation};
use meniscus::{Simulation, Vector};

use crate::liquid;

/// The ellipse of a slightly drawn-out drop passes through the circle after a quarter of the period of exact
/// viscous theory.
#[test]
fn a_drop_swings_with_the_period_of_theory() {
    let radius = 8.0;
    // La = 500.
    let viscosity = (2.0 * radius / 500.0_f64).sqrt();
    let stretch = 1.06;
    let setup = liquid::<2>(1.2 * radius, 0.1, viscosity, |x| {
        Vector([x[0] / stretch, x[1] * stretch]).norm() < radius
    });
    let round = equivalent_radius(setup.particles.len() as f64, 2);
    let theory = viscous_oscillation(2, 1.0, 1.0, viscosity, round, 2).expect("it swings");
    let mut simulation = Simulation::new(setup).expect("a sound setup");
    let difference = |simulation: &Simulation<2>| -> f64 {
        let p = simulation.particles();
        (p.position.iter()).map(|x| x[0] * x[0] - x[1] * x[1]).sum()
    };
    let (mut before, mut crossings) = (difference(&simulation), Vec::new());
    while crossings.len() < 2 && simulation.time() < 10.0 / theory.angular_frequency {
        let start = simulation.time();
        simulation.step().expect("a calm drop");
        let now = difference(&simulation);
        if now * before < 0.0 {
            crossings.push(start + (simulation.time() - start) * before / (before - now));
        }
        before = now;
    }
    // Half a period lies between two of them, however the motion began.
    let half = crossings[1] - crossings[0];
    let expected = std::f64::consts::PI / theory.angular_frequency;
    // A lattice's ellipse is one within some hundredths; the frequency of this model at eight spacings within one.
    assert!((half / expected - 1.0).abs() < 0.03, "{half} of {expected}");
}

/// The mesh that the model works on is fixed in space; a drop does not feel where its nodes lie.
#[test]
fn a_drop_swings_alike_wherever_it_is() {
    let radius = 7.0;
    let stretch = 1.06;
    let force = |place: Vector<f64, 2>| -> f64 {
        let mut setup = liquid::<2>(1.2 * radius, 0.1, 0.1, |x| {
            Vector([x[0] / stretch, x[1] * stretch]).norm() < radius
        });
        for particle in &mut setup.particles {
            particle.position += place;
        }
        let simulation = Simulation::new(setup).expect("a sound setup");
        let p = simulation.particles();
        (p.position.iter().zip(&p.acceleration))
            .map(|(x, a)| {
                let x = *x - place;
                x[0] * a[0] - x[1] * a[1]
            })
            .sum()
    };
    let places = (0..8).map(|k| Vector([0.37, 0.61].map(|part: f64| (part * k as f64).fract())));
    let forces: Vec<f64> = places.map(force).collect();
    let mean = forces.iter().sum::<f64>() / forces.len() as f64;
    let worst = (forces.iter())
        .map(|force| (force / mean - 1.0).abs())
        .fold(0.0, f64::max);
    // A jittered lattice of seven spacings feels it by one hundredth; with one mesh instead of two by six.
    assert!(worst < 0.02, "{forces:?}");
}
