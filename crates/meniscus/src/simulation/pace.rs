//! The length of the next step, and how far lists are to reach for it.

use rayon::prelude::*;

use super::Simulation;
use crate::particles::ROWS_PER_TASK;
use crate::scheme::TimeStep;
use crate::time::step::StepLimits;
use crate::vector::Vector;

/// Bounds of the skin of lists, in spacings.
const LEAST_SKIN: f64 = 0.02;
const LARGEST_SKIN: f64 = 0.5;

/// Cost of new lists over that of one step's sweeps, as measured in 2D and 3D.
const COST_OF_LISTS: f64 = 1.0;

impl<const D: usize> Simulation<D> {
    pub(crate) fn choose_step(&mut self) {
        let scheme = &self.rates.scheme;
        let largest = |column: &[Vector<f64, D>]| {
            (column.par_iter().with_min_len(ROWS_PER_TASK))
                .map(Vector::norm_squared)
                .reduce(|| 0.0, f64::max)
                .sqrt()
        };
        self.largest_speed = largest(&self.particles.velocity);
        let largest_acceleration = largest(&self.particles.acceleration);
        let shortest = match scheme.adaptive_smoothing {
            None => scheme.smoothing_length,
            Some(_) => shortest(&self.particles.smoothing_length),
        };
        let support = scheme.kernel.support() * shortest;
        let limits = StepLimits::new(
            &self.rates.fluids,
            shortest,
            support,
            self.largest_speed,
            largest_acceleration,
        )
        .with_stiffness(self.rates.stiffness(largest_acceleration));
        self.limits = match &self.rates.van_der_waals {
            Some(fluid) => limits.with_van_der_waals(
                fluid.flow.stiffness(&self.particles),
                support,
                self.largest_speed,
            ),
            None => limits,
        };
        self.next_step = match scheme.time_step {
            TimeStep::Fixed(dt) => dt,
            TimeStep::Adaptive { safety } => safety * self.limits.governing().1,
        };
    }

    pub(super) fn refresh_lists(&mut self) {
        if self.rates.pairs.is_stale(&self.particles) {
            let skin = self.best_skin();
            self.rates.pairs.set_skin(skin);
            (self.table.rebuild)(&mut self.rates.pairs, &mut self.particles);
        }
    }

    /// The skin s that makes sweeps and new lists together cheapest, m: with a
    /// motion of u a step, lists live s / (2 u) steps, and a sweep costs
    /// 1 + s D / (support + spacing) of its cost without a skin.
    fn best_skin(&self) -> f64 {
        let scheme = &self.rates.scheme;
        let reach = scheme.kernel.support() * scheme.smoothing_length + self.spacing;
        let motion = self.largest_speed * self.next_step;
        let best = (2.0 * motion * COST_OF_LISTS * reach / D as f64).sqrt();
        best.clamp(LEAST_SKIN * self.spacing, LARGEST_SKIN * self.spacing)
    }
}

/// The shortest of some lengths, m.
fn shortest(lengths: &[f64]) -> f64 {
    (lengths.par_iter().with_min_len(ROWS_PER_TASK).copied()).reduce(|| f64::INFINITY, f64::min)
}
