//! What something costs, from samples that alternate with the yardstick.

use meniscus::Vector;
use rayon::prelude::*;
use serde::Serialize;

use crate::clock::{Crew, Spent, median};
use crate::yardstick::Yardstick;

/// About what the yardstick takes, s/particle; it only sets the length of a sample.
const YARDSTICK_GUESS: f64 = 6e-7;
const ROWS_PER_TASK: usize = 1024;

/// A cost per particle.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Cost {
    /// Median, ns: on the core for one thread, by the wall for several.
    pub nanoseconds: f64,
    /// Least, ns.
    pub best: f64,
    /// Median by the wall, ns.
    pub wall: f64,
    /// Median of cost over that of the yardstick's continuity and momentum beside it.
    pub yardsticks: f64,
    /// How many samples.
    pub samples: usize,
}

/// Samples of one cost, each per particle, s.
#[derive(Clone, Debug, Default)]
pub struct Samples {
    spent: Vec<Spent>,
    yardstick: Vec<f64>,
}

impl Samples {
    /// One more: `spent` on `particles` particles, with the yardstick's seconds beside it.
    pub fn push(&mut self, spent: Spent, particles: f64, yardstick: f64) {
        self.spent.push(Spent {
            seconds: spent.seconds / particles,
            wall: spent.wall / particles,
        });
        self.yardstick.push(yardstick);
    }

    /// What they say.
    pub fn cost(&self) -> Cost {
        let seconds = || self.spent.iter().map(|spent| spent.seconds);
        let ratios = seconds().zip(&self.yardstick).map(|(s, y)| s / y);
        Cost {
            nanoseconds: 1e9 * median(seconds()),
            best: 1e9 * seconds().fold(f64::INFINITY, f64::min),
            wall: 1e9 * median(self.spent.iter().map(|spent| spent.wall)),
            yardsticks: median(ratios),
            samples: self.spent.len(),
        }
    }

    /// Median of wall time over that of `other`, sample by sample.
    pub fn wall_over(&self, other: &Samples) -> f64 {
        let pairs = self.spent.iter().zip(&other.spent);
        median(pairs.map(|(own, other)| own.wall / other.wall))
    }
}

/// The yardstick at work: a block of rows at a time, going round.
#[derive(Debug)]
pub struct Pace<'a, const D: usize> {
    yardstick: &'a Yardstick<'a, D>,
    next: usize,
    rates: Vec<f64>,
    accelerations: Vec<Vector<f64, D>>,
}

impl<'a, const D: usize> Pace<'a, D> {
    /// A yardstick that has not moved yet.
    pub fn new(yardstick: &'a Yardstick<'a, D>) -> Self {
        Self {
            yardstick,
            next: yardstick.rows().start,
            rates: Vec::new(),
            accelerations: Vec::new(),
        }
    }

    /// Continuity and momentum for about `seconds`; gives s/particle.
    pub fn sample(&mut self, crew: &Crew, seconds: f64) -> f64 {
        let all = self.yardstick.rows();
        let rows = ((seconds / YARDSTICK_GUESS) as usize * crew.threads).clamp(1, all.len());
        if self.next + rows > all.end {
            self.next = all.start;
        }
        let first = self.next;
        self.next += rows;
        self.rates.resize(rows, 0.0);
        self.accelerations.resize(rows, Vector::ZERO);
        let yardstick = self.yardstick;
        let (rates, accelerations) = (&mut self.rates, &mut self.accelerations);
        let spent = crew.time(|| {
            (rates.par_chunks_mut(ROWS_PER_TASK).enumerate()).for_each(|(k, rates)| {
                yardstick.continuity(first + k * ROWS_PER_TASK, rates);
            });
            (accelerations.par_chunks_mut(ROWS_PER_TASK).enumerate()).for_each(|(k, rows)| {
                yardstick.momentum(first + k * ROWS_PER_TASK, rows);
            });
        });
        std::hint::black_box((&self.rates, &self.accelerations));
        spent.seconds / rows as f64
    }
}
