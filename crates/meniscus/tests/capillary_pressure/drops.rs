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

/// What particles are strewn by drives no currents: drops that started ragged, came to rest in a thick liquid, and go on
/// in a thin one, La = 12000.
#[test]
fn ragged_drops_stay_at_rest() {
    let radius = 7.0_f64;
    let time = radius.powf(1.5);
    let viscosity = |laplace_number: f64| (2.0 * radius / laplace_number).sqrt();
    let speeds = [0.0, 0.3, 0.6].map(|aside| {
        let centre = Vector([aside, 0.7 * aside]);
        let inside = |x: Vector<f64, 2>| (x - centre).norm() < radius;
        let setup = |number| liquid::<2>(radius + 1.0, 0.2, viscosity(number), inside);
        let mut thick = Simulation::new(setup(100.0)).expect("a sound setup");
        // Swings and inner currents have e^-5 left.
        thick.advance_to(9.0 * time).expect("a calm drop");
        let mut thin = setup(12000.0);
        for (particle, x) in thin.particles.iter_mut().zip(&thick.particles().position) {
            particle.position = *x;
        }
        let mut thin = Simulation::new(thin).expect("a sound setup");
        thin.advance_to(15.0 * time).expect("a calm drop");
        let p = thin.particles();
        let squares: f64 = p.velocity.iter().map(Vector::norm_squared).sum();
        (squares / p.len() as f64 * radius).sqrt()
    });
    // In sqrt(sigma / (rho R)): 0.0002 to 0.0003 is left; with q that is not harmonic inside, 0.002 to 0.003.
    assert!(speeds.iter().all(|speed| *speed < 4e-4), "{speeds:?}");
}
