//! The march of a flow with walls: the same bits however it is run.

use meniscus::measure::angular_momentum;
use meniscus::physics::wall::layout::Side;
use meniscus::scheme::{Motion, PressureForm, Scheme, Wall};
use meniscus::shape::{Arrangement, Pattern, Shape};
use meniscus::{Domain, Fluid, Setup, Simulation, Vector};

use crate::budget::shaken;
use crate::setups::{layers, wall_particles};

#[test]
fn a_flow_with_walls_is_the_same_on_any_number_of_threads_and_after_a_resume() {
    let mut snapshots = Vec::new();
    for threads in [1, 2] {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        snapshots.push(pool.install(|| {
            let mut simulation = Simulation::<2>::new(shaken(PressureForm::HuAdams)).unwrap();
            for _ in 0..150 {
                simulation.step().unwrap();
            }
            simulation.snapshot()
        }));
    }
    assert_eq!(snapshots[0], snapshots[1]);

    let mut simulation = Simulation::<2>::new(shaken(PressureForm::HuAdams)).unwrap();
    for _ in 0..77 {
        simulation.step().unwrap();
    }
    let snapshot = simulation.snapshot();
    let mut simulation =
        Simulation::<2>::restore(shaken(PressureForm::HuAdams), &snapshot).unwrap();
    for _ in 77..150 {
        simulation.step().unwrap();
    }
    assert_eq!(simulation.snapshot(), snapshots[0]);
}

#[test]
fn walls_move_as_they_are_told_and_rest_where_they_are() {
    let mut setup = shaken::<2>(PressureForm::OverDensityProduct);
    // Neither XSPH nor the drag moves them.
    setup.scheme.velocity_smoothing = 0.3;
    setup.scheme.damping = 5.0;
    setup.scheme.walls[1].motion = Motion::Rest;
    let start = setup.particles.clone();
    let mut simulation = Simulation::new(setup.clone()).unwrap();
    simulation.advance_to(0.3).unwrap();
    let (p, t) = (simulation.particles(), simulation.time());
    for i in (0..p.len()).filter(|&i| simulation.is_wall(p.body[i])) {
        let wall = setup
            .scheme
            .walls
            .iter()
            .find(|wall| wall.body == p.body[i])
            .unwrap();
        let exact = wall.motion.at(start[p.id[i] as usize].position, t);
        assert_eq!(p.position[i], exact.position);
        // A kick away from its own velocity, and back.
        assert!((p.velocity[i] - exact.velocity).norm() < 1e-12);
    }
}

#[test]
fn a_turning_vessel_takes_its_liquid_along() {
    // Solid rotation in a round vessel full of liquid is steady; its pressure rises by
    // rho omega^2 r^2 / 2 from the middle, and nothing slides.
    let (spacing, radius, omega) = (0.05, 0.525, 1.0);
    let mut liquid = Fluid::new("liquid", 1.0);
    liquid.viscosity = 0.01;
    liquid.background_pressure = 1.0;
    let mut scheme = Scheme::new(2.0 * spacing);
    scheme.pressure = PressureForm::OverDensityProduct;
    let origin = Vector([0.0, 0.0]);
    let disc = Shape::Ball {
        centre: origin,
        radius,
    };
    let rings = Arrangement::new(Pattern::Concentric, spacing);
    let mut particles = rings.body(&disc, 1.0, 10_000).unwrap();
    let vessel = layers(&scheme, spacing)
        .ball(origin, radius, Side::Outside)
        .unwrap();
    particles.extend(wall_particles(vessel, 1, 1.0, spacing));
    let motion = Motion::Rotation {
        centre: [0.0; 3],
        angular_velocity: [0.0, 0.0, omega],
    };
    for particle in &mut particles {
        particle.velocity = motion.at(particle.position, 0.0).velocity;
    }
    let mut wall = Wall::new(1);
    wall.motion = motion.clone();
    scheme.walls = vec![wall];
    let mut simulation = Simulation::new(Setup {
        scheme,
        fluids: vec![liquid],
        particles,
        spacing,
        domain: Domain::default(),
    })
    .unwrap();
    simulation.advance_to(3.0).unwrap();
    let p = simulation.particles().of_bodies(|body| body == 0);
    let mut squares = 0.0;
    let mut solid = p.clone();
    for i in 0..p.len() {
        solid.velocity[i] = motion.at(p.position[i], 0.0).velocity;
        squares += (p.velocity[i] - solid.velocity[i]).norm_squared();
    }
    let slip = (squares / p.len() as f64).sqrt();
    let [spin, rigid] =
        [&p, &solid].map(|p| angular_momentum(&p.position, &p.velocity, &p.mass, origin)[2]);
    assert!(slip < 0.03 * omega * radius, "{slip}");
    assert!((spin / rigid - 1.0).abs() < 0.01, "{spin} for {rigid}");
}
