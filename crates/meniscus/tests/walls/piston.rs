//! A piston that compresses a liquid.

use meniscus::physics::equation_of_state::Tait;
use meniscus::scheme::{Motion, PressureForm, Scheme, Wall};
use meniscus::{Fluid, Simulation};

use crate::setups::channel;

/// Force per area on the resting wall and on the piston, and the range of pressure, over what
/// the equation of state has for the volume that is left.
fn compressed(spacing: f64) -> [f64; 4] {
    let liquid = Fluid::new("liquid", 1.0);
    let mut scheme = Scheme::new(1.5 * spacing);
    scheme.pressure = PressureForm::OverDensityProduct;
    let mut piston = Wall::new(2);
    // Down by a hundredth in half a period, from rest to rest, slowly against sound.
    piston.motion = Motion::Oscillation {
        velocity: [0.0; 3],
        amplitude: [0.0, -0.005, 0.0],
        frequency: 0.25,
        phase: -std::f64::consts::FRAC_PI_2,
    };
    let setup = channel(8, spacing, scheme, liquid.clone(), [Wall::new(1), piston]);
    let mut simulation = Simulation::new(setup).unwrap();
    simulation.advance_to(2.0).unwrap();
    let exact = Tait::new(&liquid).pressure(liquid.density / 0.99);
    let p = simulation.particles().of_bodies(|body| body == 0);
    let area = 8.0 * spacing;
    let load = |wall: usize| simulation.wall_loads()[wall].force[1] / area;
    let least = p.pressure.iter().copied().fold(f64::INFINITY, f64::min);
    let most = p.pressure.iter().copied().fold(0.0, f64::max);
    [-load(0), load(1), least, most].map(|pressure| pressure / exact)
}

#[test]
fn a_piston_raises_pressure_by_the_equation_of_state() {
    for spacing in [0.05, 0.025] {
        let [resting, moving, least, most] = compressed(spacing);
        // The volume that the piston takes goes into density in full, so the mean is right at
        // any spacing; among the layers next to a wall it is spread by the kernel's width.
        for load in [resting, moving] {
            assert!((load - 1.0).abs() < 0.015, "{spacing}: {load}");
        }
        assert!(least > 0.97 && most < 1.03, "{spacing}: {least} to {most}");
    }
}
