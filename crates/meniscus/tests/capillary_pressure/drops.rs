//! Drops at rest, hollow surfaces, and what brings a particle back.

use meniscus::rates::{Dimension, Space};
use meniscus::theory::equivalent_radius;
use meniscus::{Domain, Simulation, Vector};

use crate::common::where_a_stray_comes;
use crate::liquid;

/// Mean pressure of the particles that `inside` holds, once a drag has brought them to rest.
fn at_rest<const D: usize>(
    mut setup: meniscus::Setup<D>,
    radius: f64,
    inside: impl Fn(Vector<f64, D>) -> bool,
) -> f64
where
    Space: Dimension<D>,
{
    let time = radius.powf(1.5);
    setup.scheme.damping = 4.0 / time;
    let mut simulation = Simulation::new(setup).expect("a sound setup");
    simulation
        .advance_to(3.0 * time)
        .expect("the liquid is calm");
    let p = simulation.particles();
    let rows = (0..p.len()).filter(|&i| inside(p.position[i]));
    let (sum, count) = rows.fold((0.0, 0.0), |(sum, count), i| {
        (sum + p.pressure[i], count + 1.0)
    });
    sum / count
}

#[test]
fn a_drop_has_the_pressure_of_laplace() {
    // What a lattice and its jitter leave at seven spacings to the radius, and five.
    for jitter in [0.0, 0.1] {
        let setup = liquid::<2>(7.0, jitter, 0.0, |x| x.norm() < 7.0);
        let radius = equivalent_radius(setup.particles.len() as f64, 2);
        let flat = at_rest(setup, 7.0, |x| x.norm() < 3.5) * radius;
        assert!((flat - 1.0).abs() < 0.015, "jitter {jitter}: {flat}");
    }
    let setup = liquid::<3>(5.0, 0.1, 0.0, |x| x.norm() < 5.0);
    let radius = equivalent_radius(setup.particles.len() as f64, 3);
    let solid = at_rest(setup, 5.0, |x| x.norm() < 2.5) * radius / 2.0;
    assert!((solid - 1.0).abs() < 0.03, "{solid}");
}

/// A round hole in a liquid that fills a periodic box: its pressure is as far below that of the hole, and no void
/// opens elsewhere.
#[test]
fn a_hollow_surface_pulls() {
    let (radius, half) = (8.0, 16.0);
    let mut setup = liquid::<2>(24.0, 0.1, 0.0, |x| {
        x.norm() > radius && x.0.iter().all(|x| x.abs() < half)
    });
    setup.domain = Domain {
        periodic: [Some((-half, half)); 2],
    };
    // The liquid is as much as it is: its hole may not grow.
    let area = 4.0 * half * half - setup.particles.len() as f64;
    let radius = (area / std::f64::consts::PI).sqrt();
    let found = at_rest(setup, radius, |x| x.norm() > 1.4 * radius) * radius;
    // Eight spacings to the radius, by a hole whose edge its lattice tells to a part of one.
    assert!((found + 1.0).abs() < 0.1, "{found}");
}

#[test]
fn a_particle_outside_sinks_in() {
    let radius = where_a_stray_comes(liquid(8.0, 0.0, 0.3, |x| x.norm() < 8.0));
    // The outermost of a drop of 202 lie at 7.5 to 8; one more is a bump of less than a spacing.
    assert!(radius < 9.0, "{radius}");
}

/// A drop that started ragged comes to rest: what its particles are strewn by drives no currents.
#[test]
fn a_ragged_drop_comes_to_rest() {
    let radius = 7.0_f64;
    // La = 12000, where currents have little to stop them.
    let viscosity = (2.0 * radius / 12000.0).sqrt();
    let setup = liquid::<2>(radius, 0.2, viscosity, |x| x.norm() < radius);
    let time = radius.powf(1.5);
    let mut simulation = Simulation::new(setup).expect("a sound setup");
    simulation.advance_to(28.0 * time).expect("a calm drop");
    let p = simulation.particles();
    let squares: f64 = p.velocity.iter().map(Vector::norm_squared).sum();
    let speed = (squares / p.len() as f64 * radius).sqrt();
    // With q that is not harmonic inside, drops of this size go on at 0.0009 to 0.0014 sqrt(sigma / (rho R)); the last free
    // swings have 0.0003 to 0.0005 left.
    assert!(speed < 7e-4, "{speed}");
}
