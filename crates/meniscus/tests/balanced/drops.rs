//! Drops at rest, and what brings a particle back.

use meniscus::rates::{Dimension, Space};
use meniscus::theory::equivalent_radius;
use meniscus::{Simulation, Vector};

use crate::ball;
use crate::common::where_a_stray_comes;

/// Pressure inside, over (D - 1) sigma / R, of a drop that a drag has brought to rest.
fn at_rest<const D: usize>(radius: f64, jitter: f64, periods: f64) -> f64
where
    Space: Dimension<D>,
{
    let time = radius.powf(1.5);
    let mut setup = ball::<D>(Vector::ZERO, radius, jitter, 0.0);
    setup.scheme.damping = 4.0 / time;
    let mut simulation = Simulation::new(setup).expect("a sound setup");
    simulation
        .advance_to(periods * time)
        .expect("the drop is calm");
    let p = simulation.particles();
    let (mut sum, mut count, mut volume) = (0.0, 0.0, 0.0);
    for i in 0..p.len() {
        volume += p.volume(i);
        if p.position[i].norm() < 0.5 * radius {
            sum += p.pressure[i];
            count += 1.0;
        }
    }
    sum / count * equivalent_radius(volume, D) / (D as f64 - 1.0)
}

#[test]
fn a_drop_has_the_pressure_of_laplace() {
    // What a lattice and its jitter leave at seven spacings to the radius.
    for jitter in [0.0, 0.1] {
        let flat = at_rest::<2>(7.0, jitter, 4.0);
        assert!((flat - 1.0).abs() < 0.01, "jitter {jitter}: {flat}");
    }
    let solid = at_rest::<3>(5.0, 0.1, 2.5);
    assert!((solid - 1.0).abs() < 0.015, "{solid}");
}

#[test]
fn a_constant_curvature_leaves_no_motion_however_disordered() {
    // On a disordered disc the curvature found varies; its mean pressure is all but balanced,
    // so that accelerations are those of the variation alone: far less than sigma / (rho R dx)
    // that an unbalanced force would give the outermost particles.
    let radius = 10.0;
    let mut setup = ball::<2>(Vector::ZERO, radius, 0.1, 0.0);
    let mut liquid = setup.fluids[0].clone();
    liquid.background_pressure = 1.0 / radius;
    setup.fluids = vec![liquid];
    let simulation = Simulation::new(setup).expect("a sound setup");
    let p = simulation.particles();
    let unbalanced = (0..p.len()).map(|i| simulation.surface().force[i].norm());
    let unbalanced = unbalanced.fold(0.0, f64::max);
    let mut inside: f64 = 0.0;
    for i in 0..p.len() {
        if p.position[i].norm() < 0.6 * radius {
            inside = inside.max(p.acceleration[i].norm());
        }
    }
    assert!(inside < 0.1 * unbalanced, "{inside} of {unbalanced}");
}

#[test]
fn a_particle_on_the_surface_sinks_in() {
    let distance = where_a_stray_comes(ball(Vector::ZERO, 8.0, 0.0, 0.3));
    // The outermost particles lie half a spacing under the surface at R = 8.
    assert!(distance < 8.2, "{distance}");
}
