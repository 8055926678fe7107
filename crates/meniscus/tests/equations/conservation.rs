//! What must not change: momentum, angular momentum, energy.

use meniscus::measure::{angular_momentum, compression_energy, kinetic_energy, linear_momentum};
use meniscus::rates::{Dimension, Space};
use meniscus::scheme::{PressureForm, TimeStep, ViscosityForm};
use meniscus::{Domain, Particle, Setup, Simulation, Vector};

use crate::common::{fluid, noise, scheme, ten_steps};
use crate::wave::{K, strip};

/// A block of two mixed fluids, of density 1 and 3, disordered in place and
/// velocity, in a void.
fn cloud<const D: usize>(n: usize, pressure: PressureForm, viscosity: ViscosityForm) -> Setup<D> {
    let mut fluids = vec![fluid(0.1, 0.0), fluid(0.5, 0.0)];
    fluids[0].background_pressure = 4.0;
    fluids[1].density = 3.0;
    fluids[1].background_pressure = 1.0;
    let spacing = 0.1;
    let particles = (0..n.pow(D as u32))
        .map(|k| {
            let random = |d: usize| noise((2 * D * k + d) as i64);
            let fluid = u16::from(random(0) > 0.0);
            Particle {
                position: Vector(std::array::from_fn(|d| {
                    ((k / n.pow(d as u32) % n) as f64 + 0.3 * random(d)) * spacing
                })),
                velocity: Vector(std::array::from_fn(|d| random(D + d))),
                mass: fluids[fluid as usize].density * spacing.powi(D as i32),
                fluid,
                body: 0,
            }
        })
        .collect();
    let mut scheme = scheme(spacing);
    scheme.pressure = pressure;
    scheme.viscosity = viscosity;
    scheme.artificial_viscosity = 0.2;
    Setup {
        scheme,
        fluids,
        particles,
        spacing,
        domain: Domain::default(),
    }
}

/// The change of momentum and of angular momentum in ten steps, over the sums of
/// the magnitudes that particles exchanged meanwhile.
fn change<const D: usize>(setup: Setup<D>) -> (f64, f64)
where
    Space: Dimension<D>,
{
    let mut simulation = Simulation::new(setup).expect("a sound setup");
    let totals = |simulation: &Simulation<D>| {
        let p = simulation.particles();
        let linear = linear_momentum(&p.velocity, &p.mass);
        let angular = angular_momentum(&p.position, &p.velocity, &p.mass, Vector::ZERO);
        (linear, Vector(angular))
    };
    let before = totals(&simulation);
    let (forces, torques) = ten_steps(&mut simulation);
    let after = totals(&simulation);
    (
        (after.0 - before.0).norm() / forces,
        (after.1 - before.1).norm() / torques,
    )
}

/// Of a thousand particles' sums, each of a hundred rounded terms.
const ROUNDING: f64 = 1e-13;

fn conserves<const D: usize>(n: usize)
where
    Space: Dimension<D>,
{
    for pressure in [
        PressureForm::OverDensitySquared,
        PressureForm::OverDensityProduct,
        PressureForm::HuAdams,
    ] {
        let (linear, angular) = change(cloud::<D>(n, pressure, ViscosityForm::MonaghanCleary));
        assert!(linear < ROUNDING, "{D}D, {pressure:?}: {linear:e}");
        assert!(angular < ROUNDING, "{D}D, {pressure:?}: {angular:e}");
    }
    // Along the velocity difference, so that a pair feels a torque.
    let cloud = cloud::<D>(n, PressureForm::HuAdams, ViscosityForm::Morris);
    let (linear, angular) = change(cloud);
    assert!(linear < ROUNDING, "{D}D, Morris: {linear:e}");
    assert!(angular > 1e6 * ROUNDING, "{D}D, Morris: {angular:e}");
}

#[test]
fn momentum_is_conserved_and_angular_momentum_but_for_morris() {
    conserves::<2>(16);
    conserves::<3>(7);
}

/// A standing wave of a hundredth of the speed of sound, without viscosity, over
/// twenty periods. A leapfrog's energy swings by a part (omega dt)^2 / 4, and
/// gets no further however long it marches.
#[test]
fn a_standing_wave_keeps_its_energy() {
    let n = 24;
    let mut setup = strip::<2>(n, 1, 0.1, fluid(0.0, 0.0));
    let dt = 0.4 / n as f64 / 10.0;
    setup.scheme.time_step = TimeStep::Fixed(dt);
    let mut simulation = Simulation::new(setup).expect("a sound setup");
    let energy = |simulation: &Simulation<2>| {
        let p = simulation.particles();
        kinetic_energy(&p.velocity, &p.mass)
            + compression_energy(&p.mass, &p.density, &simulation.fluids()[0])
    };
    let start = energy(&simulation);
    let swing = (10.0 * K * dt).powi(2) / 4.0;
    while simulation.time() < 2.0 {
        simulation.step().expect("the flow is calm");
        let change = energy(&simulation) / start - 1.0;
        assert!(
            change.abs() < 1.2 * swing,
            "t = {}: {change:e}",
            simulation.time()
        );
    }
}
