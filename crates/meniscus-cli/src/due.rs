//! When something that is written at intervals is due.

/// An instant this part of an interval away counts as reached: sums of time
/// steps carry rounding, which must not shift a row by a whole step.
const ROUNDING: f64 = 1e-6;

/// Something that is due once in every interval.
///
/// What is due depends on the time of this step and the one before alone, so
/// a resumed run writes at the steps at which the unbroken one does.
pub struct Due {
    interval: f64,
    /// Whole intervals passed.
    passed: f64,
}

impl Due {
    /// What was due up to `time` counts as done.
    pub fn after(interval: f64, time: f64) -> Self {
        let mut due = Self {
            interval,
            passed: f64::NEG_INFINITY,
        };
        due.take(time);
        due
    }

    /// Whether it is due at `time`, later than any time before; it counts as done then.
    pub fn take(&mut self, time: f64) -> bool {
        let passed = (time / self.interval + ROUNDING).floor();
        let due = passed > self.passed;
        self.passed = passed;
        due
    }
}

/// Whether a march has come to its end, but for rounding.
pub fn reached(time: f64, end: f64) -> bool {
    time >= end * (1.0 - 1e-9)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Steps at which something is due, counted from the step after `from`.
    fn due_steps(dt: f64, interval: f64, from: usize, to: usize) -> Vec<usize> {
        let mut time = 0.0;
        let mut times = vec![time];
        for _ in 0..to {
            time += dt;
            times.push(time);
        }
        let mut due = Due::after(interval, times[from]);
        (from + 1..=to).filter(|&k| due.take(times[k])).collect()
    }

    #[test]
    fn rounding_of_the_sum_of_steps_shifts_no_row() {
        let every_twentieth: Vec<usize> = (1..=500).map(|k| 20 * k).collect();
        assert_eq!(due_steps(1e-6, 20e-6, 0, 10_000), every_twentieth);
        assert_eq!(due_steps(0.1, 2.0, 0, 10_000), every_twentieth);
    }

    #[test]
    fn a_resumed_run_writes_at_the_same_steps_wherever_it_was_stopped() {
        for interval in [20e-6, 7e-6, 0.3e-6, 3.3e-6] {
            let whole = due_steps(1e-6, interval, 0, 400);
            for from in 0..400 {
                let rest: Vec<usize> = whole.iter().copied().filter(|&k| k > from).collect();
                assert_eq!(due_steps(1e-6, interval, from, 400), rest, "from {from}");
            }
        }
    }

    #[test]
    fn an_interval_shorter_than_a_step_is_due_at_every_step() {
        assert_eq!(due_steps(1.0, 0.1, 0, 5), [1, 2, 3, 4, 5]);
    }
}
