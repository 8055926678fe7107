//! Momentum of each free body, and of all.

use meniscus::rates::{Dimension, Space};
use meniscus::{Simulation, Vector};

use crate::ball;
use crate::common::ten_steps;

fn momenta<const D: usize>(
    simulation: &Simulation<D>,
    of: impl Fn(u32) -> bool,
) -> (Vector<f64, D>, f64) {
    let p = simulation.particles();
    let (mut linear, mut angular) = (Vector::ZERO, [0.0; 3]);
    for i in (0..p.len()).filter(|&i| of(p.id[i])) {
        linear += p.velocity[i] * p.mass[i];
        let (x, v) = (p.position[i].to_3d(), p.velocity[i].to_3d());
        for (d, sum) in angular.iter_mut().enumerate() {
            let (e, f) = ((d + 1) % 3, (d + 2) % 3);
            *sum += p.mass[i] * (x[e] * v[f] - x[f] * v[e]);
        }
    }
    (linear, Vector(angular).norm())
}

/// Two drops a little farther apart than particles see, one of them bigger.
fn two_drops_keep_to_themselves<const D: usize>(radius: f64)
where
    Space: Dimension<D>,
{
    let mut setup = ball::<D>(Vector::ZERO, radius, 0.1, 0.0);
    let first = setup.particles.len() as u32;
    let mut there = Vector::ZERO;
    there[0] = 2.0 * radius + 6.0;
    let other = ball::<D>(there, radius + 0.7, 0.1, 0.0).particles;
    setup.particles.extend(other);
    let mut simulation = Simulation::new(setup).expect("a sound setup");
    let net = simulation.surface().net_force.norm();
    assert!(net > 1e-6, "nothing to balance: {net}");
    let (forces, torques) = ten_steps(&mut simulation);
    for one in [true, false] {
        let (linear, angular) = momenta(&simulation, |id| (id < first) == one);
        // Rounding of sums whose terms are as large as this.
        assert!(linear.norm() < 1e-13 * forces, "{:e}", linear.norm());
        assert!(angular < 1e-12 * torques, "{angular:e} of {torques:e}");
    }
}

#[test]
fn every_body_keeps_its_momentum() {
    two_drops_keep_to_themselves::<2>(7.0);
    two_drops_keep_to_themselves::<3>(4.0);
}
