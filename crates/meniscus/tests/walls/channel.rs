//! Flows along the walls of a channel, against their exact profiles.

use std::f64::consts::PI;

use meniscus::measure::{compression_energy, kinetic_energy};
use meniscus::scheme::{BodyForce, Motion, PressureForm, Scheme, Slip, ViscosityForm, Wall};
use meniscus::{Fluid, Simulation, Vector};

use crate::setups::channel;

const VISCOSITY: f64 = 0.1;

fn liquid() -> Fluid {
    let mut liquid = Fluid::new("liquid", 1.0);
    liquid.viscosity = VISCOSITY;
    liquid
}

fn scheme(spacing: f64) -> Scheme {
    let mut scheme = Scheme::new(2.0 * spacing);
    scheme.artificial_viscosity = 0.0;
    scheme.pressure = PressureForm::OverDensityProduct;
    scheme.viscosity = ViscosityForm::Morris;
    scheme
}

fn moving(body: u16, velocity: f64) -> Wall {
    let mut wall = Wall::new(body);
    wall.motion = Motion::Translation {
        velocity: [velocity, 0.0, 0.0],
    };
    wall
}

/// Root mean square difference of the velocity along the channel from `exact`, over `scale`.
fn error(simulation: &Simulation<2>, exact: impl Fn(f64) -> f64, scale: f64) -> f64 {
    let p = simulation.particles();
    let squares: Vec<f64> = (0..p.len())
        .filter(|&i| !simulation.is_wall(p.body[i]))
        .map(|i| (p.velocity[i][0] - exact(p.position[i][1])).powi(2))
        .collect();
    (squares.iter().sum::<f64>() / squares.len() as f64).sqrt() / scale
}

/// Couette's flow on its way: Morris, Fox and Zhu (1997), eq. 20, walls at rest and at 0.5.
fn couette(spacing: f64) -> (f64, f64) {
    let walls = [Wall::new(1), moving(2, 0.5)];
    let setup = channel(12, spacing, scheme(spacing), liquid(), walls);
    let mut simulation = Simulation::new(setup).unwrap();
    simulation.advance_to(1.0).unwrap();
    let t = simulation.time();
    let exact = |y: f64| {
        let waves = (1..40).map(f64::from).map(|n| {
            let sign = if n % 2.0 == 0.0 { 1.0 } else { -1.0 };
            sign / n * (n * PI * y).sin() * (-VISCOSITY * (n * PI).powi(2) * t).exp()
        });
        0.5 * (y + 2.0 / PI * waves.sum::<f64>())
    };
    // Drag on the moving wall: -mu du/dy at y = 1.
    let slope: f64 = (1..40)
        .map(f64::from)
        .map(|n| (-VISCOSITY * (n * PI).powi(2) * t).exp())
        .sum();
    let length = 12.0 * spacing;
    let drag = -VISCOSITY * 0.5 * (1.0 + 2.0 * slope) * length;
    let load = simulation.wall_loads()[1].force[0];
    (error(&simulation, exact, 0.5), load / drag - 1.0)
}

/// Poiseuille's flow on its way, with 0.5 in the middle at the end of all time.
fn poiseuille(spacing: f64) -> f64 {
    let force = 8.0 * VISCOSITY * 0.5;
    let mut scheme = scheme(spacing);
    scheme.body_force = Some(BodyForce::Constant([force, 0.0, 0.0]));
    let setup = channel(12, spacing, scheme, liquid(), [Wall::new(1), Wall::new(2)]);
    let mut simulation = Simulation::new(setup).unwrap();
    simulation.advance_to(1.0).unwrap();
    let t = simulation.time();
    let exact = |y: f64| {
        let waves = (0..40).map(|n| 2.0 * f64::from(n) + 1.0).map(|n| {
            4.0 * force / (VISCOSITY * (PI * n).powi(3))
                * (PI * n * y).sin()
                * (-VISCOSITY * (n * PI).powi(2) * t).exp()
        });
        force / (2.0 * VISCOSITY) * y * (1.0 - y) - waves.sum::<f64>()
    };
    error(&simulation, exact, 0.5)
}

