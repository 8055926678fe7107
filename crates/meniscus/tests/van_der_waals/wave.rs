//! Plane waves in a periodic box, against the equations they solve.
//!
//! A gradient by the kernel is that of a wave times w = 1 - k^2 <x^2> / 2, with <x^2> the kernel's
//! second moment: 0.0893 h^2 for Lucy's in two dimensions. A rate by two gradients has w^2;
//! that by Brookshaw's pairs 1 - k^2 <x^2> / 4. What is left out is (k h)^4 / 800 < 1e-3, and the
//! lattice's sum in place of an integral. The fluid is cold and nearly at 1/b, where its pressure is small
//! against rho c^2: a lattice under pressure resists shear like a solid, by some per cent of it.

use std::f64::consts::TAU;

use meniscus::measure::DampedCosine;
use meniscus::scheme::{Conduction, Scheme, Substance, TimeStep, VanDerWaals};
use meniscus::{Fluid, Setup, Simulation, Vector};

use crate::common::periodic_lattice;

const N: usize = 32;
const K: f64 = TAU;
/// The smoothing length, of 3.5 spacings.
const H: f64 = 3.5 / N as f64;
/// k^2 <x^2>
const SMOOTHING: f64 = K * K * 0.0893 * H * H;

/// A strip a wavelength long, of density near 1 and without cohesion, b = 0.9.
fn strip(
    velocity: impl Fn(Vector<f64, 2>) -> Vector<f64, 2>,
    change: impl Fn(&mut VanDerWaals, &mut Fluid),
) -> Setup<2> {
    let substance = Substance {
        gas_constant: 1.0,
        cohesion: 0.0,
        excluded_volume: 0.9,
        degrees_of_freedom: 3.0,
    };
    let mut model = VanDerWaals::new(substance, 0.05);
    let mut fluid = Fluid::new("fluid", 1.0);
    change(&mut model, &mut fluid);
    let spacing = 1.0 / N as f64;
    let mut setup = periodic_lattice([N, 10], spacing, velocity, fluid);
    setup.scheme = Scheme::van_der_waals(H, model);
    setup
}

/// The amplitude of cos(k x) in a column.
fn amplitude(simulation: &Simulation<2>, of: impl Fn(usize) -> f64) -> f64 {
    let p = simulation.particles();
    let sum: f64 = (0..p.len())
        .map(|i| of(i) * (K * p.position[i][0]).cos())
        .sum();
    2.0 * sum / p.len() as f64
}

/// Rate of decay of a wave of temperature over that of the heat equation.
fn decay_of_heat(conduction: Conduction) -> f64 {
    // So fast that pressure, of which sound would carry the heat away, has no time.
    let conductivity = 100.0;
    let mut setup = strip(
        |_| Vector::ZERO,
        |model, _| {
            model.conductivity = conductivity;
            model.conduction = conduction;
        },
    );
    let rate = conductivity * K * K / 1.5;
    setup.scheme.time_step = TimeStep::Fixed(0.01 / rate);
    let mut snapshot = (Simulation::new(setup.clone()).expect("a sound setup")).snapshot();
    for (i, temperature) in snapshot.temperature.iter_mut().enumerate() {
        *temperature += 1e-4 * (K * snapshot.position[2 * i]).cos();
    }
    let mut simulation = Simulation::restore(setup, &snapshot).expect("the same particles");
    let read = |simulation: &Simulation<2>| {
        let wave = amplitude(simulation, |i| simulation.particles().temperature[i]);
        (simulation.time(), wave)
    };
    // The snapshot has no rates of heat: a step to find them.
    simulation.step().expect("calm");
    let first = read(&simulation);
    simulation.advance_to(1.0 / rate).expect("calm");
    let last = read(&simulation);
    let density = simulation.particles().density[0];
    (first.1 / last.1).ln() / (last.0 - first.0) / (rate / density)
}

#[test]
fn a_wave_of_temperature_decays_as_heat_is_conducted() {
    // Forward differences of a rate of 0.01 a step: its square.
    for (conduction, expected) in [
        (Conduction::Brookshaw, 1.0 - SMOOTHING / 4.0),
        (Conduction::DoubleSum, (1.0 - SMOOTHING / 2.0).powi(2)),
    ] {
        let found = decay_of_heat(conduction);
        assert!(
            (found / expected - 1.0).abs() < 0.01,
            "{conduction:?}: {found}, expected {expected}"
        );
    }
}

#[test]
fn a_shear_wave_decays_by_the_viscosity() {
    let speed = 1e-4;
    let mut setup = strip(
        |x| Vector([0.0, speed * (K * x[0]).cos()]),
        |_, fluid| fluid.viscosity = 0.5,
    );
    setup.scheme.time_step = TimeStep::Fixed(2e-4);
    let mut simulation = Simulation::new(setup).expect("a sound setup");
    simulation.advance_to(0.05).expect("calm");
    let left = amplitude(&simulation, |i| simulation.particles().velocity[i][1]) / speed;
    let density = simulation.particles().density[0];
    let found = -left.ln() / simulation.time() / (0.5 * K * K / density);
    let expected = (1.0 - SMOOTHING / 2.0_f64).powi(2);
    assert!(
        (found / expected - 1.0).abs() < 0.01,
        "{found}, expected {expected}"
    );
}

#[test]
fn sound_is_as_fast_and_as_damped_as_the_fluid_says() {
    let mut setup = strip(
        |x| Vector([1e-4 * (K * x[0]).cos(), 0.0]),
        |model, fluid| {
            model.bulk_viscosity = 0.05;
            fluid.viscosity = 0.02;
        },
    );
    setup.scheme.time_step = TimeStep::Fixed(1e-3);
    let mut simulation = Simulation::new(setup).expect("a sound setup");
    let (mut times, mut waves) = (Vec::new(), Vec::new());
    while simulation.time() < 2.0 {
        simulation.step().expect("calm");
        times.push(simulation.time());
        waves.push(amplitude(&simulation, |i| {
            simulation.particles().velocity[i][0]
        }));
    }
    let fit = DampedCosine::fit(&times, &waves).expect("a damped cosine");
    let p = simulation.particles();
    let substance = simulation.van_der_waals().expect("set").model().substance;
    let density = p.density[0];
    let smoothing = 1.0 - SMOOTHING / 2.0;
    let (sound, rest) = (
        substance.sound_speed(density, p.temperature[0]),
        substance.pressure(density, p.temperature[0]) / density,
    );
    // The pressure at rest pushes by the gradient of the kernel alone, smoothed once.
    let stiffness = (sound * smoothing).powi(2) + 2.0 * rest * smoothing * (1.0 - smoothing);
    let frequency = K * stiffness.sqrt();
    // zeta + (2 - 2/D) eta, half of it since half the energy is that of pressure.
    let damping = 0.5 * 0.07 * (K * smoothing).powi(2) / density;
    let omega = (frequency * frequency - damping * damping).sqrt();
    let found = (TAU / fit.period().value, fit.damping_rate.value);
    assert!(
        (found.0 / omega - 1.0).abs() < 5e-3 && (found.1 / damping - 1.0).abs() < 0.01,
        "{found:?}, expected {omega}, {damping}"
    );
}
