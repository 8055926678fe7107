//! A square of liquid in a void.

use meniscus::measure::{angular_momentum, kinetic_energy, linear_momentum};
use meniscus::rates::{Dimension, Space};
use meniscus::scheme::{AdaptiveSmoothing, Conduction, TimeStep};
use meniscus::{Simulation, Vector};

use crate::common::ten_steps;
use crate::square;

/// Kinetic, thermal and cohesive energy.
fn energies<const D: usize>(simulation: &Simulation<D>) -> [f64; 3] {
    let p = simulation.particles();
    let flow = simulation.van_der_waals().expect("it is such a fluid");
    let sum = |of: &dyn Fn(usize) -> f64| (0..p.len()).map(|i| p.mass[i] * of(i)).sum::<f64>();
    let cohesion = sum(&|i| flow.cohesion_energy(i));
    let internal = sum(&|i| flow.internal_energy(p, i));
    let kinetic = kinetic_energy(&p.velocity, &p.mass);
    [kinetic, internal - cohesion, cohesion]
}

/// The largest change of kinetic and internal energy up to t = 3; and the same were
/// cohesion's work counted twice.
fn drift(dt: f64, conduction: Conduction) -> (f64, f64) {
    let mut setup = square::<2>(30, 0.0);
    setup.scheme.time_step = TimeStep::Fixed(dt);
    setup.scheme.van_der_waals.as_mut().expect("set").conduction = conduction;
    let mut simulation = Simulation::new(setup).expect("a sound setup");
    let [kinetic, heat, cohesion] = energies(&simulation);
    let (mut worst, mut worst_twice) = (0.0_f64, 0.0_f64);
    while simulation.time() < 3.0 {
        simulation.step().expect("the drop holds together");
        let [k, h, c] = energies(&simulation);
        let change = k + h - kinetic - heat;
        worst = worst.max((change + c - cohesion).abs());
        worst_twice = worst_twice.max((change + 2.0 * (c - cohesion)).abs());
    }
    (worst, worst_twice)
}

#[test]
fn motion_heat_and_cohesion_keep_their_sum() {
    let (coarse, twice) = drift(0.005, Conduction::Brookshaw);
    // Of 2724 in all, and 22 of motion. Cohesion alone is marched with an error, of dt^2 times
    // sum m a^2 / 24, and that comes back.
    assert!(coarse < 3e-3, "{coarse}");
    // Eq. 10 as printed, with 2 a: as much is lost as cohesion works.
    assert!(twice > 20.0, "{twice}");
    let (fine, _) = drift(0.0025, Conduction::Brookshaw);
    assert!((3.0..5.0).contains(&(coarse / fine)), "{coarse}, {fine}");
    // The printed form of conduction moves heat without loss as well.
    let (printed, _) = drift(0.005, Conduction::DoubleSum);
    assert!(printed < 3e-3, "{printed}");
}

fn momentum_stays<const D: usize>(n: usize)
where
    Space: Dimension<D>,
{
    let mut setup = square::<D>(n, 0.1);
    for (k, particle) in setup.particles.iter_mut().enumerate() {
        particle.mass *= 1.0 + 0.2 * crate::common::noise(k as i64);
    }
    let mut simulation = Simulation::new(setup).expect("a sound setup");
    let (forces, torques) = ten_steps(&mut simulation);
    let p = simulation.particles();
    let momentum = linear_momentum(&p.velocity, &p.mass).norm();
    // Each pair pushes both ways by the same numbers: rounding alone is left.
    assert!(
        momentum < 1e-13 * forces,
        "{D}D: {momentum:e} of {forces:e}"
    );
    if D == 2 {
        // Pressure and cohesion turn nothing; shear stress, of uncorrected gradients, hardly does.
        let spin = angular_momentum(&p.position, &p.velocity, &p.mass, Vector::ZERO)[2].abs();
        assert!(spin < 1e-3 * torques, "{spin:e} of {torques:e}");
    }
}

#[test]
fn momentum_is_kept_exactly() {
    momentum_stays::<2>(12);
    momentum_stays::<3>(7);
}

#[test]
fn a_resumed_run_gives_the_same_bits() {
    let setup = || square::<2>(12, 0.1);
    let mut whole = Simulation::new(setup()).expect("a sound setup");
    whole.advance_to(0.5).expect("calm");
    let saved = whole.snapshot();
    let mut resumed = Simulation::restore(setup(), &saved).expect("its own snapshot");
    assert_eq!(resumed.snapshot(), saved);
    assert_eq!(
        energies(&resumed).map(f64::to_bits),
        energies(&whole).map(f64::to_bits)
    );
    whole.advance_to(1.0).expect("calm");
    resumed.advance_to(1.0).expect("calm");
    assert_eq!(resumed.snapshot(), whole.snapshot());
}

/// The largest change of energy where smoothing lengths follow density.
fn adaptive_drift(cohesion_adapts: bool, grad_h: bool) -> f64 {
    let mut setup = square::<2>(30, 0.0);
    setup.scheme.adaptive_smoothing = Some(AdaptiveSmoothing {
        grad_h,
        ..AdaptiveSmoothing::default()
    });
    let model = setup.scheme.van_der_waals.as_mut().expect("set");
    model.cohesion_adapts = cohesion_adapts;
    let mut simulation = Simulation::new(setup).expect("a sound setup");
    let start: f64 = energies(&simulation).iter().sum();
    let mut worst = 0.0_f64;
    while simulation.time() < 3.0 {
        simulation.step().expect("the drop holds together");
        let now: f64 = energies(&simulation).iter().sum();
        worst = worst.max((now - start).abs());
    }
    worst
}

#[test]
fn energy_survives_smoothing_lengths_that_change() {
    // Pressure warms by the work of whatever force it has; the energy of cohesion over a fixed
    // range knows nothing of smoothing lengths.
    let fixed = adaptive_drift(false, false);
    assert!(fixed < 3e-3, "{fixed}");
    // Over a range that changes it does: what the change costs is taken from nowhere,
    let plain = adaptive_drift(true, false);
    assert!(plain > 0.3, "{plain}");
    // or from the motion, by the grad-h terms; what is left is of the march, as above.
    let conserving = adaptive_drift(true, true);
    assert!(conserving < 0.02 * plain, "{conserving}, {plain}");
}
