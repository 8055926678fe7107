//! The viscous stress of a motion with a constant gradient.

use meniscus::fluid::Fluid;
use meniscus::physics::surface_tension::continuum::Continuum;
use meniscus::rates::{Dimension, Space};
use meniscus::scheme::ViscosityForm;
use meniscus::shape::Pattern;
use meniscus::{Setup, Simulation, Vector};

use crate::ball;

/// A disordered drop of viscosity 0.3, without surface tension, that moves as asked, and
/// its accelerations.
fn moving<const D: usize>(velocity: impl Fn(Vector<f64, D>) -> Vector<f64, D>) -> Simulation<D>
where
    Space: Dimension<D>,
{
    let mut setup: Setup<D> = ball(7.0, Pattern::Cubic, 0.2, Continuum::default());
    setup.scheme.surface_tension = None;
    setup.scheme.artificial_viscosity = 0.0;
    setup.scheme.viscosity = ViscosityForm::Stress;
    setup.fluids = vec![Fluid {
        viscosity: 0.3,
        ..setup.fluids[0].clone()
    }];
    for particle in &mut setup.particles {
        particle.velocity = velocity(particle.position);
    }
    Simulation::new(setup).expect("a sound setup")
}

/// Power of the forces, W.
fn power<const D: usize>(simulation: &Simulation<D>) -> f64 {
    let p = simulation.particles();
    (0..p.len())
        .map(|i| p.mass[i] * p.velocity[i].dot(&p.acceleration[i]))
        .sum()
}

fn volume<const D: usize>(simulation: &Simulation<D>) -> f64 {
    simulation.particles().mass.iter().sum()
}

#[test]
fn pure_strain_loses_what_navier_and_stokes_say_up_to_the_surface() {
    // v = (x, -y): mu (G + G^T) : G = 4 mu per volume, the surface layer included. The
    // pressure is zero. Rounding.
    let stretch = moving::<2>(|x| Vector([x[0], -x[1]]));
    let lost = -power(&stretch) / (4.0 * 0.3 * volume(&stretch));
    assert!((lost - 1.0).abs() < 1e-10, "{lost}");
    let stretch = moving::<3>(|x| Vector([x[0], -x[1], 0.0]));
    let lost = -power(&stretch) / (4.0 * 0.3 * volume(&stretch));
    assert!((lost - 1.0).abs() < 1e-10, "{lost}");
}

#[test]
fn a_solid_rotation_feels_nothing() {
    let turning = moving::<2>(|x| Vector([-x[1], x[0]]));
    let most = turning
        .particles()
        .acceleration
        .iter()
        .map(Vector::norm)
        .fold(0.0, f64::max);
    assert!(most < 1e-12, "{most:e}");
}

#[test]
fn linear_and_angular_momentum_are_conserved() {
    let swirling = moving::<2>(|x| Vector([(0.7 * x[1]).sin(), x[0] * x[1] * 0.1]));
    let p = swirling.particles();
    let (mut force, mut torque, mut magnitude) = (Vector::<f64, 2>::ZERO, 0.0, 0.0);
    for i in 0..p.len() {
        let (x, f) = (p.position[i], p.acceleration[i] * p.mass[i]);
        force += f;
        torque += x[0] * f[1] - x[1] * f[0];
        magnitude += f.norm();
    }
    // Rounding of forces that add up to the magnitude, with arms up to 7.
    assert!(force.norm() < 1e-13 * magnitude, "{force:?}");
    assert!(torque.abs() < 1e-12 * magnitude, "{torque:e}");
}
