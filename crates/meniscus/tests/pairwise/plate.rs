//! A drop on a plate that attracts it.

use meniscus::physics::wall::layout::Layers;
use meniscus::scheme::{Adhesion, Bearing, PressureForm, SurfaceTension, Wall};
use meniscus::shape::{Arrangement, Pattern, Shape};
use meniscus::{Domain, Particle, Setup, Simulation, Vector};

use crate::cohesion;
use crate::common::{fluid, scheme};

const SPACING: f64 = 0.1;

/// The gap between the plate and the drop's lowest particles, less the half spacing that belongs to
/// these, in spacings, when a square drop without weight has come to rest.
fn gap(bearing: Bearing) -> f64 {
    let block = Shape::Block {
        low: Vector([-1.0, 0.0]),
        high: Vector([1.0, 1.0]),
    };
    let arrangement = Arrangement {
        jitter: 0.05,
        ..Arrangement::new(Pattern::Cubic, SPACING)
    };
    let mut particles = arrangement.body(&block, 1.0, 1000).expect("it fits");
    let plate = Layers::new(SPACING, 4.0 * SPACING, 1000)
        .plane(Vector([0.0, 0.0]), Vector([0.0, 1.0]), 4.0)
        .expect("it fits");
    particles.extend(plate.iter().map(|&position| Particle {
        position,
        velocity: Vector::ZERO,
        mass: SPACING * SPACING,
        fluid: 0,
        body: 1,
    }));
    let mut setup = Setup {
        scheme: scheme(SPACING),
        fluids: vec![fluid(0.0, 1.0)],
        particles,
        spacing: SPACING,
        domain: Domain::default(),
    };
    setup.scheme.pressure = PressureForm::HuAdams;
    setup.scheme.artificial_viscosity = 0.2;
    setup.scheme.damping = 2.0;
    setup.scheme.surface_tension = Some(SurfaceTension::Pairwise(cohesion()));
    setup.scheme.walls = vec![Wall {
        adhesion: Adhesion::ContactAngle(1.0),
        bearing,
        ..Wall::new(1)
    }];
    let mut simulation = Simulation::new(setup).expect("a sound setup");
    simulation.advance_to(3.0).expect("a drop at rest");
    let p = simulation.particles();
    let lowest = (0..p.len())
        .filter(|&i| p.body[i] == 0)
        .map(|i| p.position[i][1])
        .fold(f64::INFINITY, f64::min);
    lowest / SPACING - 0.5
}

/// In bulk the liquid bears its cohesion by pressure. A wall of that pressure pushes the liquid off,
/// since there is less cohesion at the wall to hold against; one that balances cohesion does not.
/// Adhesion alone, as printed, raises the wall's pressure further.
#[test]
fn a_drop_stays_at_a_plate_whose_pressure_balances_cohesion() {
    let [pairs, adhesion, nothing] = [Bearing::Pairs, Bearing::Adhesion, Bearing::Nothing].map(gap);
    assert!(pairs.abs() < 0.15, "{pairs}");
    assert!(nothing > pairs + 0.1, "{nothing} after {pairs}");
    assert!(adhesion > nothing, "{adhesion} after {nothing}");
}
