//! Motions that have an exact solution: free fall, drag, rigid motion, a flow
//! seen from a moving frame.

use std::f64::consts::TAU;

use meniscus::physics::continuity::Continuity;
use meniscus::physics::summation::Summation;
use meniscus::rates::{Dimension, Space};
use meniscus::scheme::{BodyForce, TimeStep};
use meniscus::{Domain, Particle, Particles, Setup, Simulation, Vector, reference};

use crate::common::{fluid, free_drop, noise, periodic_box, scheme};

/// One particle alone.
fn lone<const D: usize>(velocity: Vector<f64, D>, dt: f64) -> Setup<D> {
    let mut scheme = scheme(1.0);
    scheme.time_step = TimeStep::Fixed(dt);
    Setup {
        scheme,
        fluids: vec![fluid(0.0, 0.0)],
        particles: vec![Particle {
            position: Vector::ZERO,
            velocity,
            mass: 1.0,
            fluid: 0,
            body: 0,
        }],
        spacing: 1.0,
        domain: Domain::default(),
    }
}

fn march<const D: usize>(simulation: &mut Simulation<D>, steps: u32) {
    for _ in 0..steps {
        simulation.step().expect("the flow is calm");
    }
}

/// Height and velocity of a particle that was at rest at zero, at t = 1.
fn fall(force: BodyForce, steps: u32) -> (f64, f64) {
    let mut setup = lone::<2>(Vector::ZERO, 1.0 / f64::from(steps));
    setup.scheme.body_force = Some(force);
    let mut simulation = Simulation::new(setup).expect("a sound setup");
    march(&mut simulation, steps);
    let p = simulation.particles();
    (p.position[0][1], p.velocity[0][1])
}

#[test]
fn free_fall_is_exact_for_any_step() {
    for steps in [1, 3, 100] {
        let (y, v) = fall(BodyForce::Constant([0.0, -9.81, 0.0]), steps);
        // A few rounding errors per step.
        let tolerance = 9.81 * 1e-15 * f64::from(steps);
        assert!((y + 0.5 * 9.81).abs() <= tolerance, "{steps} steps: {y}");
        assert!((v + 9.81).abs() <= tolerance, "{steps} steps: {v}");
    }
}

#[test]
fn an_oscillating_body_force_is_followed_to_second_order() {
    // a = 2 + 3 sin(w t + phase), integrated twice.
    let (frequency, phase) = (0.7, 0.4_f64);
    let w = TAU * frequency;
    let v = 2.0 + 3.0 / w * (phase.cos() - (w + phase).cos());
    let y = 1.0 + 3.0 / w * phase.cos() - 3.0 / (w * w) * ((w + phase).sin() - phase.sin());
    let error = |steps| {
        let found = fall(
            BodyForce::Oscillating {
                mean: [0.0, 2.0, 0.0],
                amplitude: [0.0, 3.0, 0.0],
                frequency,
                phase,
            },
            steps,
        );
        ((found.0 - y).abs(), (found.1 - v).abs())
    };
    let (coarse, fine) = (error(10), error(20));
    // The next order is (w dt)^2 / 20 = 1 % of the error.
    assert!(
        (coarse.0 / fine.0 - 4.0).abs() < 0.08,
        "{coarse:?} {fine:?}"
    );
    assert!(
        (coarse.1 / fine.1 - 4.0).abs() < 0.08,
        "{coarse:?} {fine:?}"
    );
    assert!(fine.0 < 0.01 && fine.1 < 0.01, "{fine:?}");
}

#[test]
fn a_tabulated_body_force_is_straight_between_its_rows() {
    // Trapezia, each corner on a step: velocity is the area, exactly.
    let rows = vec![
        (-1.0, [0.0; 3]),
        (0.25, [0.0, 5.0, 0.0]),
        (0.75, [0.0, -1.0, 0.0]),
    ];
    let (_, v) = fall(BodyForce::Table(rows), 40);
    let area = 0.25 * (4.0 + 5.0) / 2.0 + 0.5 * (5.0 - 1.0) / 2.0 - 0.25;
    assert!((v - area).abs() < 1e-13, "{v}, expected {area}");
}

#[test]
fn drag_slows_a_free_particle_exactly() {
    for dt in [1e-3, 0.1, 3.0] {
        let mut setup = lone::<3>(Vector([1.0, -2.0, 0.5]), dt);
        setup.scheme.damping = 0.8;
        let mut simulation = Simulation::new(setup).expect("a sound setup");
        march(&mut simulation, 20);
        let expected = Vector([1.0, -2.0, 0.5]) * (-0.8 * 20.0 * dt).exp();
        let error = (simulation.particles().velocity[0] - expected).norm();
        // Forty factors, each rounded, of exponents that are rounded.
        assert!(error < 1e-13 * expected.norm(), "dt = {dt}: {error:e}");
    }
}

/// Gives a drop the velocity 3 along x, -7 along y, and a turn about z.
fn spin<const D: usize>(setup: &mut Setup<D>, omega: f64) {
    for particle in &mut setup.particles {
        let x = particle.position;
        particle.velocity[0] = 3.0 - omega * x[1];
        particle.velocity[1] = -7.0 + omega * x[0];
    }
}

