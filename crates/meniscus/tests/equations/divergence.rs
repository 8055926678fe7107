//! Runs that blow up end with a value that says where, by what, and what to
//! change; nothing panics.

use std::f64::consts::TAU;

use meniscus::divergence::{Diverged, Failure};
use meniscus::fluid::Fluid;
use meniscus::pairs::Pairs;
use meniscus::rates::{Dimension, Force, Space};
use meniscus::scheme::{BodyForce, DensityForm, TimeStep, ViscosityForm};
use meniscus::{Domain, Kernel, Particles, Setup, Simulation, Vector};

use crate::common::{fluid, free_drop, periodic_box};

/// Vortices of 16 particles to the side, h = 1/8.
fn vortices(speed: f64, fluid: Fluid) -> Setup<2> {
    let velocity = |x: Vector<f64, 2>| {
        let [x, y] = x.0.map(|x| TAU * x);
        Vector([x.sin() * y.cos(), -x.cos() * y.sin()]) * speed
    };
    periodic_box(16, velocity, fluid)
}

fn run<const D: usize>(mut simulation: Simulation<D>) -> Diverged {
    for _ in 0..1000 {
        if let Err(diverged) = simulation.step() {
            return diverged;
        }
    }
    panic!("a calm flow where disaster was meant");
}

/// Runs to the disaster, and looks whether it is told in full.
fn blow_up<const D: usize>(setup: Setup<D>) -> Diverged
where
    Space: Dimension<D>,
{
    let particles = setup.particles.len();
    let diverged = run(Simulation::new(setup).expect("a sound setup"));
    assert!((diverged.particle as usize) < particles);
    assert!(diverged.step > 0 && diverged.time > 0.0);
    assert!(diverged.culprit.acceleration > 0.0);
    let text = diverged.to_string();
    for part in [
        format!("step {}", diverged.step),
        format!("particle {}", diverged.particle),
        diverged.culprit.term.to_owned(),
    ] {
        assert!(text.contains(&part), "{part:?} is missing in {text:?}");
    }
    assert!(diverged.advice().iter().all(|advice| advice.len() > 20));
    diverged
}

fn advises(diverged: &Diverged, word: &str) -> bool {
    diverged.advice()[0].contains(word)
}

#[test]
fn sound_slower_than_the_flow() {
    let diverged = blow_up(vortices(100.0, fluid(0.0, 0.0)));
    assert!(
        matches!(diverged.failure, Failure::Density(_)),
        "{diverged}"
    );
    assert_eq!(diverged.culprit.term, "the pressure gradient");
    assert!(advises(&diverged, "sound_speed"));
}

#[test]
fn a_step_of_twenty_times_the_acoustic_limit() {
    let mut setup = vortices(1.0, fluid(0.0, 0.0));
    setup.scheme.time_step = TimeStep::Fixed(0.05);
    let diverged = blow_up(setup);
    assert!(
        matches!(diverged.failure, Failure::Density(_)),
        "{diverged}"
    );
    assert!(
        diverged
            .advice()
            .iter()
            .any(|advice| advice.contains("time step"))
    );
}

#[test]
fn a_step_beyond_the_viscous_limit() {
    for form in [ViscosityForm::Morris, ViscosityForm::MonaghanCleary] {
        let mut setup = vortices(0.1, fluid(20.0, 0.0));
        setup.scheme.viscosity = form;
        // Twenty times the viscous limit; so soft a liquid that even one squeezed
        // beyond all bounds has little pressure.
        setup.scheme.time_step = TimeStep::Fixed(0.002);
        setup.fluids[0].sound_speed = 0.1;
        let diverged = blow_up(setup);
        assert_eq!(diverged.culprit.term, "laminar viscosity", "{form:?}");
        assert!(advises(&diverged, "time step"));
    }
}

/// So soft a liquid that it can not hold its own surface tension.
fn is_crushed<const D: usize>(spacing: f64)
where
    Space: Dimension<D>,
{
    let mut setup = free_drop::<D>(spacing, 0.1);
    setup.fluids[0].sound_speed = 0.1;
    setup.fluids[0].surface_tension = 1e4;
    let diverged = blow_up(setup);
    assert_eq!(diverged.culprit.term, "surface tension", "{D}D");
}

#[test]
fn surface_tension_far_beyond_the_speed_of_sound() {
    is_crushed::<2>(0.1);
    is_crushed::<3>(0.2);
}

