//! One piece of the engine's work, to be counted by callgrind: `count` runs
//! this program once for each line of its table.
//!
//! `instructions WORK DIMENSION INSTRUCTIONS` prints the number of particles
//! and how often the work was done. Only what runs inside [`measured`] is
//! collected; each work is done once before, so that memory is at hand.

use std::hint::black_box;

use meniscus::pairs::{Instructions, Pairs};
use meniscus::physics::continuity::Continuity;
use meniscus::physics::momentum::{Momentum, OneFluid, OverDensitySquared};
use meniscus::physics::surface_tension::gradient::{Gradient, Smoothed};
use meniscus::rates::{Dimension, Space};
use meniscus::term::Sweep;
use meniscus::{
    Domain, Fluid, Kernel, PairTerm, Particle, Particles, Scheme, Setup, Simulation,
    SurfaceTension, Vector,
};

type Outcome = Result<(), Box<dyn std::error::Error + Send + Sync>>;

/// Times that the step is done, so that new lists take their usual part.
const STEPS: usize = 8;

/// Callgrind collects from the entry of this function to its return.
#[inline(never)]
fn measured(work: &mut dyn FnMut()) {
    work();
    // A call in tail position would leave before the work begins.
    black_box(());
}

fn main() -> Outcome {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [work, dimension, instructions] = arguments.as_slice() else {
        return Err("wanted: WORK DIMENSION INSTRUCTIONS".into());
    };
    let instructions = match instructions.as_str() {
        "avx2" => Instructions::Avx2,
        "portable" => Instructions::Portable,
        other => return Err(format!("instructions are '{other}'; wanted: avx2, portable").into()),
    };
    // Collection is by thread: the work must be done where it is asked for.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
    pool.install(|| match dimension.as_str() {
        "2" => run::<2>(work, 90, 1.437, instructions),
        "3" => run::<3>(work, 20, 1.31, instructions),
        other => Err(format!("dimension is '{other}'; wanted: 2, 3").into()),
    })
}

/// A jittered lattice of unit width with `edge` particles along each axis.
fn start<const D: usize>(edge: usize) -> Vec<Particle<D>> {
    let spacing = 1.0 / edge as f64;
    let mut state = 1_u64;
    let mut random = || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
    };
    (0..edge.pow(D as u32))
        .map(|k| Particle {
            position: Vector(std::array::from_fn(|d| {
                let index = k / edge.pow(d as u32) % edge;
                (index as f64 + 0.5 + 0.2 * random()) * spacing
            })),
            velocity: Vector(std::array::from_fn(|_| random())),
            mass: spacing.powi(D as i32),
            fluid: 0,
            body: 0,
        })
        .collect()
}

fn run<const D: usize>(work: &str, edge: usize, ratio: f64, instructions: Instructions) -> Outcome
where
    Space: Dimension<D>,
{
    let spacing = 1.0 / edge as f64;
    let smoothing_length = ratio * spacing;
    let start = start::<D>(edge);
    let mut fluid = Fluid::new("water", 1.0);
    fluid.sound_speed = 20.0;
    if let Some(surface_tension) = match work {
        "step" => Some(None),
        "surface step" => Some(Some(SurfaceTension::default())),
        _ => None,
    } {
        let mut scheme = Scheme::new(smoothing_length);
        scheme.surface_tension = surface_tension;
        fluid.surface_tension = 1.0;
        return step(
            Setup {
                scheme,
                fluids: vec![fluid],
                particles: start,
                spacing,
                domain: Domain::default(),
            },
            instructions,
        );
    }
    let mut particles = Particles::new(&start);
    particles.density.fill(fluid.density);
    particles
        .pressure
        .iter_mut()
        .zip(&start)
        .for_each(|(p, s)| *p = 1.0 + s.velocity.0[0]);
    let mut pairs = Pairs::new(
        Kernel::WendlandC2,
        smoothing_length,
        spacing,
        0.1 * spacing,
        Domain::default(),
    );
    pairs.set_instructions(instructions);
    if work == "sort and lists" {
        // The second time all is sorted already, as it nearly is in a flow.
        pairs.rebuild(&mut particles);
        measured(&mut || pairs.rebuild(&mut particles));
        println!("{} 1", particles.len());
        return Ok(());
    }
    pairs.rebuild(&mut particles);
    let values: Vec<f64> = particles.velocity.iter().map(|v| v.0[0]).collect();
    let momentum = Momentum {
        material: OneFluid::new(particles.mass[0], &fluid),
        pressure: OverDensitySquared,
        artificial_viscosity: 0.1,
        viscosity: None,
        smoothing_length,
    };
    match work {
        "continuity" => sweep(&mut pairs, &particles, &Continuity),
        "momentum" => sweep(&mut pairs, &particles, &momentum),
        "colour" => sweep(&mut pairs, &particles, &Smoothed { weighted: &values }),
        "normal" => sweep(&mut pairs, &particles, &Gradient { values: &values }),
        other => return Err(format!("there is no work '{other}'").into()),
    }
    Ok(())
}

fn sweep<T: PairTerm<D>, const D: usize>(pairs: &mut Pairs<D>, particles: &Particles<D>, term: &T) {
    let mut sums = Vec::new();
    pairs.sweep(term, particles, |_| true, &mut sums);
    measured(&mut || pairs.sweep(term, particles, |_| true, &mut sums));
    println!("{} 1", particles.len());
}

fn step<const D: usize>(setup: Setup<D>, instructions: Instructions) -> Outcome
where
    Space: Dimension<D>,
{
    let mut simulation = Simulation::new(setup)?;
    simulation.set_instructions(instructions);
    simulation.step().map_err(|error| error.to_string())?;
    let mut outcome = Ok(());
    measured(&mut || outcome = (0..STEPS).try_for_each(|_| simulation.step()));
    outcome.map_err(|error| error.to_string())?;
    println!("{} {STEPS}", simulation.particles().len());
    Ok(())
}
