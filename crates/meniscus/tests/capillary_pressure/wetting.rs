//! Contact angles, from a start at 90 degrees.

use meniscus::measure::{DropOnWall, Plane};
use meniscus::physics::wall::layout::Layers;
use meniscus::scheme::{Adhesion, Slip, Wall};
use meniscus::{Particle, Simulation, Vector};

use crate::liquid;

/// The angle by a circle, in degrees, at which half a disc of ten spacings comes to rest.
fn angle(degrees: f64, slip: Slip) -> f64 {
    let radius = 10.0;
    let mut setup = liquid::<2>(radius, 0.1, 0.8, |x| x[1] > 0.0 && x.norm() < radius);
    let plate = Layers::new(1.0, 4.0, 10_000)
        .plane(Vector([0.0, 0.0]), Vector([0.0, 1.0]), 50.0)
        .expect("it fits");
    setup
        .particles
        .extend(plate.iter().map(|&position| Particle {
            position,
            velocity: Vector::ZERO,
            mass: 1.0,
            fluid: 0,
            body: 1,
        }));
    setup.scheme.walls = vec![Wall {
        adhesion: Adhesion::ContactAngle(degrees.to_radians()),
        slip,
        ..Wall::new(1)
    }];
    let mut simulation = Simulation::new(setup).expect("a sound setup");
    simulation.advance_to(300.0).expect("a drop at rest");
    let p = simulation.particles().of_bodies(|body| body == 0);
    let wall = Plane::new(Vector::ZERO, Vector([0.0, 1.0])).expect("a plane");
    let drop = DropOnWall::measure(&p.position, &p.mass, 1.0, &wall).expect("a drop");
    drop.circle.value.to_degrees()
}

/// A wetting drop stands at its angle within what a circle through the outermost particles of ten spacings tells; one that
/// does not wet stands too steep, by up to twenty degrees on a jittered lattice.
#[test]
fn a_drop_comes_to_stand_at_the_angle_of_its_wall() {
    for (degrees, slip, within) in [
        (60.0, Slip::NoSlip, 8.0),
        (90.0, Slip::FreeSlip, 8.0),
        (120.0, Slip::FreeSlip, 22.0),
    ] {
        let found = angle(degrees, slip);
        assert!((found - degrees).abs() < within, "{degrees}: {found}");
    }
}
