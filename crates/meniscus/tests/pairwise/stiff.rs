//! Lennard-Jones forces are stiff.

use std::f64::consts::TAU;

use meniscus::scheme::SurfaceTension;
use meniscus::time::step::Limit;
use meniscus::{Domain, Particle, Setup, Simulation, Vector};

use crate::common::{fluid, scheme};
use crate::{lennard_jones, resolution};

/// Two particles, 1 % further apart than at rest, in a liquid that hardly resists compression.
/// By the potential G m^2 r_0 u / 12, whose second slope at r_0 is 6 G m^2 / r_0, the distance
/// swings at omega^2 = 12 G m / r_0.
#[test]
fn two_particles_swing_as_the_potential_says() {
    let spacing = 0.1;
    let mut fluid = fluid(0.0, 1.0);
    fluid.sound_speed = 0.1;
    let mass = spacing * spacing;
    let particle = |x: f64| Particle {
        position: Vector([x, 0.0]),
        velocity: Vector::ZERO,
        mass,
        fluid: 0,
        body: 0,
    };
    let model = lennard_jones(spacing);
    let mut setup = Setup {
        scheme: scheme(spacing),
        fluids: vec![fluid],
        particles: vec![particle(0.0), particle(1.01 * spacing)],
        spacing,
        domain: Domain::default(),
    };
    setup.scheme.surface_tension = Some(SurfaceTension::Pairwise(model));
    let strength = model.strength(&setup.fluids[0], &resolution(&setup));
    let omega = (12.0 * strength * mass / spacing).sqrt();
    let mut simulation = Simulation::new(setup).expect("a sound setup");
    assert_eq!(simulation.limits().governing().0, Limit::Pairwise);
    let distance = |simulation: &Simulation<2>| {
        let p = simulation.particles();
        (p.position[0] - p.position[1]).norm() / spacing
    };
    // Times at which the distance falls through that at rest.
    let mut falls = Vec::new();
    let mut before = (0.0, distance(&simulation));
    while falls.len() < 11 {
        simulation.step().expect("two particles do no harm");
        let after = (simulation.time(), distance(&simulation));
        if before.1 >= 1.0 && after.1 < 1.0 {
            let part = (before.1 - 1.0) / (before.1 - after.1);
            falls.push(before.0 + part * (after.0 - before.0));
        }
        before = after;
        assert!(simulation.time() < 20.0 * TAU / omega, "no swing");
    }
    let period = (falls[10] - falls[0]) / 10.0;
    // The potential is not a parabola: at 1 % the period is longer by 0.3 %; a leapfrog at
    // half its limit over four is faster by (omega dt)^2 / 24.
    assert!(
        (period * omega / TAU - 1.0).abs() < 0.01,
        "{}",
        period * omega / TAU
    );
}
