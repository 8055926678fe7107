//! The same case gives the same bits: on any number of threads, after a
//! resume, and with any instruction set.

mod common;

use common::{fluid, free_drop, periodic_box};
use meniscus::pairs::Instructions;
use meniscus::physics::surface_tension::balanced::Balanced;
use meniscus::physics::surface_tension::capillary_pressure::CapillaryPressure;
use meniscus::physics::surface_tension::pairwise::Pairwise;
use meniscus::physics::surface_tension::pairwise::akinci::{Akinci, Curvature};
use meniscus::physics::surface_tension::total_variation::TotalVariation;
use meniscus::physics::wall::layout::Layers;
use meniscus::rates::{Dimension, Space};
use meniscus::scheme::{
    AdaptiveSmoothing, Adhesion, DensityForm, SurfaceTension, ViscosityForm, Wall,
};
use meniscus::{Particle, Precision, Setup, Simulation, Snapshot, Vector};

fn march<const D: usize>(simulation: &mut Simulation<D>, steps: u64) {
    for _ in 0..steps {
        simulation.step().expect("the flow is calm");
    }
}

fn on_threads<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> T {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    pool.expect("a thread pool").install(work)
}

fn run<const D: usize>(setup: &Setup<D>, steps: u64, threads: usize) -> Snapshot
where
    Space: Dimension<D>,
{
    on_threads(threads, || {
        let mut simulation = Simulation::new(setup.clone()).expect("a sound setup");
        march(&mut simulation, steps);
        assert!(
            simulation.pairs().builds() > 1,
            "the test must cover new lists"
        );
        simulation.snapshot()
    })
}

/// Enough steps for several new lists.
const STEPS: u64 = 120;

fn same_on_threads<const D: usize>(setup: Setup<D>)
where
    Space: Dimension<D>,
{
    let one = run(&setup, STEPS, 1);
    assert_eq!(one, run(&setup, STEPS, 2));
    assert_eq!(one, run(&setup, STEPS, 4));
}

fn same_after_resume<const D: usize>(setup: Setup<D>)
where
    Space: Dimension<D>,
{
    let whole = run(&setup, STEPS, 1);
    // Every split is met: just before, at and after a new list.
    let mut first = Simulation::new(setup.clone()).expect("a sound setup");
    for k in 0..STEPS {
        if k % 7 == 0 || k == STEPS - 1 {
            let mut second = Simulation::restore(setup.clone(), &first.snapshot()).expect("fits");
            march(&mut second, STEPS - k);
            assert_eq!(whole, second.snapshot(), "stopped after {k} steps");
        }
        march(&mut first, 1);
    }
}

fn swirl(setup: &mut Setup<2>) {
    for particle in &mut setup.particles {
        let [x, y] = particle.position.0;
        particle.velocity = Vector([2.0 * (6.3 * y).sin(), (6.3 * x).cos()]);
    }
}

#[test]
fn threads_do_not_change_a_bit_of_a_drop() {
    same_on_threads(free_drop::<2>(0.08, 0.1));
    same_on_threads(free_drop::<3>(0.16, 0.1));
}

#[test]
fn threads_do_not_change_a_bit_of_a_periodic_flow() {
    let mut setup = periodic_box(24, |_| Vector::ZERO, fluid(0.01, 0.0));
    swirl(&mut setup);
    same_on_threads(setup);
}

#[test]
fn a_resume_does_not_change_a_bit() {
    same_after_resume(free_drop::<2>(0.12, 0.1));
    let mut setup = periodic_box(16, |_| Vector::ZERO, fluid(0.01, 0.0));
    swirl(&mut setup);
    same_after_resume(setup);
}

/// A plate under the drop of particles this far apart.
fn add_plate<const D: usize>(setup: &mut Setup<D>, spacing: f64, adhesion: Adhesion) {
    let (mut below, mut up) = (Vector::ZERO, Vector::ZERO);
    below[D - 1] = -1.1;
    up[D - 1] = 1.0;
    let plate = Layers::new(spacing, 4.0 * spacing, 1000).plane(below, up, 3.0);
    let plate = plate.expect("it fits");
    setup
        .particles
        .extend(plate.iter().map(|&position| Particle {
            position,
            velocity: Vector::ZERO,
            mass: spacing.powi(D as i32),
            fluid: 0,
            body: 1,
        }));
    setup.scheme.walls = vec![Wall {
        adhesion,
        ..Wall::new(1)
    }];
}

