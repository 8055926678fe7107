//! Which effect limits the time step, with values worked out by hand.

use meniscus::fluid::Fluid;
use meniscus::scheme::{BodyForce, TimeStep};
use meniscus::time::step::{Limit, StepLimits};
use meniscus::{Simulation, Vector};

use crate::common::{fluid, periodic_box};

fn close(found: f64, expected: f64) {
    // As many digits as were worked out.
    assert!(
        (found / expected - 1.0).abs() < 1e-4,
        "{found}, expected {expected}"
    );
}

fn water() -> Fluid {
    Fluid {
        viscosity: 4.0,
        surface_tension: 0.07,
        ..Fluid::new("water", 1000.0)
    }
}

#[test]
fn limits_of_a_fluid() {
    // h = 0.2 m, support 0.4 m, 2 m/s, 5 m/s^2.
    let limits = StepLimits::new(&[water()], 0.2, 0.4, 2.0, 5.0);
    close(limits.acoustic, 0.04 / 12.0);
    close(limits.force, 0.25 * 0.2);
    close(limits.viscous, 0.005 / 0.004);
    // sqrt(8 / 0.43982) = 4.26488
    close(limits.capillary, 1.06622);
    assert_eq!(limits.governing(), (Limit::Acoustic, limits.acoustic));
}

#[test]
fn the_strictest_fluid_counts_and_absent_effects_do_not() {
    let oil = Fluid {
        density: 900.0,
        sound_speed: 40.0,
        viscosity: 0.0,
        surface_tension: 0.28,
        ..water()
    };
    let limits = StepLimits::new(&[water(), oil.clone()], 0.2, 0.4, 0.0, 0.0);
    close(limits.acoustic, 0.001);
    close(limits.viscous, 1.25);
    // sqrt(0.9 / 4) of water's.
    close(limits.capillary, 1.06622 * 0.474342);
    assert_eq!(limits.force, f64::INFINITY);
    let limits = StepLimits::new(&[oil], 0.2, 0.4, 0.0, 0.0);
    assert_eq!(limits.viscous, f64::INFINITY);
}

/// h = 0.25, support 0.5, density 1.
fn governed_by(expected: Limit, step: f64, fluid: Fluid, gravity: f64) {
    let mut setup = periodic_box::<2>(8, |_| Vector::ZERO, fluid);
    setup.scheme.time_step = TimeStep::Adaptive { safety: 0.8 };
    setup.scheme.body_force = Some(BodyForce::Constant([gravity, 0.0, 0.0]));
    let simulation = Simulation::new(setup).expect("a sound setup");
    let (limit, least) = simulation.limits().governing();
    assert_eq!(limit, expected);
    close(least, step);
    close(simulation.next_step(), 0.8 * step);
}

#[test]
fn each_limit_governs_where_it_should() {
    governed_by(Limit::Acoustic, 0.005, fluid(0.0, 0.0), 0.0);
    governed_by(Limit::Viscous, 0.125 * 0.0625 / 4.0, fluid(4.0, 0.0), 0.0);
    // 2 pi 10^4 = 62831.9; 0.015625 / 62831.9 = 2.48680e-7
    governed_by(Limit::Capillary, 0.25 * 4.98679e-4, fluid(0.0, 1e4), 0.0);
    governed_by(Limit::Force, 0.25 * 0.0025, fluid(0.0, 0.0), 4e4);
}