#[test]
fn couette_and_poiseuille_converge_to_the_exact_profiles() {
    for (name, coarse, fine) in [
        ("couette", couette(0.1).0, couette(0.05).0),
        ("poiseuille", poiseuille(0.1), poiseuille(0.05)),
    ] {
        let order = (coarse / fine).log2();
        assert!(fine < 0.01 && order > 1.0, "{name}: {coarse} then {fine}");
    }
}

#[test]
fn drag_on_a_moving_wall_is_viscosity_times_shear() {
    let drag = couette(0.05).1;
    assert!(drag.abs() < 0.02, "{drag}");
}

/// Share of its momentum that a plug flow loses over three channel heights.
fn loss(slip: Slip, alpha: f64, form: ViscosityForm) -> f64 {
    let spacing = 0.1;
    let mut scheme = scheme(spacing);
    scheme.artificial_viscosity = alpha;
    scheme.viscosity = form;
    let wall = |body| Wall {
        slip,
        ..Wall::new(body)
    };
    let mut setup = channel(12, spacing, scheme, liquid(), [wall(1), wall(2)]);
    for particle in setup.particles.iter_mut().filter(|p| p.body == 0) {
        particle.velocity = Vector([0.5, 0.0]);
    }
    let mut simulation = Simulation::new(setup).unwrap();
    simulation.advance_to(6.0).unwrap();
    error(&simulation, |_| 0.5, 0.5)
}

#[test]
fn a_wall_with_free_slip_exerts_no_shear() {
    for form in [
        ViscosityForm::Morris,
        ViscosityForm::MonaghanCleary,
        ViscosityForm::Stress,
    ] {
        let free = loss(Slip::FreeSlip, 0.1, form);
        let stuck = loss(Slip::NoSlip, 0.1, form);
        assert!(free < 0.01 && stuck > 0.5, "{form:?}: {free} and {stuck}");
    }
}

#[test]
fn a_sound_wave_between_walls_keeps_its_energy() {
    let mut liquid = liquid();
    liquid.viscosity = 0.0;
    // More than the wave's own pressure rho c v: the walls are pressed on at all times.
    liquid.background_pressure = 4.0;
    let walls = [Wall::new(1), Wall::new(2)];
    let mut setup = channel(12, 0.05, scheme(0.05), liquid.clone(), walls);
    for particle in setup.particles.iter_mut().filter(|p| p.body == 0) {
        particle.velocity[1] = 0.2 * (PI * particle.position[1]).sin();
    }
    let mut simulation = Simulation::new(setup).unwrap();
    let energy = |simulation: &Simulation<2>| {
        let p = simulation.particles().of_bodies(|body| body == 0);
        kinetic_energy(&p.velocity, &p.mass) + compression_energy(&p.mass, &p.density, &liquid)
    };
    let start = energy(&simulation);
    // Six times to and fro.
    simulation.advance_to(1.2).unwrap();
    let gain = energy(&simulation) / start - 1.0;
    // Nothing dissipates; steps of finite length leave less than a thousandth.
    assert!(gain.abs() < 1e-3, "{gain}");
}

#[test]
fn what_blows_up_beside_a_wall_with_free_slip_is_not_blamed_on_friction() {
    let spacing = 0.1;
    let mut scheme = scheme(spacing);
    scheme.viscosity = ViscosityForm::MonaghanCleary;
    let wall = |body, velocity| Wall {
        slip: Slip::FreeSlip,
        motion: Motion::Translation { velocity },
        ..Wall::new(body)
    };
    // A piston at the speed of sound, on a liquid that flies along it: friction, if there
    // were any, would be viscosity times 1e4 / h^2 = 1e5 m/s^2 and more.
    let walls = [wall(1, [0.0; 3]), wall(2, [0.0, -10.0, 0.0])];
    let mut setup = channel(12, spacing, scheme, liquid(), walls);
    for particle in setup.particles.iter_mut().filter(|p| p.body == 0) {
        particle.velocity = Vector([1e4, 0.0]);
    }
    let mut simulation = Simulation::new(setup).unwrap();
    let diverged = simulation.advance_to(1.0).unwrap_err();
    assert_eq!(diverged.culprit.term, "the pressure gradient", "{diverged}");
}
