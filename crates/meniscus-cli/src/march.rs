//! The march in time, and what it writes on the way.

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use meniscus::Simulation;
use meniscus::divergence::Diverged;
use meniscus_case::{Case, Deformation};
use meniscus_output::{Checkpoints, FrameWriter, RunFolder, SeriesWriter};

use crate::conclude::{file_of, write_report};
use crate::due::{Due, reached};
use crate::failure::Failure;
use crate::interrupt;
use crate::progress::Progress;
use crate::record::{RunRecord, Status};
use crate::sample::{Sampler, frame};
use crate::terminal::Voice;

/// Layout of [`meniscus::Snapshot`]; counts up when its fields change.
pub const STATE_VERSION: u32 = 5;
/// A checkpoint is written at least this often, whatever the case says.
const CHECKPOINT_EVERY: Duration = Duration::from_secs(600);

/// A run on its way.
pub struct March<'a, const D: usize> {
    /// What is run.
    pub case: &'a Case,
    /// Where to.
    pub folder: &'a RunFolder,
    /// How much is said.
    pub voice: Voice,
    /// What the series holds.
    pub sampler: Sampler<'a, D>,
    /// The flow, at its start or as a checkpoint left it.
    pub simulation: Simulation<D>,
    /// The series, up to there.
    pub series: SeriesWriter,
    /// The frames, up to there.
    pub frames: FrameWriter,
    /// The checkpoints.
    pub checkpoints: Checkpoints,
    /// The latest of them; none at the start.
    pub last_checkpoint: Option<PathBuf>,
    /// Wall-clock time of earlier sessions, s.
    pub earlier: f64,
}

impl<const D: usize> March<'_, D> {
    /// Marches to the end of the case, to Ctrl-C, or until the flow blows up.
    ///
    /// Row, frame and checkpoint of one instant are written in this order: a
    /// resume cuts the first two back to the checkpoint.
    pub fn go(mut self) -> Result<RunRecord, Failure> {
        interrupt::watch()?;
        self.settle();
        let begin = Instant::now();
        self.folder
            .write_run(&self.record(Status::Running, begin))?;
        if self.last_checkpoint.is_none() {
            self.deform_between(f64::NEG_INFINITY);
            self.series.append(&self.sampler.row(&self.simulation))?;
            self.frames.write(&frame(&self.simulation))?;
            self.save()?;
        }
        let (step, time) = (self.simulation.steps(), self.simulation.time());
        let (end, output) = (self.case.end_time, &self.case.output);
        let mut row_due = Due::after(output.series, time);
        let mut frame_due = Due::after(output.frames, time);
        let mut checkpoint_due = Due::after(output.checkpoints, time);
        let mut saved = (step, Instant::now());
        let mut progress = Progress::new(self.voice, self.case.particle_count(), step, time, end);
        while !reached(self.simulation.time(), end) && !interrupt::asked() {
            let time = self.simulation.time();
            if let Err(diverged) = self.simulation.step() {
                drop(progress);
                return Err(self.diverged(&diverged, begin));
            }
            self.deform_between(time);
            let (step, time) = (self.simulation.steps(), self.simulation.time());
            let at_end = reached(time, end);
            if row_due.take(time) || at_end {
                self.series.append(&self.sampler.row(&self.simulation))?;
            }
            if frame_due.take(time) || at_end {
                let path = self.frames.write(&frame(&self.simulation))?;
                self.tell(&progress, &path);
            }
            let long_ago = saved.1.elapsed() > CHECKPOINT_EVERY;
            if checkpoint_due.take(time) || at_end || long_ago {
                let path = self.save()?;
                self.tell(&progress, &path);
                saved = (step, Instant::now());
                // The time that this session took, should it be killed.
                self.folder
                    .write_run(&self.record(Status::Running, begin))?;
            }
            progress.update(step, time);
        }
        drop(progress);
        if saved.0 != self.simulation.steps() {
            self.save()?;
        }
        let status = if reached(self.simulation.time(), end) {
            Status::Complete
        } else {
            Status::Interrupted
        };
        let record = self.record(status, begin);
        self.folder.write_run(&record)?;
        Ok(record)
    }

    /// Sets the drag that belongs to the time.
    fn settle(&mut self) {
        let now = self.simulation.time();
        let before = |asked: &&Deformation| !reached(now, asked.time);
        let settling = self.case.deformation.as_ref().filter(before);
        let usual = self.case.scheme.damping;
        let rate = settling.map_or(usual, |asked| usual.max(asked.settling));
        self.simulation.set_damping(rate);
    }

    /// Draws the liquid out if its time has come since `earlier`, s.
    fn deform_between(&mut self, earlier: f64) {
        let Some(asked) = &self.case.deformation else {
            return;
        };
        if reached(earlier, asked.time) || !reached(self.simulation.time(), asked.time) {
            return;
        }
        // To the same volume: along y by aspect^((D - 1) / D), along the others by aspect^(-1 / D).
        let across = asked.aspect.powf(-1.0 / D as f64);
        let mut factors = [across; D];
        factors[1] = across * asked.aspect;
        self.simulation.stretch(factors);
        self.settle();
    }

    fn save(&mut self) -> Result<PathBuf, Failure> {
        let (step, time) = (self.simulation.steps(), self.simulation.time());
        let path = self
            .checkpoints
            .save(step, time, &self.simulation.snapshot())?;
        self.last_checkpoint = Some(path.clone());
        Ok(path)
    }

    fn tell(&self, progress: &Progress, path: &Path) {
        if self.voice.verbose {
            progress.say(&format!("wrote {}", path.display()));
        }
    }

    fn record(&self, status: Status, begin: Instant) -> RunRecord {
        let wall_time = self.earlier + begin.elapsed().as_secs_f64();
        let (step, time) = (self.simulation.steps(), self.simulation.time());
        RunRecord::new(self.case, status, step, time, wall_time)
    }

    /// Leaves the folder of a flow that blew up in good order.
    fn diverged(&self, diverged: &Diverged, begin: Instant) -> Failure {
        let mut record = self.record(Status::Diverged, begin);
        let left = self
            .folder
            .write_run(&record)
            .map_err(Failure::from)
            .and_then(|()| write_report(self.case, self.folder, &mut record));
        let report = match left {
            Ok(_) => format!("report of the run so far: {}", file_of(self.folder)),
            Err(failure) => format!("no report could be written: {}", failure.message()),
        };
        let checkpoint = self
            .last_checkpoint
            .as_ref()
            .map_or_else(String::new, |path| {
                format!("last good checkpoint: {}\n", path.display())
            });
        Failure::diverged(diverged, &format!("{checkpoint}{report}"))
    }
}
