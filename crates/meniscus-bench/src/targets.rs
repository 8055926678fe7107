//! What the engine is to reach, beside what was measured. The figures are
//! for one AVX-512 core, about 75 neighbours in 3D and 26 in 2D, on a lattice
//! unless said otherwise; other machines have the ratios.

use serde::Serialize;

use crate::state::{Arrangement, Flow};
use crate::steps::StepCost;
use crate::{Costs, Findings};

/// Size that the targets are stated for.
const USUAL_SIZE: usize = 125_000;
/// Size that is to cost the same for each particle.
const LARGE_SIZE: usize = 1_000_000;

/// Something to reach.
#[derive(Clone, Debug, Serialize)]
pub struct Target {
    /// What.
    pub what: String,
    /// "double" or "mixed".
    pub precision: &'static str,
    /// Unit of both numbers.
    pub unit: &'static str,
    /// To reach.
    pub wanted: f64,
    /// Whether more is better.
    pub more_is_better: bool,
    /// What was measured, if it was.
    pub measured: Option<f64>,
    /// Whether that is as good.
    pub reached: Option<bool>,
}

/// All targets.
pub fn all(findings: &Findings) -> Vec<Target> {
    let mut targets = Vec::new();
    let mut precisions: Vec<_> = (findings.costs.iter())
        .map(|costs| costs.variant.precision)
        .collect();
    precisions.dedup();
    precisions.sort_unstable();
    precisions.dedup();
    for precision in precisions {
        let book = Book {
            findings,
            precision,
        };
        book.write(&mut targets);
    }
    targets
}

struct Book<'a> {
    findings: &'a Findings,
    precision: &'static str,
}

impl Book<'_> {
    fn write(&self, targets: &mut Vec<Target>) {
        let either = |double: f64, mixed: f64| match self.precision {
            "mixed" => mixed,
            _ => double,
        };
        let size = self.usual_size();
        let named = |what: &str| match size {
            Some(size) => format!("{what}, {size} particles"),
            None => what.to_owned(),
        };
        let mut add = |what, unit, wanted: f64, more_is_better, measured: Option<f64>| {
            let good = |measured: f64| match more_is_better {
                true => measured >= wanted,
                false => measured <= wanted,
            };
            targets.push(Target {
                what,
                precision: self.precision,
                unit,
                wanted,
                more_is_better,
                measured,
                reached: measured.map(good),
            });
        };
        let sweeps = named("3D gradient and momentum sweeps");
        add(
            sweeps,
            "ns/particle",
            either(140.0, 90.0),
            false,
            self.sweeps(),
        );
        let flows = [
            (3, Flow::Plain, 5.0, 7.5),
            (2, Flow::Plain, 10.5, 15.0),
            (3, Flow::Csf, 2.5, 4.0),
        ];
        for (dimension, flow, double, mixed) in flows {
            let rate = self.rate(dimension, Arrangement::Lattice, size, flow);
            let what = named(&format!("{dimension}D whole step, {}", flow.name()));
            add(
                what,
                "M/s",
                either(double, mixed),
                true,
                rate.map(|r| 1e-6 * r),
            );
        }
        let slowdown = |arrangement, other_size| {
            flows.into_iter().filter_map(move |(dimension, flow, ..)| {
                let usual = self.rate(dimension, Arrangement::Lattice, size, flow)?;
                Some(1.0 - self.rate(dimension, arrangement, other_size, flow)? / usual)
            })
        };
        let large = slowdown(Arrangement::Lattice, Some(LARGE_SIZE));
        let large = large.filter(|_| size.is_some_and(|size| size < LARGE_SIZE));
        let what = named(&format!("{LARGE_SIZE} particles slower than"));
        add(
            what.replace("than,", "than"),
            "% at most",
            15.0,
            false,
            worst(large),
        );
        let splash = slowdown(Arrangement::Splash, size);
        let what = named("splash slower than lattice");
        add(what, "% at most", 25.0, false, worst(splash));
        for dimension in [2, 3] {
            let rate = |flow| self.rate(dimension, Arrangement::Lattice, size, flow);
            let ratio = (rate(Flow::Summation).zip(rate(Flow::Adaptive)))
                .map(|(constant, adaptive)| constant / adaptive);
            let what = format!("{dimension}D step, adaptive smoothing against one length");
            add(named(&what), "times at most", 1.5, false, ratio);
        }
        let memory = (self.findings.memory.iter())
            .find(|memory| memory.variant.precision == self.precision && memory.dimension == 3);
        let what = "3D memory all told".to_owned();
        add(what, "B/particle", 400.0, false, memory.map(|m| m.held));
        let threads = named("2 threads against 1, the least of all whole steps");
        add(threads, "times", 1.9, true, self.two_threads(size));
    }

    fn costs(&self) -> impl Iterator<Item = &Costs> {
        (self.findings.costs.iter()).filter(|costs| costs.variant.precision == self.precision)
    }

    /// 125 k, or the largest that was measured.
    fn usual_size(&self) -> Option<usize> {
        let sizes = || self.costs().map(|costs| costs.particles);
        sizes().find(|&size| size == USUAL_SIZE).or(sizes().max())
    }

    fn sweeps(&self) -> Option<f64> {
        let lattice = |costs: &&Costs| {
            costs.dimension == 3
                && costs.arrangement == Arrangement::Lattice
                && Some(costs.particles) == self.usual_size()
        };
        let still = &self.costs().find(lattice)?.still;
        let cost = |name| {
            let alone = still
                .sweeps
                .iter()
                .find(|s| s.name == name && s.threads == 1);
            alone.map(|sweep| sweep.cost.nanoseconds)
        };
        Some(cost("normal")? + cost("momentum")?)
    }

    fn steps(
        &self,
        dimension: usize,
        arrangement: Arrangement,
        size: Option<usize>,
    ) -> impl Iterator<Item = &StepCost> {
        let wanted = move |costs: &&Costs| {
            costs.dimension == dimension
                && costs.arrangement == arrangement
                && Some(costs.particles) == size
        };
        self.costs().filter(wanted).flat_map(|costs| &costs.steps)
    }

    /// Of one thread, particle-steps a second.
    fn rate(
        &self,
        dimension: usize,
        arrangement: Arrangement,
        size: Option<usize>,
        flow: Flow,
    ) -> Option<f64> {
        self.steps(dimension, arrangement, size)
            .find(|step| step.flow == flow && step.threads == 1)
            .map(|step| step.rate)
    }

    fn two_threads(&self, size: Option<usize>) -> Option<f64> {
        [2, 3]
            .into_iter()
            .flat_map(|dimension| self.steps(dimension, Arrangement::Lattice, size))
            .filter(|step| step.threads == 2)
            .map(|step| step.speed_up)
            .reduce(f64::min)
    }
}

/// The largest, in percent.
fn worst(shares: impl Iterator<Item = f64>) -> Option<f64> {
    shares.map(|share| 100.0 * share).reduce(f64::max)
}
