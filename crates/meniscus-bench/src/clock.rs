//! Time spent, and what many samples of it say.
//!
//! On a machine that others use too, wall time measures them as well. A
//! single thread is therefore timed by the time that it was on a core. Several
//! threads can only be timed by the wall.

use std::time::Instant;

use cpu_time::ThreadTime;
use rayon::{ThreadPool, ThreadPoolBuildError, ThreadPoolBuilder};

/// Threads that work is measured on.
#[derive(Debug)]
pub struct Crew {
    /// How many.
    pub threads: usize,
    pool: ThreadPool,
}

/// What some work took, s.
#[derive(Clone, Copy, Debug, Default)]
pub struct Spent {
    /// Time on the core for one thread, wall time for several.
    pub seconds: f64,
    /// Wall time.
    pub wall: f64,
}

impl Crew {
    /// A crew of so many.
    ///
    /// # Errors
    /// If the system gives no more threads.
    pub fn new(threads: usize) -> Result<Self, ThreadPoolBuildError> {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build()?;
        Ok(Self { threads, pool })
    }

    /// Does `work` on this crew.
    pub fn work<R: Send>(&self, work: impl FnOnce() -> R + Send) -> R {
        self.pool.install(work)
    }

    /// Does `work` on each thread of this crew at once.
    pub fn work_each(&self, work: impl Fn() + Sync) -> Spent {
        let wall = Instant::now();
        let cpu = self.pool.broadcast(|_| {
            let cpu = ThreadTime::now();
            work();
            cpu.elapsed().as_secs_f64()
        });
        self.spent(wall.elapsed().as_secs_f64(), cpu[0])
    }

    /// Times `work` on this crew.
    pub fn time(&self, work: impl FnOnce() + Send) -> Spent {
        self.pool.install(|| {
            let (wall, cpu) = (Instant::now(), ThreadTime::now());
            work();
            self.spent(wall.elapsed().as_secs_f64(), cpu.elapsed().as_secs_f64())
        })
    }

    fn spent(&self, wall: f64, cpu: f64) -> Spent {
        let seconds = if self.threads == 1 { cpu } else { wall };
        Spent { seconds, wall }
    }
}

/// The middle of some values; NaN for none.
pub fn median(values: impl IntoIterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.into_iter().collect();
    values.sort_unstable_by(f64::total_cmp);
    let n = values.len();
    match n {
        0 => f64::NAN,
        _ => 0.5 * (values[(n - 1) / 2] + values[n / 2]),
    }
}
