//! What pairwise forces add up to.

use meniscus::measure::{angular_momentum, linear_momentum};
use meniscus::physics::surface_tension::pairwise::Pairwise;
use meniscus::physics::surface_tension::pairwise::akinci::{Akinci, Curvature};
use meniscus::physics::wall::layout::Layers;
use meniscus::rates::{Dimension, Space};
use meniscus::scheme::{Adhesion, SurfaceTension, Wall};
use meniscus::{Domain, Particle, Simulation, Vector};

use crate::common::{free_drop, ten_steps};
use crate::{lennard_jones, soft};

/// Of some hundred particles' sums, each of a hundred rounded terms.
const ROUNDING: f64 = 1e-13;

/// Momentum and angular momentum that a jittered drop gains in ten steps, over the sums of
/// the magnitudes that its particles exchanged.
fn gain<const D: usize>(model: Pairwise) -> (f64, f64)
where
    Space: Dimension<D>,
{
    let mut setup = free_drop::<D>(if D == 2 { 0.1 } else { 0.25 }, 0.15);
    setup.scheme.surface_tension = Some(SurfaceTension::Pairwise(model));
    let mut simulation = Simulation::new(setup).expect("a sound setup");
    let (forces, torques) = ten_steps(&mut simulation);
    let p = simulation.particles();
    let linear = linear_momentum(&p.velocity, &p.mass).norm();
    let angular = angular_momentum(&p.position, &p.velocity, &p.mass, Vector::ZERO);
    (linear / forces, Vector(angular).norm() / torques)
}

fn conserves<const D: usize>()
where
    Space: Dimension<D>,
{
    for model in soft().into_iter().chain([lennard_jones(0.1)]) {
        let (linear, angular) = gain::<D>(model);
        assert!(linear < ROUNDING, "{D}D, {model:?}: {linear:e}");
        assert!(angular < ROUNDING, "{D}D, {model:?}: {angular:e}");
    }
    // Differences of normals do not lie along the line between two particles: a torque is left.
    let (linear, angular) = gain::<D>(Pairwise::Akinci(Akinci {
        curvature: Curvature::Consistent,
        ..Akinci::default()
    }));
    assert!(linear < ROUNDING, "{D}D, curvature: {linear:e}");
    assert!(angular > 1e3 * ROUNDING, "{D}D, curvature: {angular:e}");
    assert!(angular < 0.05, "{D}D, curvature: {angular:e}");
}

#[test]
fn momentum_is_conserved_and_angular_momentum_but_for_the_curvature_force() {
    conserves::<2>();
    conserves::<3>();
}

/// The forces of single pairs, one by one, are what moves each particle of a jittered drop.
#[test]
fn forces_at_rest_add_up_to_the_accelerations() {
    for model in soft() {
        let mut setup = free_drop::<2>(0.1, 0.15);
        setup.scheme.surface_tension = Some(SurfaceTension::Pairwise(model));
        for particle in &mut setup.particles {
            particle.velocity = Vector::ZERO;
        }
        let simulation = Simulation::new(setup).expect("a sound setup");
        let p = simulation.particles();
        let largest = p.acceleration.iter().map(Vector::norm).fold(0.0, f64::max);
        for i in 0..p.len() {
            let mut force = Vector::ZERO;
            for j in 0..p.len() {
                let offset = p.position[i] - p.position[j];
                force += simulation.force_at_rest([i, j], offset);
            }
            let rest = (force * (1.0 / p.mass[i]) - p.acceleration[i]).norm();
            // The engine sums in another order.
            assert!(rest < 1e-11 * largest, "{model:?}: {rest:e} of {largest:e}");
        }
    }
}

/// A jittered drop upon a plane that attracts it, without weight.
#[test]
fn the_wall_feels_what_the_drop_does() {
    for adhesion in [Adhesion::Coefficient(50.0), Adhesion::ContactAngle(1.0)] {
        let mut setup = free_drop::<2>(0.1, 0.15);
        let support = 0.4;
        let wall = Layers::new(0.1, support, 1000)
            .plane(Vector([0.0, -1.0]), Vector([0.0, 1.0]), 3.0)
            .expect("it fits");
        setup
            .particles
            .extend(wall.iter().map(|&position| Particle {
                position,
                velocity: Vector::ZERO,
                mass: 0.01,
                fluid: 0,
                body: 1,
            }));
        setup.scheme.surface_tension = Some(SurfaceTension::Pairwise(Pairwise::Akinci(
            Akinci::default(),
        )));
        setup.domain = Domain::default();
        setup.scheme.walls = vec![Wall {
            adhesion,
            ..Wall::new(1)
        }];
        let simulation = Simulation::new(setup).expect("a sound setup");
        let p = simulation.particles();
        let fluid = || (0..p.len()).filter(|&i| p.body[i] == 0);
        let on_fluid: f64 = fluid().map(|i| p.mass[i] * p.acceleration[i][1]).sum();
        let exchanged: f64 = fluid().map(|i| p.mass[i] * p.acceleration[i].norm()).sum();
        let on_wall = simulation.wall_loads()[0].force[1];
        assert!(on_fluid < -1e6 * ROUNDING * exchanged, "{on_fluid}");
        let rest = (on_fluid + on_wall).abs() / exchanged;
        assert!(rest < ROUNDING, "{adhesion:?}: {on_fluid} and {on_wall}");
    }
}
