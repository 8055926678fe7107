//! Each sweep alone, and the lists, on particles that stand still.

use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

use meniscus::kernel::WendlandC2;
use meniscus::pairs::{Pairs, Precision};
use meniscus::physics::continuity::Continuity;
use meniscus::physics::momentum::{Momentum, OneFluid, OverDensitySquared};
use meniscus::physics::surface_tension::curvature::{Curvature, Weighting};
use meniscus::physics::surface_tension::gradient::{Gradient, Smoothed};
use meniscus::physics::surface_tension::jancik_hyhlik::JancikHyhlik;
use meniscus::rates::{Dimension, Space};
use meniscus::term::Sweep;
use meniscus::{Domain, Kernel, PairTerm, Particles, Vector};
use serde::Serialize;

use crate::BenchError;
use crate::clock::Crew;
use crate::cost::{Cost, Pace, Samples};
use crate::flops::{Operations, of_pair};
use crate::options::Effort;
use crate::peak::Peak;
use crate::state::{Flow, State, fluid, smoothing_length};
use crate::variant::Variant;
use crate::yardstick::Yardstick;

/// alpha of the artificial viscosity.
const ALPHA: f64 = 0.1;

/// Cost of one sweep, or of the lists.
#[derive(Clone, Debug, Serialize)]
pub struct SweepCost {
    /// Which.
    pub name: &'static str,
    /// Threads.
    pub threads: usize,
    /// Per particle, of all particles.
    pub cost: Cost,
    /// Of a sweep: what a pair costs.
    pub pair: Option<PairCost>,
    /// Wall time on one thread over that on these, of samples side by side.
    pub speed_up: f64,
}

/// What one directed pair of true neighbours costs.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct PairCost {
    /// Median, ns.
    pub nanoseconds: f64,
    /// Directed pairs a second.
    pub rate: f64,
    /// Flops of the formula.
    pub flops: u32,
    /// Minima, maxima, comparisons, which count for nothing.
    pub other_operations: u32,
    /// Flops of true pairs over those of the FMA peak of as many threads, in f64 or, mixed, in f32.
    pub share_of_peak: f64,
}

/// What was measured with the particles at rest.
#[derive(Clone, Debug, Serialize)]
pub struct Still {
    /// True neighbours of a particle, itself left out.
    pub neighbours: f64,
    /// How far lists reach beyond the support, spacings: as the running flow chose.
    pub skin: f64,
    /// Largest difference of the engine's continuity from the yardstick's, over the largest value.
    pub difference_of_continuity: f64,
    /// The same of momentum.
    pub difference_of_momentum: f64,
    /// Pairs of true neighbours over lanes that were worked on.
    pub lane_use: f64,
    /// The yardstick's continuity and momentum for each crew, ns/particle.
    pub yardstick: Vec<(usize, f64)>,
    /// Each sweep, and the lists, for each crew.
    pub sweeps: Vec<SweepCost>,
}

struct Subject<'a, const D: usize> {
    name: &'static str,
    /// Of the formula, and how many true pairs it is needed for.
    formula: Option<(Operations, usize)>,
    run: Box<dyn FnMut(&mut Pairs<D>) + Send + 'a>,
}

