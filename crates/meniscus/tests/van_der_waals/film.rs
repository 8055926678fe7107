//! A flat film: what its surface tension grows with.

use meniscus::measure::FilmStress;
use meniscus::scheme::{Scheme, Substance, TimeStep, VanDerWaals};
use meniscus::{Domain, Fluid, Particle, Setup, Simulation, Vector, theory};

use crate::common;

const DENSITY: f64 = 2.0;
const REDUCED_TEMPERATURE: f64 = 0.3;

/// What a film shows at rest.
struct Shown {
    /// N/m
    tension: f64,
    /// In its middle, kg/m^3
    density: f64,
    /// Of a sharp surface of that density, N/m
    sharp: f64,
}

/// A film of a liquid with this cohesion, Pa m^6/kg^2, of particles this far apart, m, brought to rest by a drag.
fn film(cohesion: f64, spacing: f64) -> Shown {
    let (width, thickness) = (20, 16);
    // Molecules that take up all heat: it stays as warm as it is.
    let substance =
        Substance::of_liquid(cohesion, DENSITY, 300.0, REDUCED_TEMPERATURE, 1e6).expect("a liquid");
    let model = VanDerWaals::new(substance, 300.0);
    let mut scheme = Scheme::van_der_waals(2.5 * spacing, model);
    scheme.time_step = TimeStep::Adaptive { safety: 1.0 };
    let time = spacing / (cohesion * DENSITY).sqrt();
    scheme.damping = 0.1 / time;
    let mut fluid = Fluid::new("fluid", DENSITY);
    fluid.viscosity = 0.3 * DENSITY * spacing * spacing / time;
    let particles = (0..width * thickness).map(|k| {
        let noise = |d: usize| 0.2 * common::noise(k as i64 * 7 + d as i64);
        let (x, y) = ((k % width) as f64 + noise(0), (k / width) as f64 + noise(1));
        Particle {
            // Thin at first, so that no disorder has it denser than it can be.
            position: Vector([x * spacing, 1.2 * y * spacing]),
            velocity: Vector::ZERO,
            mass: DENSITY * spacing * spacing,
            fluid: 0,
            body: 0,
        }
    });
    let domain = Domain {
        periodic: [Some((0.0, width as f64 * spacing)), None],
    };
    let mut particles: Vec<_> = particles.collect();
    for particle in &mut particles {
        domain.wrap(&mut particle.position);
    }
    let setup = Setup {
        scheme,
        fluids: vec![fluid],
        particles,
        spacing,
        domain,
    };
    let mut simulation = Simulation::new(setup).expect("a film");
    simulation.advance_to(100.0 * time).expect("it holds");
    let (p, scheme) = (simulation.particles(), simulation.scheme());
    let (kernel, h) = (scheme.kernel, scheme.smoothing_length);
    let flow = simulation.van_der_waals().expect("such a fluid");
    let force = |i, j, line: Vector<f64, 2>| {
        let r = line.norm();
        line * (flow.force_at_rest(p, kernel, h, [i, j], r) / r)
    };
    let range = flow.range(p, kernel, h);
    let stress = FilmStress::measure(&p.position, &domain, range, 0.5 * spacing, force);
    let middle = p.position.iter().map(|x| x[1]).sum::<f64>() / p.len() as f64;
    let inside: Vec<f64> = (0..p.len())
        .filter(|&i| (p.position[i][1] - middle).abs() < 2.0 * spacing)
        .map(|i| p.density[i])
        .collect();
    let density = inside.iter().sum::<f64>() / inside.len() as f64;
    Shown {
        tension: 0.5 * stress.expect("a film").tension(),
        density,
        sharp: theory::step_surface_tension(cohesion, density, kernel, 2.0 * h, 2),
    }
}

/// At a given reduced temperature a, rho and dx are all that there is: sigma / (a rho^2 dx) is a number. Films whose a
/// and dx are powers of four apart are the same film to rounding.
#[test]
fn surface_tension_is_in_proportion_to_cohesion_and_to_its_range() {
    let plain = film(2.0, 0.5);
    for (cohesion, spacing, factor) in [(32.0, 0.5, 16.0), (2.0, 2.0, 4.0)] {
        let tension = film(cohesion, spacing).tension;
        let ratio = tension / plain.tension / factor;
        assert!((ratio - 1.0).abs() < 1e-6, "{ratio}");
    }
}

/// The density that its constants were chosen for, within what sums over particles are off; and a soft surface, which
/// has less tension than a sharp one, more than half of it.
#[test]
fn a_film_is_of_the_liquid_that_its_constants_are_for() {
    let film = film(2.0, 0.5);
    assert!(
        (film.density / DENSITY - 1.0).abs() < 0.02,
        "{}",
        film.density
    );
    let ratio = film.tension / film.sharp;
    assert!((0.5..1.0).contains(&ratio), "{ratio}");
}
