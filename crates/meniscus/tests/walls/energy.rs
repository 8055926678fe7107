//! The liquid's energy is what weight and walls put into it.

use meniscus::measure::{compression_energy, kinetic_energy};
use meniscus::rates::{Dimension, Space};
use meniscus::scheme::{BodyForce, Motion, PressureForm, Scheme};
use meniscus::{Fluid, Simulation, Snapshot};

use crate::setups::tank;

fn energy<const D: usize>(simulation: &Simulation<D>) -> f64 {
    let liquid = simulation.particles().of_bodies(|body| body == 0);
    kinetic_energy(&liquid.velocity, &liquid.mass)
        + compression_energy(&liquid.mass, &liquid.density, &simulation.fluids()[0])
}

/// Energy gained and work done in a third of a second by a liquid without friction in a tank that
/// is shaken while gravity tilts.
fn sloshed<const D: usize>() -> (f64, f64, f64)
where
    Space: Dimension<D>,
{
    let mut scheme = Scheme::new(0.15);
    scheme.pressure = PressureForm::OverDensityProduct;
    scheme.artificial_viscosity = 0.0;
    let (mut mean, mut amplitude) = ([0.0; 3], [0.0; 3]);
    (mean[D - 1], amplitude[0]) = (-9.81, 3.0);
    scheme.body_force = Some(BodyForce::Oscillating {
        mean,
        amplitude,
        frequency: 2.0,
        phase: 0.0,
    });
    let mut liquid = Fluid::new("liquid", 1000.0);
    liquid.sound_speed = 30.0;
    let mut setup = tank::<D>(1.0, 1.5, 0.7, 0.1, scheme, liquid);
    setup.scheme.walls[0].motion = Motion::Oscillation {
        velocity: [0.0; 3],
        amplitude: [0.05, 0.0, 0.0],
        frequency: 2.0,
        phase: 0.5,
    };
    let mut simulation = Simulation::<D>::new(setup.clone()).unwrap();
    let start = energy(&simulation);
    simulation.advance_to(0.2).unwrap();
    // A restored simulation goes on counting.
    let snapshot: Snapshot = simulation.snapshot();
    let mut simulation = Simulation::restore(setup, &snapshot).unwrap();
    simulation.advance_to(0.33).unwrap();
    let work = simulation.work();
    (energy(&simulation) - start, work.body_force, work.walls)
}

#[test]
fn a_liquid_without_friction_keeps_what_is_put_into_it() {
    for (gained, weight, walls) in [sloshed::<2>(), sloshed::<3>()] {
        // Pairs exchange energy exactly; what is left is of second order in the time step (0.1 %
        // in 2D, 0.4 % in 3D).
        let scale = weight.abs().max(walls.abs());
        assert!(
            (gained - weight - walls).abs() < 0.01 * scale,
            "{gained} {weight} {walls}"
        );
    }
}