/// Measures `state` on each crew.
///
/// # Errors
/// If the flow that gives densities and skin blows up.
pub fn measure<const D: usize>(
    state: &State<D>,
    variant: Variant,
    crews: &[Crew],
    peaks: &[Peak],
    effort: Effort,
) -> Result<Still, BenchError>
where
    Space: Dimension<D>,
{
    let Some(largest) = crews.last() else {
        return Err(BenchError::new("there is no thread to measure"));
    };
    let (mut particles, skin) = largest.work(|| settled(state, variant))?;
    let h = smoothing_length(D);
    let mut pairs = Pairs::new(Kernel::WendlandC2, h, 1.0, skin, Domain::default());
    variant.apply(&mut pairs);
    largest.work(|| pairs.rebuild(&mut particles));
    let n = particles.len();
    let yardstick = largest.work(|| Yardstick::new(&particles, 0..n, h, ALPHA));
    let all_pairs = yardstick.pairs(0..n);

    let liquid = fluid(Flow::Plain);
    let momentum = Momentum {
        material: OneFluid::new(1.0, &liquid),
        pressure: OverDensitySquared,
        artificial_viscosity: ALPHA,
        viscosity: None,
        smoothing_length: h,
    };
    let model = JancikHyhlik::default();
    let volumes: Vec<f64> = (0..n).map(|i| particles.volume(i)).collect();
    let smoothed = Smoothed { weighted: &volumes };
    let mut colour = Vec::new();
    largest.work(|| pairs.sweep(&smoothed, &particles, everywhere(), &mut colour));
    for f in &mut colour {
        let stretched = model.slope * *f - model.slope + 1.0;
        *f = stretched.max(0.0).powi(model.power as i32);
    }
    let mut normal = Vec::new();
    let gradient = Gradient { values: &colour };
    largest.work(|| pairs.sweep(&gradient, &particles, everywhere(), &mut normal));
    let shortest = model.threshold / h;
    let near_surface = |rows: Range<usize>| normal[rows].iter().any(|n| n.norm() >= shortest);
    let curvature = Curvature {
        normal: &normal,
        shortest,
        weighting: Weighting::Volume,
    };
    let (pairs_near_surface, clusters) = (AtomicUsize::new(0), AtomicUsize::new(0));
    let counted = |rows: Range<usize>| {
        clusters.fetch_add(1, Ordering::Relaxed);
        let active = near_surface(rows.clone());
        if active {
            pairs_near_surface.fetch_add(yardstick.pairs(rows), Ordering::Relaxed);
        }
        active
    };
    largest.work(|| pairs.sweep(&smoothed, &particles, &counted as Active, &mut Vec::new()));
    let few = pairs_near_surface.into_inner();
    let mut sorted = particles.clone();
    let (mut rates, mut accelerations) = (Vec::new(), Vec::new());
    let (mut scalars, mut vectors, mut divergences) = (Vec::new(), Vec::new(), Vec::new());
    let mut smoothed_again = Vec::new();
    let (all, few) = ((all_pairs, everywhere()), (few, &near_surface as Active));
    let mut subjects = vec![
        Subject {
            name: "lists",
            formula: None,
            run: Box::new(move |pairs| pairs.rebuild(&mut sorted)),
        },
        subject("continuity", Continuity, &particles, all, &mut rates),
        subject("momentum", momentum, &particles, all, &mut accelerations),
        subject("colour", smoothed, &particles, all, &mut scalars),
        subject("normal", gradient, &particles, all, &mut vectors),
        subject("curvature", curvature, &particles, few, &mut divergences),
        // The weights differ; any numbers take as long.
        subject("smoothing", smoothed, &particles, few, &mut smoothed_again),
    ];
    let pace = Pace::new(&yardstick);
    let (samples, paces) = alternate(&mut subjects, pace, &mut pairs, n, crews, effort);
    let mut sweeps = Vec::new();
    for (subject, samples) in subjects.iter().zip(&samples) {
        for ((crew, peak), own) in crews.iter().zip(peaks).zip(samples) {
            let cost = own.cost();
            sweeps.push(SweepCost {
                name: subject.name,
                threads: crew.threads,
                cost,
                pair: (subject.formula).map(|formula| of(cost, formula, n, variant, peak)),
                speed_up: samples[0].wall_over(own),
            });
        }
    }
    drop(subjects);
    let (difference_of_continuity, difference_of_momentum) =
        differences(&yardstick, &rates, &accelerations);
    let lanes = (clusters.into_inner() * pairs.cluster_width()) as f64;
    Ok(Still {
        difference_of_continuity,
        difference_of_momentum,
        neighbours: all_pairs as f64 / n as f64,
        skin,
        lane_use: all_pairs as f64 / (pairs.entries_per_cluster() * lanes),
        yardstick: paces,
        sweeps,
    })
}

/// Particles with the densities of a running flow, and the skin that it chose.
fn settled<const D: usize>(
    state: &State<D>,
    variant: Variant,
) -> Result<(Particles<D>, f64), BenchError>
where
    Space: Dimension<D>,
{
    let mut simulation = state.simulation(Flow::Plain, variant)?;
    let first = simulation.pairs().builds();
    while simulation.steps() < 12 && simulation.pairs().builds() < first + 2 {
        simulation.step()?;
    }
    let skin = simulation.pairs().skin();
    Ok((simulation.particles().clone(), skin))
}

