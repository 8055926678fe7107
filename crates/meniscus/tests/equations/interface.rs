//! Two fluids side by side: where they meet, forces must be neither fluid's own.

use meniscus::fluid::Fluid;
use meniscus::physics::momentum::{Mixture, Momentum};
use meniscus::rates::{Dimension, Space};
use meniscus::scheme::{PressureForm, ViscosityForm};
use meniscus::{Particles, Setup, Simulation, Vector, reference};

use crate::common::{fluid, periodic_lattice};

/// Two layers of equal volume on a lattice, periodic; x_0 < 1/2 is of a fluid of
/// ten times the density.
fn layers<const D: usize>(n: usize, light: Fluid) -> Setup<D> {
    let heavy = Fluid {
        density: 10.0 * light.density,
        ..light.clone()
    };
    let mut setup = periodic_lattice([n; D], 1.0 / n as f64, |_| Vector::ZERO, light);
    setup.fluids.push(heavy);
    for particle in &mut setup.particles {
        if particle.position[0] < 0.5 {
            particle.fluid = 1;
            particle.mass *= 10.0;
        }
    }
    setup
}

/// How fast layers of equal pressure move after 50 steps.
fn speed<const D: usize>(n: usize, form: PressureForm) -> f64
where
    Space: Dimension<D>,
{
    let light = Fluid {
        background_pressure: 5.0,
        ..fluid(0.0, 0.0)
    };
    let mut setup = layers::<D>(n, light);
    setup.scheme.pressure = form;
    let mut simulation = Simulation::new(setup).expect("a sound setup");
    for _ in 0..50 {
        simulation.step().expect("the flow is calm");
    }
    meniscus::measure::maximum_speed(&simulation.particles().velocity)
}

#[test]
fn layers_of_equal_pressure_stay_at_rest() {
    for form in [PressureForm::HuAdams, PressureForm::OverDensityProduct] {
        // Rounding of forces p / (rho h), over 50 steps of 0.0025 s or less.
        assert!(speed::<2>(16, form) < 1e-12, "2D, {form:?}");
        assert!(speed::<3>(10, form) < 1e-12, "3D, {form:?}");
    }
    // The form that is not made for a jump of density does see one: at the
    // interface p / rho^2 differs a hundredfold.
    assert!(speed::<2>(16, PressureForm::OverDensitySquared) > 0.1);
}

const N: usize = 24;

/// Accelerations along a row of particles across the interface, up to a quarter
/// either side, in layers of `fluids` (the second at x < 0, as dense as the first
/// or ten times) with this pressure, and velocity along the interface.
fn across(
    fluids: &[Fluid; 2],
    term: Momentum<Mixture>,
    pressure: impl Fn(f64) -> f64,
    velocity: impl Fn(f64) -> f64,
) -> Vec<Vector<f64, 2>> {
    let setup = layers::<2>(N, fluids[0].clone());
    let mut particles = Particles::new(&setup.particles);
    let place = |particles: &Particles<2>, i: usize| particles.position[i][0] - 0.5;
    for i in 0..particles.len() {
        let x = place(&particles, i);
        particles.density[i] = fluids[particles.fluid[i] as usize].density;
        particles.mass[i] = particles.density[i] * setup.spacing.powi(2);
        particles.pressure[i] = pressure(x);
        particles.velocity[i][1] = velocity(x);
    }
    (0..N)
        .filter(|&i| place(&particles, i).abs() < 0.25)
        .map(|i| {
            let h = setup.scheme.smoothing_length;
            let term = Momentum {
                material: Mixture(fluids),
                smoothing_length: h,
                ..term
            };
            reference::sum(&term, setup.scheme.kernel, h, &setup.domain, &particles, i)
        })
        .collect()
}

const NOTHING: Momentum<Mixture> = Momentum {
    material: Mixture(&[]),
    pressure: None,
    artificial_viscosity: 0.0,
    viscosity: None,
    smoothing_length: 0.0,
};

#[test]
fn pressure_that_carries_two_fluids_carries_each() {
    let light = fluid(0.0, 0.0);
    let heavy = Fluid {
        density: 10.0,
        ..light.clone()
    };
    let fluids = [light, heavy];
    // Falls as rho along x: every particle should be pushed with 1 m/s^2.
    let pressure = |x: f64| 20.0 - if x < 0.0 { 10.0 * x } else { x };
    let off = |form| {
        let term = Momentum {
            pressure: Some(form),
            ..NOTHING
        };
        across(&fluids, term, pressure, |_| 0.0)
            .iter()
            .fold(0.0, |most: f64, a| most.max((a[0] - 1.0).abs()))
    };
    // The kernel smears the kink over h; a fluid that felt the other's weight would
    // be pushed ten times as hard, or a tenth.
    assert!(
        off(PressureForm::HuAdams) < 0.2,
        "{}",
        off(PressureForm::HuAdams)
    );
    // The mean of two pressures does let the light fluid feel it.
    assert!(off(PressureForm::OverDensityProduct) > 1.0);
}

#[test]
fn shear_stress_passes_from_one_fluid_to_the_other() {
    // mu dv/dx = 1 on either side.
    let fluids = [fluid(0.1, 0.0), fluid(1.0, 0.0)];
    let velocity = |x: f64| if x < 0.0 { x } else { 10.0 * x };
    let largest = |form| {
        let term = Momentum {
            viscosity: Some(form),
            ..NOTHING
        };
        across(&fluids, term, |_| 0.0, velocity)
            .iter()
            .fold(0.0, |most: f64, a| most.max(a[1].abs()))
    };
    // Where the stress jumped, a particle of one spacing would feel stress / (rho dx) = N.
    let n = N as f64;
    assert!(largest(ViscosityForm::MonaghanCleary) < 0.1 * n);
    // The mean of two viscosities does make it jump.
    assert!(largest(ViscosityForm::Morris) > n);
}
