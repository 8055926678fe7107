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
