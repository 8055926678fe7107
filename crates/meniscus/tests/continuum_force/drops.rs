//! Drops at rest: the pressure of Laplace inside, alone and in another fluid, light
//! or as heavy.

use meniscus::measure::maximum_speed;
use meniscus::physics::surface_tension::continuum::{Continuum, Form};
use meniscus::rates::{Dimension, Space};
use meniscus::scheme::{DensityForm, PressureForm, TimeStep};
use meniscus::shape::Pattern;
use meniscus::{Domain, Kernel, Particle, Setup, Simulation, Vector};

use crate::ball;
use crate::common::{fluid, noise, scheme};

/// Mean pressure of particles closer to the middle than a radius, less that of
/// particles farther than another.
fn jump<const D: usize>(simulation: &Simulation<D>, near: f64, far: f64) -> f64 {
    let p = simulation.particles();
    let mean = |pass: &dyn Fn(f64) -> bool| {
        let rows = (0..p.len()).filter(|&i| pass(p.position[i].norm()));
        let (sum, count) = rows.fold((0.0, 0), |(sum, count), i| (sum + p.pressure[i], count + 1));
        if count > 0 {
            sum / f64::from(count)
        } else {
            0.0
        }
    };
    mean(&|r| r < near) - mean(&|r| r > far)
}

/// Pressure inside a free drop, over (D - 1) sigma / R, after a drag has brought it to rest.
fn alone<const D: usize>(radius: f64, jitter: f64) -> f64
where
    Space: Dimension<D>,
{
    let mut setup = ball::<D>(radius, Pattern::ClosePacked, jitter, Continuum::default());
    setup.scheme.kernel = Kernel::WendlandC2;
    setup.scheme.artificial_viscosity = 0.2;
    setup.scheme.damping = 20.0 / radius;
    setup.scheme.time_step = TimeStep::Fixed(0.04);
    let volume: f64 = setup.particles.iter().map(|p| p.mass).sum();
    let exact = (D as f64 - 1.0) / meniscus::theory::equivalent_radius(volume, D);
    let mut simulation = Simulation::new(setup).expect("a sound setup");
    simulation.advance_to(radius).expect("the drop is calm");
    jump(&simulation, 0.5 * radius, f64::INFINITY) / exact
}

#[test]
fn a_drop_alone_has_the_pressure_of_laplace() {
    for (radius, jitter) in [(13.4, 0.0), (13.4, 0.1), (24.95, 0.0)] {
        let found = alone::<2>(radius, jitter);
        // The force acts in a layer about h thick: what is too much is of the order h / R.
        assert!(
            (found - 1.0).abs() < 1.2 * 2.0 / radius,
            "R = {radius} dx, jitter {jitter}: {found}"
        );
    }
    // As the curvature of a sphere of 7 spacings.
    let found = alone::<3>(7.0, 0.0);
    assert!((found - 1.0).abs() < 0.3, "3D: {found}");
}

/// A drop of radius 8 in a periodic box of another fluid of a density.
fn in_a_fluid(density: f64, sound_speed: f64, jitter: f64, form: Form) -> Setup<2> {
    let half = 16_i64;
    let mut outer = fluid(0.02, 0.0);
    (outer.density, outer.sound_speed) = (density, sound_speed);
    let mut inner = fluid(0.05, 1.0);
    (inner.background_pressure, outer.background_pressure) = (1.0, 1.0);
    let particles = (0..4 * half * half)
        .map(|k| {
            let at = |axis: i64| {
                let cell = if axis == 0 {
                    k % (2 * half)
                } else {
                    k / (2 * half)
                };
                (cell - half) as f64 + 0.5 + jitter * noise(2 * k + axis)
            };
            let position = Vector([at(0), at(1)]);
            let outside = position.norm() > 8.0;
            Particle {
                position,
                velocity: Vector::ZERO,
                mass: if outside { density } else { 1.0 },
                fluid: u16::from(outside),
                body: u16::from(outside),
            }
        })
        .collect();
    let mut scheme = scheme(1.0);
    scheme.artificial_viscosity = 0.1;
    scheme.damping = 3.0;
    scheme.density = DensityForm::Number;
    scheme.pressure = PressureForm::OverDensityProduct;
    scheme.surface_tension = Some(meniscus::SurfaceTension::Continuum(Continuum {
        form,
        ..Continuum::default()
    }));
    let side = half as f64;
    Setup {
        scheme,
        fluids: vec![inner, outer],
        particles,
        spacing: 1.0,
        domain: Domain {
            periodic: [Some((-side, side)); 2],
        },
    }
}

#[test]
fn a_drop_in_another_fluid_has_the_pressure_of_laplace() {
    for form in [Form::Balanced, Form::Stress] {
        for (density, sound_speed, jitter) in
            [(1.0, 10.0, 0.0), (1.0, 10.0, 0.1), (1e-3, 300.0, 0.1)]
        {
            let setup = in_a_fluid(density, sound_speed, jitter, form);
            let count = setup.particles.iter().filter(|p| p.fluid == 0).count() as f64;
            let exact = 1.0 / (count / std::f64::consts::PI).sqrt();
            let mut simulation = Simulation::new(setup).expect("a sound setup");
            let (mut sum, mut samples) = (0.0, 0);
            while simulation.time() < 5.0 {
                simulation.step().expect("the flow is calm");
                if simulation.time() > 3.0 {
                    sum += jump(&simulation, 4.0, 13.0);
                    samples += 1;
                }
            }
            let found = sum / f64::from(samples) / exact;
            let speed = maximum_speed(&simulation.particles().velocity);
            assert!(
                (found - 1.0).abs() < 0.1,
                "{form:?}, density {density}, jitter {jitter}: {found}"
            );
            // Parasitic, against sqrt(sigma / (rho R)) = 0.35.
            assert!(
                speed < 0.1,
                "{form:?}, density {density}, jitter {jitter}: {speed}"
            );
        }
    }
}