#[test]
fn bodies_that_overlap() {
    let mut setup = free_drop::<2>(0.1, 0.0);
    setup.scheme.density = DensityForm::Summation;
    let mut twin = setup.particles.clone();
    for particle in &mut twin {
        particle.position[0] += 0.01;
    }
    setup.particles.extend(twin);
    let diverged = blow_up(setup);
    assert!(
        diverged
            .advice()
            .iter()
            .any(|advice| advice.contains("overlap"))
    );
}

#[test]
fn a_body_force_that_leaves_no_time_step() {
    let mut setup = vortices(0.1, fluid(0.0, 0.0));
    setup.scheme.body_force = Some(BodyForce::Constant([0.0, 1e12, 0.0]));
    let diverged = blow_up(setup);
    assert!(
        matches!(diverged.failure, Failure::StepCollapsed { .. }),
        "{diverged}"
    );
    assert_eq!(diverged.culprit.term, "the body force");
}

/// Pulls one particle with a force that is not a number.
struct Flaw;

impl Force<2> for Flaw {
    fn accelerate(
        &mut self,
        _: &mut Pairs<2>,
        particles: &Particles<2>,
        acceleration: &mut [Vector<f64, 2>],
    ) {
        let row = particles
            .id
            .iter()
            .position(|&id| id == 7)
            .expect("it is there");
        acceleration[row][0] = f64::NAN;
    }
}

#[test]
fn a_force_that_is_not_a_number() {
    let setup = vortices(0.1, fluid(0.1, 0.0));
    let mut simulation = Simulation::new(setup).expect("a sound setup");
    simulation.add_other_force(Box::new(Flaw));
    let diverged = run(simulation);
    assert_eq!((diverged.step, diverged.particle), (1, 7));
    assert_eq!(diverged.failure, Failure::NotFinite);
    assert_eq!(diverged.culprit.term, "a force of your own");
}

#[test]
fn an_impossible_start_is_refused() {
    let refused = |spoil: &dyn Fn(&mut Setup<2>)| {
        let mut setup = vortices(0.1, fluid(0.1, 0.0));
        spoil(&mut setup);
        let error = Simulation::new(setup).err().expect("it must be refused");
        assert!(error.to_string().len() > 10);
    };
    for bad in [f64::NAN, f64::INFINITY] {
        refused(&|setup| setup.particles[3].position[1] = bad);
        refused(&|setup| setup.particles[3].velocity[0] = bad);
        refused(&|setup| setup.particles[3].mass = bad);
        refused(&|setup| setup.scheme.smoothing_length = bad);
        refused(&|setup| setup.scheme.damping = bad);
        refused(&|setup| setup.scheme.artificial_viscosity = bad);
        refused(&|setup| setup.scheme.time_step = TimeStep::Fixed(bad));
        refused(&|setup| setup.scheme.body_force = Some(BodyForce::Constant([bad; 3])));
        refused(&|setup| setup.fluids[0].viscosity = bad);
        refused(&|setup| setup.fluids[0].surface_tension = bad);
        refused(&|setup| setup.fluids[0].background_pressure = bad);
    }
    let falling = BodyForce::Table(vec![(1.0, [0.0; 3]), (0.0, [1.0; 3])]);
    refused(&|setup| setup.scheme.body_force = Some(falling.clone()));
    refused(&|setup| setup.particles[3].fluid = 1);
    refused(&|setup| setup.particles[3].mass = 0.0);
    refused(&|setup| setup.fluids.clear());
}

fn march_few<const D: usize>()
where
    Space: Dimension<D>,
{
    for n in 0..3 {
        let mut setup = free_drop::<D>(0.2, 0.1);
        setup.particles.truncate(n);
        setup.fluids[0].viscosity = 0.1;
        let mut simulation = Simulation::new(setup).expect("a sound setup");
        for _ in 0..20 {
            simulation.step().expect("nothing can go wrong");
        }
        assert_eq!(simulation.particles().len(), n);
        assert_eq!(simulation.steps(), 20);
    }
}

#[test]
fn no_particle_one_and_two_march() {
    march_few::<2>();
    march_few::<3>();
}

fn sort_nowhere<const D: usize>() {
    let mut particles = Particles::<D>::new(&free_drop(0.3, 0.0).particles);
    let mut pairs = Pairs::new(Kernel::WendlandC2, 0.6, 0.3, 0.1, Domain::default());
    for bad in [f64::NAN, f64::INFINITY] {
        particles.position.fill(Vector([bad; D]));
        pairs.rebuild(&mut particles);
        assert!(pairs.is_stale(&particles));
    }
}

#[test]
fn particles_that_are_nowhere_are_sorted_all_the_same() {
    sort_nowhere::<2>();
    sort_nowhere::<3>();
}