fn is_not_compressed<const D: usize>()
where
    Space: Dimension<D>,
{
    let mut setup = free_drop::<D>(0.125, 0.2);
    spin(&mut setup, 2.0);
    let scheme = setup.scheme.clone();
    let simulation = Simulation::new(setup).expect("a sound setup");
    let rates = reference::sums(
        &Continuity,
        scheme.kernel,
        scheme.smoothing_length,
        &Domain::default(),
        simulation.particles(),
    );
    let largest = rates.iter().fold(0.0, |a: f64, rate| a.max(rate.abs()));
    // (omega x r) . r vanishes pair by pair; rounding of velocities of 8 over h is left.
    assert!(largest < 1e-13 * 8.0 / 0.25, "{D}D: {largest:e}");
}

#[test]
fn a_rigid_motion_changes_no_density() {
    is_not_compressed::<2>();
    is_not_compressed::<3>();
}

/// A flow v = x thins the liquid at a rate of D per second, at particles of any
/// volume: here half of them are three times as large as the others.
#[test]
fn a_dilation_thins_particles_of_any_volume_alike() {
    let mut setup = free_drop::<2>(0.08, 0.0);
    for particle in &mut setup.particles {
        particle.velocity = particle.position;
        let cells: f64 = particle.position.0.iter().map(|x| (x / 0.08).floor()).sum();
        particle.mass *= if cells.rem_euclid(2.0) == 0.0 {
            1.5
        } else {
            0.5
        };
    }
    let h = setup.scheme.smoothing_length;
    let mut particles = Particles::new(&setup.particles);
    particles.density.fill(1.0);
    for i in (0..particles.len()).filter(|&i| particles.position[i].norm() < 0.4) {
        let rate = reference::sum(
            &Continuity,
            setup.scheme.kernel,
            h,
            &setup.domain,
            &particles,
            i,
        );
        // The kernel's mean over a chequered board is one to half a per cent.
        assert!((rate + 2.0).abs() < 0.02, "{rate}");
    }
}

/// The density that is marched stays that of the particles, which summation
/// shows; were it advanced by places at the end of a step, a drop that turns at
/// omega would lose omega^2 dt of it per second.
#[test]
fn a_turning_drop_keeps_its_density() {
    let (omega, dt) = (1.0, 1e-3);
    let mut setup = free_drop::<2>(0.1, 0.0);
    setup.particles.retain(|p| p.position.norm() < 1.0);
    setup.scheme.surface_tension = None;
    setup.scheme.time_step = TimeStep::Fixed(dt);
    spin(&mut setup, omega);
    // Mean over the core, whose kernels stay full.
    let core: Vec<bool> = (setup.particles.iter())
        .map(|p| p.position.norm() < 0.5)
        .collect();
    let scheme = setup.scheme.clone();
    let mut simulation = Simulation::new(setup).expect("a sound setup");
    let excess = |simulation: &Simulation<2>| {
        let p = simulation.particles();
        let sums: Vec<f64> = reference::sums(
            &Summation,
            scheme.kernel,
            scheme.smoothing_length,
            &Domain::default(),
            p,
        );
        let inner = || (0..p.len()).filter(|&i| core[p.id[i] as usize]);
        inner().map(|i| p.density[i] - sums[i]).sum::<f64>() / inner().count() as f64
    };
    let start = excess(&simulation);
    march(&mut simulation, 1000);
    let drift = excess(&simulation) - start;
    assert!(drift.abs() < 0.05 * omega * omega * dt, "{drift:e}");
}

#[test]
fn a_flow_is_the_same_from_a_moving_frame() {
    let run = |boost: Vector<f64, 2>| {
        let vortices = |x: Vector<f64, 2>| Vector([(TAU * x[1]).sin(), (TAU * x[0]).sin()]);
        let mut setup = periodic_box::<2>(24, vortices, fluid(0.01, 0.0));
        for (k, particle) in (0..).zip(&mut setup.particles) {
            particle.velocity += boost;
            for d in 0..2 {
                particle.position[d] += 0.2 * setup.spacing * noise(2 * k + d as i64);
            }
        }
        setup.scheme.artificial_viscosity = 0.1;
        // An adaptive step would see the speed.
        setup.scheme.time_step = TimeStep::Fixed(1e-3);
        let mut simulation = Simulation::new(setup).expect("a sound setup");
        march(&mut simulation, 100);
        let p = simulation.particles();
        let mut flow = vec![(Vector::ZERO, 0.0); p.len()];
        for i in 0..p.len() {
            flow[p.id[i] as usize] = (p.velocity[i] - boost, p.density[i]);
        }
        flow
    };
    // Particles cross the periodic faces, up to a third of the box in each direction.
    let rest = run(Vector::ZERO);
    let moving = run(Vector([3.1, -2.3]));
    for (a, b) in rest.iter().zip(&moving) {
        // A thousand rounding errors of velocities of 4.
        assert!(
            (a.0 - b.0).norm() < 1e-12 && (a.1 - b.1).abs() < 1e-12,
            "{a:?} {b:?}"
        );
    }
}
