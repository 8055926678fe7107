//! Smoothing lengths that follow density, and what forces owe to them.

mod common;

use common::{fluid, free_drop, noise, periodic_lattice, ten_steps};
use meniscus::measure::specific_compression_energy;
use meniscus::rates::{Dimension, Space};
use meniscus::scheme::{AdaptiveSmoothing, DensityForm, TimeStep};
use meniscus::{Setup, Simulation, Vector};

const MODEL: AdaptiveSmoothing = AdaptiveSmoothing {
    k: 0.9,
    epsilon: 0.6,
    grad_h: false,
};

/// A jittered ellipse or ellipsoid of liquid without friction or surface tension.
fn drop<const D: usize>(spacing: f64, model: AdaptiveSmoothing) -> Setup<D> {
    let mut setup = free_drop::<D>(spacing, 0.1);
    setup.scheme.surface_tension = None;
    setup.scheme.artificial_viscosity = 0.0;
    setup.scheme.density = DensityForm::Summation;
    setup.scheme.adaptive_smoothing = Some(model);
    setup
}

fn start<const D: usize>(setup: &Setup<D>) -> Simulation<D>
where
    Space: Dimension<D>,
{
    Simulation::new(setup.clone()).expect("a sound setup")
}

/// Kinetic and compression energy.
fn energy<const D: usize>(simulation: &Simulation<D>) -> f64 {
    let p = simulation.particles();
    (0..p.len())
        .map(|i| {
            let elastic = specific_compression_energy(p.density[i], &simulation.fluids()[0]);
            p.mass[i] * (0.5 * p.velocity[i].norm_squared() + elastic)
        })
        .sum()
}

#[test]
fn lengths_of_an_even_liquid_are_k_times_the_scheme_s() {
    let mut setup = periodic_lattice::<2>([12, 16], 0.1, |_| Vector::ZERO, fluid(0.0, 0.0));
    setup.scheme.density = DensityForm::Summation;
    setup.scheme.adaptive_smoothing = Some(MODEL);
    let simulation = start(&setup);
    let wanted = MODEL.k * setup.scheme.smoothing_length;
    for h in &simulation.particles().smoothing_length {
        assert!((h / wanted - 1.0).abs() < 1e-12, "{h} is not {wanted}");
    }
}

/// Half of a box four times as dense as the other: far from the jump, lengths differ by the density
/// to the power epsilon; their geometric mean over all is that of an even liquid.
#[test]
fn lengths_follow_the_power_law_about_their_geometric_mean() {
    let mut setup = periodic_lattice::<2>([64, 12], 0.1, |_| Vector::ZERO, fluid(0.0, 0.0));
    for particle in &mut setup.particles {
        particle.mass *= if particle.position[0] < 3.2 { 1.6 } else { 0.4 };
    }
    setup.scheme.density = DensityForm::Summation;
    setup.scheme.adaptive_smoothing = Some(MODEL);
    let simulation = start(&setup);
    let p = simulation.particles();
    let length_at = |x: f64| {
        let row = (0..p.len()).find(|&i| (p.position[i][0] - x).abs() < 0.051);
        p.smoothing_length[row.expect("a lattice")]
    };
    let ratio = length_at(4.8) / length_at(1.6);
    assert!((ratio / 4.0_f64.powf(MODEL.epsilon) - 1.0).abs() < 1e-12);
    let logarithms = p.smoothing_length.iter().map(|h| h.ln());
    let mean = (logarithms.sum::<f64>() / p.len() as f64).exp();
    let wanted = MODEL.k * setup.scheme.smoothing_length;
    assert!((mean / wanted - 1.0).abs() < 1e-12, "{mean}, {wanted}");
}

fn momentum_is_kept<const D: usize>(spacing: f64, grad_h: bool)
where
    Space: Dimension<D>,
{
    let mut setup = drop::<D>(spacing, AdaptiveSmoothing { grad_h, ..MODEL });
    setup.scheme.artificial_viscosity = 0.1;
    setup.fluids[0].viscosity = 0.01;
    let mut simulation = start(&setup);
    let (impulses, _) = ten_steps(&mut simulation);
    let p = simulation.particles();
    let mut momentum = Vector::<f64, D>::ZERO;
    for i in 0..p.len() {
        momentum += p.velocity[i] * p.mass[i];
    }
    // Rounding of each of some hundred pairs, of random sign.
    assert!(
        momentum.norm() < 1e-14 * impulses,
        "{} of {impulses}",
        momentum.norm()
    );
}

