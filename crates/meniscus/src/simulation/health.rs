//! Whether a flow is sound, and what is told of one that is not.

use rayon::prelude::*;

use super::Simulation;
use crate::divergence::{Circumstances, Diverged, Failure, check};
use crate::particles::ROWS_PER_TASK;

/// An adaptive step shorter than this part of h / c counts as collapsed.
const COLLAPSED: f64 = 1e-4;

impl<const D: usize> Simulation<D> {
    pub(super) fn check_state(&self) -> Result<(), Diverged> {
        let (particles, fluids) = (&self.particles, &self.rates.fluids);
        let bad = (0..particles.len())
            .into_par_iter()
            .with_min_len(ROWS_PER_TASK)
            .filter(|&i| check(particles, fluids, i).is_some())
            .min();
        if let Some(i) = bad {
            let failure = check(particles, fluids, i).unwrap_or(Failure::NotFinite);
            return Err(self.diverged(i, failure));
        }
        Ok(())
    }

    pub(super) fn check_step(&self) -> Result<(), Diverged> {
        let fastest =
            (self.rates.fluids.iter()).fold(0.0, |c: f64, fluid| c.max(fluid.sound_speed));
        let acoustic = self.rates.scheme.smoothing_length / fastest;
        if self.next_step < COLLAPSED * acoustic && self.rates.scheme.time_step.is_adaptive() {
            let a = &self.particles.acceleration;
            let i = (0..a.len())
                .max_by(|&i, &j| a[i].norm_squared().total_cmp(&a[j].norm_squared()))
                .unwrap_or(0);
            return Err(self.diverged(
                i,
                Failure::StepCollapsed {
                    step: self.next_step,
                    acoustic,
                },
            ));
        }
        Ok(())
    }

    fn circumstances(&self) -> Circumstances {
        let fluids = &self.rates.fluids;
        let slowest = fluids
            .iter()
            .fold(f64::INFINITY, |c, fluid| c.min(fluid.sound_speed));
        Circumstances {
            step_over_limit: self.next_step / self.limits.governing().1,
            mach_number: self.largest_speed / slowest,
            artificial_viscosity: self.rates.scheme.artificial_viscosity,
        }
    }

    fn diverged(&self, i: usize, failure: Failure) -> Diverged {
        Diverged {
            step: self.steps,
            time: self.time,
            particle: self.particles.id[i],
            dimension: D,
            position: self.particles.position[i].to_3d(),
            failure,
            culprit: Box::new((self.table.diagnose)(
                &self.rates,
                &self.particles,
                &self.domain,
                self.time,
                i,
            )),
            circumstances: self.circumstances(),
        }
    }
}
