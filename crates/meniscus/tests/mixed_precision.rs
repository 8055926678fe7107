//! Mixed precision against double: how exact the accelerations are, however
//! far apart the particles lie.

use meniscus::fluid::Fluid;
use meniscus::pairs::Pairs;
use meniscus::physics::continuity::Continuity;
use meniscus::physics::momentum::{Momentum, OneFluid, OverDensitySquared};
use meniscus::physics::viscosity::ViscosityForm;
use meniscus::term::Sweep;
use meniscus::{
    Domain, Kernel, PairTerm, Particle, Particles, Precision, Setup, Simulation, Vector,
};

mod common;

const SPACING: f64 = 1e-4;

/// Two jittered blocks of water, `apart` spacings from one another.
fn blocks<const D: usize>(apart: f64) -> Particles<D> {
    let n: usize = if D == 2 { 24 } else { 10 };
    let count = n.pow(D as u32);
    let random = |k: usize| ((k as f64 * 12.9898).sin() * 43758.5453).fract();
    let start: Vec<_> = (0..2 * count)
        .map(|k| Particle {
            position: Vector(std::array::from_fn(|d| {
                let cell = (k % count / n.pow(d as u32) % n) as f64;
                let block = if k < count { 0.0 } else { apart };
                (cell + block + 0.2 * random(D * k + d)) * SPACING
            })),
            velocity: Vector(std::array::from_fn(|d| random(7 * k + 3 * d))),
            mass: 1000.0 * SPACING.powi(D as i32),
            fluid: 0,
            body: 0,
        })
        .collect();
    let mut particles = Particles::new(&start);
    for k in 0..particles.len() {
        particles.density[k] = 1000.0 * (1.0 + 0.01 * random(k));
        particles.pressure[k] = 1000.0 * random(5 * k);
    }
    particles
}

/// Root mean squares of the difference and of the sums in double precision.
fn deviation<T: PairTerm<D>, const D: usize>(
    term: &T,
    particles: &Particles<D>,
    size: impl Fn(&T::Sum<f64>, &T::Sum<f64>) -> [f64; 2],
) -> f64 {
    let mut particles = particles.clone();
    let h = 2.0 * SPACING;
    let mut pairs = Pairs::new(
        Kernel::WendlandC2,
        h,
        SPACING,
        0.1 * SPACING,
        Domain::default(),
    );
    pairs.rebuild(&mut particles);
    let mut sums = |precision| {
        let mut sums = Vec::new();
        pairs.set_precision(precision);
        pairs.sweep(term, &particles, |_| true, &mut sums);
        sums
    };
    let (double, mixed) = (sums(Precision::Double), sums(Precision::Mixed));
    let mut total = [0.0; 2];
    for (double, mixed) in double.iter().zip(&mixed) {
        for (total, part) in total.iter_mut().zip(size(double, mixed)) {
            *total += part;
        }
    }
    (total[0] / total[1]).sqrt()
}

/// The bar is 1e-6 of the accelerations. Each pair is right to a few roundings
/// of f32, 6e-8; those of some hundred pairs partly cancel, and so do the pairs.
fn at_most_a_millionth<const D: usize>(apart: f64) {
    let particles = blocks::<D>(apart);
    let fluid = Fluid {
        sound_speed: 10.0,
        viscosity: 1e-3,
        ..Fluid::new("water", 1000.0)
    };
    let momentum = Momentum {
        material: OneFluid::new(particles.mass[0], &fluid),
        pressure: OverDensitySquared,
        artificial_viscosity: 0.1,
        viscosity: Some(ViscosityForm::MonaghanCleary),
        smoothing_length: 2.0 * SPACING,
    };
    let acceleration = deviation(&momentum, &particles, |a, b| {
        [(*a - *b).norm_squared(), a.norm_squared()]
    });
    let density = deviation(&Continuity, &particles, |a, b| [(a - b).powi(2), a * a]);
    println!(
        "{D}D, {apart:e} apart: acceleration {acceleration:.1e}, rate of density {density:.1e}"
    );
    assert!(
        acceleration < 1e-6,
        "{D}D, {apart} spacings apart: {acceleration:e}"
    );
    assert!(density < 1e-6, "{D}D, {apart} spacings apart: {density:e}");
}

#[test]
fn accelerations_agree_with_double_precision_whatever_the_size_of_the_domain() {
    for apart in [30.0, 3e3, 3e6] {
        at_most_a_millionth::<2>(apart);
        at_most_a_millionth::<3>(apart);
    }
}

/// Positions are numbers modulo 2^32, which come round every 64 supports of
/// 4 spacings: two particles so far apart must not meet.
#[test]
fn particles_a_whole_turn_apart_do_not_meet() {
    let turn = 64.0 * 4.0 * SPACING;
    for shift in [0.5 * turn, turn, 2.0 * turn, 100.0 * turn] {
        let start: Vec<_> = [0.0, 0.5 * SPACING, shift, shift + 0.5 * SPACING]
            .iter()
            .zip([0.0, 1.0, 2.0, 4.0])
            .map(|(&x, speed)| Particle {
                position: Vector([x, 0.0]),
                velocity: Vector([speed, 1.0]),
                mass: 1.0,
                fluid: 0,
                body: 0,
            })
            .collect();
        let mut particles = Particles::new(&start);
        particles.density.fill(1.0);
        let deviation = deviation(&Continuity, &particles, |a, b| [(a - b).powi(2), a * a]);
        assert!(deviation < 1e-6, "{shift} m apart: {deviation:e}");
    }
}

/// Pairs are summed from either side with the same roundings: momentum is kept
/// as exactly as f32 allows, and the state is f64.
#[test]
fn a_drop_swings_as_in_double_precision() {
    let run = |precision| {
        let mut setup: Setup<2> = common::free_drop(0.1, 0.0);
        setup.scheme.precision = precision;
        for particle in &mut setup.particles {
            let [x, y] = particle.position.0;
            particle.velocity = Vector([0.1 * x, -0.1 * y]);
        }
        let mut simulation = Simulation::new(setup).expect("a sound setup");
        for _ in 0..200 {
            simulation.step().expect("the flow is calm");
        }
        let particles = simulation.particles();
        (0..particles.len())
            .map(|i| particles.mass[i] * particles.position[i][0].powi(2))
            .sum::<f64>()
    };
    let (double, mixed) = (run(Precision::Double), run(Precision::Mixed));
    assert!(
        (mixed / double - 1.0).abs() < 1e-5,
        "{mixed:e} for {double:e}"
    );
}