#[test]
fn linear_momentum_is_kept_to_rounding() {
    for grad_h in [false, true] {
        momentum_is_kept::<2>(0.08, grad_h);
        momentum_is_kept::<3>(0.2, grad_h);
    }
}

/// By how much the force is off the gradient of the energy, in some direction: |F . e + dE/de| / |dE/de|.
fn excess_force<const D: usize>(spacing: f64, grad_h: bool) -> f64
where
    Space: Dimension<D>,
{
    let model = AdaptiveSmoothing { grad_h, ..MODEL };
    let setup = drop::<D>(spacing, model);
    let step = 1e-6 * spacing;
    let away = |sign: f64| {
        let mut moved = setup.clone();
        for (k, particle) in moved.particles.iter_mut().enumerate() {
            particle.position += direction(k) * (sign * step);
        }
        energy(&start(&moved))
    };
    let rise = (away(1.0) - away(-1.0)) / (2.0 * step);
    let simulation = start(&setup);
    let p = simulation.particles();
    let force: f64 = (0..p.len())
        .map(|i| p.mass[i] * p.acceleration[i].dot(&direction(p.id[i] as usize)))
        .sum();
    ((force + rise) / rise).abs()
}

/// Some direction for each particle.
fn direction<const D: usize>(k: usize) -> Vector<f64, D> {
    Vector(std::array::from_fn(|d| noise((k * 3 + d) as i64)))
}

/// Central differences of a step of 1e-6 spacings leave 1e-9 of rounding.
#[test]
fn with_grad_h_terms_the_force_is_the_gradient_of_the_energy() {
    for (with, without) in [
        (
            excess_force::<2>(0.08, true),
            excess_force::<2>(0.08, false),
        ),
        (excess_force::<3>(0.2, true), excess_force::<3>(0.2, false)),
    ] {
        assert!(with < 1e-6, "with {with:e}, without {without:e}");
        assert!(without > 1e-2, "without {without:e}");
    }
}

/// Largest change of energy over half a swing of the drop, over the kinetic energy it swings with.
fn drift(grad_h: bool) -> f64 {
    let mut setup = drop::<2>(0.1, AdaptiveSmoothing { grad_h, ..MODEL });
    setup.scheme.time_step = TimeStep::Fixed(5e-4);
    let mut simulation = start(&setup);
    let before = energy(&simulation);
    let (mut worst, mut swing) = (0.0_f64, 0.0_f64);
    for _ in 0..400 {
        simulation.step().expect("the flow is calm");
        let p = simulation.particles();
        let kinetic: f64 = (p.velocity.iter().zip(&p.mass))
            .map(|(v, m)| 0.5 * m * v.norm_squared())
            .sum();
        swing = swing.max(kinetic);
        worst = worst.max((energy(&simulation) - before).abs());
    }
    worst / swing
}

#[test]
fn grad_h_terms_keep_the_energy_of_a_swinging_drop() {
    let (with, without) = (drift(true), drift(false));
    println!("drift with {with:e}, without {without:e}");
    assert!(with < 0.1 * without, "with {with:e}, without {without:e}");
}

#[test]
fn what_adaptive_smoothing_cannot_go_with_is_refused() {
    let refused = |change: &dyn Fn(&mut Setup<2>)| {
        let mut setup = drop::<2>(0.2, MODEL);
        change(&mut setup);
        assert!(Simulation::new(setup).is_err());
    };
    refused(&|setup| setup.scheme.density = DensityForm::Continuity);
    refused(&|setup| setup.scheme.walls = vec![meniscus::scheme::Wall::new(3)]);
    refused(&|setup| setup.scheme.adaptive_smoothing = Some(AdaptiveSmoothing { k: 0.0, ..MODEL }));
    refused(&|setup| {
        let epsilon = 1.1;
        setup.scheme.adaptive_smoothing = Some(AdaptiveSmoothing { epsilon, ..MODEL });
    });
}
