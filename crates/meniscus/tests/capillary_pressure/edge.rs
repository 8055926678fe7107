//! What walls do at the edge of a liquid.

use meniscus::physics::wall::layout::Layers;
use meniscus::scheme::Slip;
use meniscus::{Simulation, Vector};

use crate::common::{put_beside_wall, put_on_a_plate};
use crate::liquid;

/// Densities of a slab that slides along its plate at this speed, after a quarter of a time unit.
fn densities(speed: f64) -> Vec<f64> {
    let width = 8.0;
    let mut setup = liquid::<2>(width, 0.05, 0.0, |x| {
        x[0].abs() < width && x[1] > 0.0 && x[1] < 5.0
    });
    for particle in &mut setup.particles {
        particle.velocity[0] = speed;
    }
    put_on_a_plate(&mut setup, 30.0, 90.0, Slip::FreeSlip);
    let mut simulation = Simulation::new(setup).expect("a sound setup");
    simulation.advance_to(0.25).expect("a short way");
    let particles = simulation.particles().of_bodies(|body| body == 0);
    let mut density: Vec<_> = particles.id.iter().zip(particles.density).collect();
    density.sort_by_key(|(id, _)| **id);
    density.into_iter().map(|(_, density)| density).collect()
}

#[test]
fn a_liquid_that_slides_as_a_whole_is_compressed_nowhere() {
    let off = densities(0.0).into_iter().zip(densities(1.0));
    let most = off
        .map(|(rest, sliding)| (sliding - rest).abs())
        .fold(0.0, f64::max);
    assert!(most < 0.005, "{most}");
}

/// Pressure pushes the plate by 2 sigma sin(theta), and the surface pulls at its two lines as much.
#[test]
fn a_drop_without_weight_neither_pushes_nor_pulls_its_plate() {
    for degrees in [60.0, 90.0, 120.0_f64] {
        let radius = 10.0;
        // Cut so that it stands at its angle.
        let centre = -radius * degrees.to_radians().cos();
        let inside = |x: Vector<f64, 2>| x[1] > 0.0 && (x - Vector([0.0, centre])).norm() < radius;
        let mut setup = liquid::<2>(2.0 * radius, 0.0, 0.1, inside);
        put_on_a_plate(&mut setup, 50.0, degrees, Slip::NoSlip);
        setup.scheme.damping = 0.3;
        let mut simulation = Simulation::new(setup).expect("a sound setup");
        simulation.advance_to(60.0).expect("a drop at rest");
        let force = simulation.wall_loads()[0].force;
        let pull = 2.0 * degrees.to_radians().sin();
        // The sum over nodes of what a line pulls is a fifth short at 120 degrees, where level sets are bent the most.
        assert!(
            force[1].abs() < 0.2 * pull,
            "{degrees}: {force:?} of {pull}"
        );
        assert!(force[0].abs() < 0.05 * pull, "{degrees}: {force:?}");
    }
}

/// A pool that meets its tank at a right angle is at rest, up to its corners.
#[test]
fn a_pool_fills_the_corners_of_its_tank() {
    let (half, depth) = (8.0, 7.0);
    let mut setup = liquid::<2>(half, 0.02, 0.1, |x| {
        x[0].abs() < half && x[1] > 0.0 && x[1] < depth
    });
    let (low, high) = (Vector([-half, 0.0]), Vector([half, 12.0]));
    let tank = Layers::new(1.0, 4.0, 10_000).tank(low, high, &[(1, true)]);
    put_beside_wall(&mut setup, &tank.expect("it fits"), 90.0, Slip::NoSlip);
    let mut simulation = Simulation::new(setup).expect("a sound setup");
    simulation.advance_to(10.0).expect("a pool at rest");
    let p = simulation.particles().of_bodies(|body| body == 0);
    for corner in [-half, half] {
        let away = |x: &Vector<f64, 2>| (*x - Vector([corner, 0.0])).norm();
        let nearest = p.position.iter().map(away).fold(f64::INFINITY, f64::min);
        // 0.71 on a lattice; 1.7 where both walls push.
        assert!(nearest < 1.1, "{nearest}");
    }
    // The jitter's; a particle that was pushed out of its corner had 6 % more.
    let off = p.density.iter().map(|density| (density - 1.0).abs());
    let most = off.fold(0.0, f64::max);
    assert!(most < 0.03, "{most}");
}