/// A drop of pairwise forces upon a plate that attracts it.
#[test]
fn pairwise_forces_keep_the_promise_too() {
    let mut setup = free_drop::<2>(0.12, 0.1);
    setup.scheme.surface_tension = Some(SurfaceTension::Pairwise(Pairwise::Akinci(Akinci {
        curvature: Curvature::Consistent,
        ..Akinci::default()
    })));
    add_plate(&mut setup, 0.12, Adhesion::Coefficient(20.0));
    same_on_threads(setup.clone());
    same_after_resume(setup);
}

/// Its curvature is state. A drop, and one that wets a plate.
#[test]
fn balanced_surface_tension_keeps_the_promise_too() {
    let mut setup = free_drop::<2>(0.12, 0.1);
    setup.scheme.density = DensityForm::Corrected;
    setup.scheme.surface_tension = Some(SurfaceTension::Balanced(Balanced));
    same_on_threads(setup.clone());
    same_after_resume(setup.clone());
    add_plate(&mut setup, 0.12, Adhesion::ContactAngle(1.2));
    same_on_threads(setup.clone());
    same_after_resume(setup);
}

#[test]
fn total_variation_keeps_the_promise_too() {
    let mut setup = free_drop::<3>(0.3, 0.1);
    setup.scheme.surface_tension = Some(SurfaceTension::TotalVariation(TotalVariation));
    same_on_threads(setup.clone());
    same_after_resume(setup);
}

/// A drop, and one that wets a plate, in the plane and in space.
#[test]
fn capillary_pressure_keeps_the_promise_too() {
    let mut setup = free_drop::<3>(0.3, 0.1);
    setup.scheme.surface_tension = Some(SurfaceTension::CapillaryPressure(CapillaryPressure));
    setup.scheme.viscosity = ViscosityForm::StressAndRest;
    same_on_threads(setup.clone());
    same_after_resume(setup.clone());
    add_plate(&mut setup, 0.3, Adhesion::ContactAngle(1.2));
    same_on_threads(setup.clone());
    same_after_resume(setup);
    let mut setup = free_drop::<2>(0.12, 0.1);
    setup.scheme.surface_tension = Some(SurfaceTension::CapillaryPressure(CapillaryPressure));
    add_plate(&mut setup, 0.12, Adhesion::ContactAngle(1.2));
    same_on_threads(setup.clone());
    same_after_resume(setup);
}

#[test]
fn adaptive_smoothing_keeps_the_promise_too() {
    let mut setup = free_drop::<2>(0.12, 0.1);
    setup.scheme.density = DensityForm::Summation;
    setup.scheme.adaptive_smoothing = Some(AdaptiveSmoothing {
        grad_h: true,
        ..AdaptiveSmoothing::default()
    });
    same_on_threads(setup.clone());
    same_after_resume(setup);
}

#[test]
fn mixed_precision_keeps_the_promise_too() {
    let mut setup = free_drop::<2>(0.12, 0.1);
    setup.scheme.precision = Precision::Mixed;
    same_on_threads(setup.clone());
    same_after_resume(setup);
}

/// AVX-512 and AVX2 round alike. Without them there is no fused multiplication
/// and addition: results are as good, but other bits.
#[test]
fn processors_with_avx2_or_better_give_the_same_bits() {
    for precision in [Precision::Double, Precision::Mixed] {
        let mut setup = free_drop::<2>(0.1, 0.1);
        setup.scheme.precision = precision;
        let run = |instructions| {
            let mut simulation = Simulation::new(setup.clone()).expect("a sound setup");
            simulation.set_instructions(instructions);
            // The first accelerations were found with the best instructions.
            march(&mut simulation, STEPS);
            simulation.snapshot()
        };
        assert_eq!(run(Instructions::Best), run(Instructions::Avx2));
    }
}

#[test]
fn a_snapshot_of_another_case_is_refused() {
    let other = Simulation::new(free_drop::<2>(0.2, 0.1)).expect("a sound setup");
    let snapshot = other.snapshot();
    let error = Simulation::restore(free_drop::<2>(0.12, 0.1), &snapshot).err();
    assert!(error.is_some_and(|e| e.to_string().contains("particles")));
}
