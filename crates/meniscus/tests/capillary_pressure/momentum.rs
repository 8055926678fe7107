//! What forces add up to, and what walls bear.

use meniscus::measure::linear_momentum;
use meniscus::scheme::{BodyForce, Slip};
use meniscus::{Simulation, Vector};

use crate::common::{put_on_a_plate, ten_steps};
use crate::liquid;

/// Of some hundred particles' sums.
const ROUNDING: f64 = 1e-12;

#[test]
fn each_body_keeps_its_momentum() {
    let offset = Vector([38.0, 0.0]);
    let setup = liquid::<2>(50.0, 0.3, 0.1, |x| {
        x.norm() < 7.0 || ((x - offset).norm() < 7.0 && x[1] > -2.0)
    });
    let mut simulation = Simulation::new(setup).expect("a sound setup");
    let (forces, _) = ten_steps(&mut simulation);
    let p = simulation.particles();
    for near in [true, false] {
        let rows = (0..p.len()).filter(|&i| (p.position[i][0] < 19.0) == near);
        let velocity: Vec<_> = rows.map(|i| p.velocity[i]).collect();
        let linear = linear_momentum(&velocity, &vec![1.0; velocity.len()]).norm();
        assert!(linear < ROUNDING * forces, "{linear:e} of {forces}");
    }
}

/// A drop under its weight at 90 degrees pulls its plate sideways only: the plate bears the weight.
#[test]
fn a_plate_bears_the_weight_of_a_drop() {
    let radius = 8.0;
    let mut setup = liquid::<2>(radius, 0.0, 1.0, |x| x[1] > 0.0 && x.norm() < radius);
    let weight = 0.002 * setup.particles.len() as f64;
    put_on_a_plate(&mut setup, 40.0, 90.0, Slip::NoSlip);
    setup.scheme.body_force = Some(BodyForce::Constant([0.0, -0.002, 0.0]));
    setup.scheme.damping = 0.3;
    let mut simulation = Simulation::new(setup).expect("a sound setup");
    simulation.advance_to(150.0).expect("a drop at rest");
    let force = simulation.wall_loads()[0].force;
    // The line of contact pulls upwards by sigma sin(theta) at either end, as much as q pushes downwards.
    let laplace = 2.0;
    assert!(
        (force[1] + weight).abs() < 0.15 * laplace,
        "{force:?} of {weight}"
    );
    assert!(force[0].abs() < 0.05 * laplace, "{force:?}");
}