fn subject<'a, T, const D: usize>(
    name: &'static str,
    term: T,
    particles: &'a Particles<D>,
    (pairs, active): (usize, Active<'a>),
    sums: &'a mut Vec<T::Sum<f64>>,
) -> Subject<'a, D>
where
    T: PairTerm<D> + Send + 'a,
{
    Subject {
        name,
        formula: Some((of_pair::<WendlandC2, T, D>(&term), pairs)),
        run: Box::new(move |pairs| pairs.sweep(&term, particles, active, sums)),
    }
}

/// Which rows a sweep works on. One type for all sweeps: for each type of it
/// the engine would be compiled once more.
type Active<'a> = &'a (dyn Fn(Range<usize>) -> bool + Sync);

fn everywhere() -> Active<'static> {
    &|_| true
}

/// The largest difference of continuity from the yardstick's over the largest
/// value, and that of momentum.
fn differences<const D: usize>(
    yardstick: &Yardstick<D>,
    rates: &[f64],
    accelerations: &[Vector<f64, D>],
) -> (f64, f64) {
    let mut own_rates = vec![0.0; rates.len()];
    yardstick.continuity(0, &mut own_rates);
    let mut own_accelerations = vec![Vector::ZERO; accelerations.len()];
    yardstick.momentum(0, &mut own_accelerations);
    let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, f64::max);
    let of_rates = largest(&mut rates.iter().zip(&own_rates).map(|(a, b)| (a - b).abs()))
        / largest(&mut own_rates.iter().map(|rate| rate.abs()));
    let pairs = accelerations.iter().zip(&own_accelerations);
    let of_accelerations = largest(&mut pairs.map(|(a, b)| (*a - *b).norm()))
        / largest(&mut own_accelerations.iter().map(Vector::norm));
    (of_rates, of_accelerations)
}

/// Samples of each subject on each crew, in turn with the yardstick.
fn alternate<const D: usize>(
    subjects: &mut [Subject<D>],
    mut pace: Pace<D>,
    pairs: &mut Pairs<D>,
    particles: usize,
    crews: &[Crew],
    effort: Effort,
) -> (Vec<Vec<Samples>>, Vec<(usize, f64)>) {
    let mut samples = vec![vec![Samples::default(); crews.len()]; subjects.len()];
    let mut paces = vec![Vec::new(); crews.len()];
    // The first runs grow buffers, and tell how many make a sample.
    let repeats: Vec<usize> = (subjects.iter_mut())
        .map(|subject| {
            let mut once = || crews[0].time(|| (subject.run)(pairs)).seconds;
            once();
            (effort.sample / once().max(1e-9)).ceil().max(1.0) as usize
        })
        .collect();
    let begin = Instant::now();
    for round in 0..effort.samples {
        if round >= effort.fewest && begin.elapsed().as_secs_f64() > effort.budget {
            break;
        }
        for (c, crew) in crews.iter().enumerate() {
            let yardstick = pace.sample(crew, effort.sample);
            paces[c].push(yardstick);
            for ((subject, samples), &repeats) in
                subjects.iter_mut().zip(&mut samples).zip(&repeats)
            {
                let repeats = repeats * crew.threads;
                let spent = crew.time(|| (0..repeats).for_each(|_| (subject.run)(pairs)));
                samples[c].push(spent, (particles * repeats) as f64, yardstick);
            }
        }
    }
    let paces = (crews.iter().zip(paces))
        .map(|(crew, paces)| (crew.threads, 1e9 * crate::clock::median(paces)))
        .collect();
    (samples, paces)
}

fn of(
    cost: Cost,
    (operations, pairs): (Operations, usize),
    particles: usize,
    variant: Variant,
    peak: &Peak,
) -> PairCost {
    let nanoseconds = cost.nanoseconds * particles as f64 / pairs as f64;
    let gigaflops = f64::from(operations.flops) / nanoseconds;
    let most = match variant.precision {
        Precision::Double => peak.gigaflops_f64,
        Precision::Mixed => peak.gigaflops_f32,
    };
    PairCost {
        nanoseconds,
        rate: 1e9 / nanoseconds,
        flops: operations.flops,
        other_operations: operations.others,
        share_of_peak: gigaflops / most,
    }
}
