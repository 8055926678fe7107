//! The pressure in drops at rest.

use meniscus::rates::{Dimension, Space};
use meniscus::{Simulation, Vector};

use crate::liquid;

/// Pressure within half of the radius over Laplace's, of a drop of `radius` spacings that a drag brought to rest.
fn pressure<const D: usize>(radius: f64, jitter: f64) -> f64
where
    Space: Dimension<D>,
{
    let mut setup = liquid::<D>(radius, jitter, 0.5, |x| x.norm() < radius);
    let time = radius.powf(1.5);
    setup.scheme.damping = 3.0 / time;
    let mut simulation = Simulation::new(setup).expect("a sound setup");
    simulation.advance_to(3.0 * time).expect("a drop at rest");
    let p = simulation.particles();
    let inside: Vec<f64> = (0..p.len())
        .filter(|&i| p.position[i].norm() < 0.5 * radius)
        .map(|i| p.pressure[i])
        .collect();
    let mean = inside.iter().sum::<f64>() / inside.len() as f64;
    mean * radius / (D as f64 - 1.0)
}

/// What smoothing leaves of a curved surface differs from it by the square of its width, 1.7 spacings, over
/// the radius: 3 % at 10 spacings. Disorder counts for as much again. (Smaller drops are far off: -12 % in 2D
/// and -16 % in 3D at 7 spacings.)
#[test]
fn drops_at_rest_have_the_pressure_of_laplace() {
    for jitter in [0.0, 0.1] {
        let found = pressure::<2>(10.0, jitter);
        assert!((found - 1.0).abs() < 0.06, "2D, {jitter}: {found}");
    }
    let found = pressure::<3>(9.5, 0.1);
    assert!((found - 1.0).abs() < 0.06, "3D: {found}");
}

/// A drop falls to rest as it does in its middle: nothing starts by itself.
#[test]
fn a_drop_loses_its_motion() {
    let setup = liquid::<2>(8.0, 0.1, 0.8, |x| x.norm() < 8.0);
    let mut simulation = Simulation::new(setup).expect("a sound setup");
    let mut energies = Vec::new();
    for k in 1..=4 {
        simulation.advance_to(40.0 * f64::from(k)).expect("a drop");
        let p = simulation.particles();
        energies.push(p.velocity.iter().map(Vector::norm_squared).sum::<f64>());
    }
    assert!(energies[3] < 0.1 * energies[0], "{energies:?}");
}
