//! `run` and `resume`: marches a case and writes its folder.

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, OnceLock};
use std::time::{Duration, Instant};

use meniscus::rates::{Dimension, Space};
use meniscus::{Simulation, Snapshot};
use meniscus_case::Case;
use meniscus_output::{Checkpoints, FrameWriter, RunFolder, SeriesWriter};
use serde::{Deserialize, Serialize};

use crate::failure::Failure;
use crate::page;
use crate::progress::{Progress, Voice, duration, seconds};
use crate::sample::{Sampler, frame};

/// Layout of [`Snapshot`]; counts up when its fields change.
const STATE_VERSION: u32 = 1;
/// A checkpoint is written at least this often, whatever the case says.
const CHECKPOINT_EVERY: Duration = Duration::from_secs(600);

/// What `run.json` tells of a run.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct RunRecord {
    /// Version of the program.
    pub version: String,
    /// "running", "complete", "interrupted" or "diverged".
    pub status: String,
    /// Operating system and architecture.
    pub machine: String,
    /// Threads used.
    pub threads: usize,
    /// Number of particles.
    pub particles: usize,
    /// Steps so far.
    pub steps: u64,
    /// Simulated time, s.
    pub time: f64,
    /// Wall-clock time of all sessions, s.
    pub wall_time: f64,
    /// Particle-steps per second of wall-clock time.
    pub particle_steps_per_second: f64,
    /// Dimensionless numbers by name.
    pub dimensionless: Vec<(String, f64)>,
    /// What was measured.
    pub findings: Vec<crate::findings::Finding>,
}

/// Runs a case file.
pub fn run(
    path: &Path,
    out: Option<&Path>,
    force: bool,
    voice: Voice,
) -> Result<ExitCode, Failure> {
    let case = Case::from_file(path)?;
    warn(&case);
    let root = out.map_or_else(|| Path::new("out").join(&case.name), Path::to_path_buf);
    let folder = RunFolder::create(&root, case.to_toml(), force)?;
    let record = start(&case, &folder, voice)?;
    Ok(exit_code(&record))
}

/// Goes on with a run.
pub fn resume(root: &Path, voice: Voice) -> Result<ExitCode, Failure> {
    let folder = RunFolder::open(root)?;
    let mut case = Case::from_str(
        &folder.case_file().display().to_string(),
        &folder.read_case()?,
    )?;
    case.name = name_of(root);
    let record = match case.dimension {
        2 => resume_in::<2>(&case, &folder, voice)?,
        _ => resume_in::<3>(&case, &folder, voice)?,
    };
    Ok(exit_code(&record))
}

/// The name of a run: that of its folder.
pub fn name_of(root: &Path) -> String {
    let full = std::path::absolute(root).unwrap_or_else(|_| root.to_path_buf());
    full.file_name()
        .map_or_else(|| "run".into(), |name| name.to_string_lossy().into_owned())
}

fn exit_code(record: &RunRecord) -> ExitCode {
    // As a shell reports a program that Ctrl-C ended.
    if record.status == "interrupted" {
        ExitCode::from(130)
    } else {
        ExitCode::SUCCESS
    }
}

fn warn(case: &Case) {
    if !case.warnings.is_empty() {
        let colour = std::io::IsTerminal::is_terminal(&std::io::stderr());
        eprintln!("{}", case.warnings.render(colour));
    }
}

/// Runs a case from its start into a fresh folder.
pub fn start(case: &Case, folder: &RunFolder, voice: Voice) -> Result<RunRecord, Failure> {
    match case.dimension {
        2 => start_in::<2>(case, folder, voice),
        _ => start_in::<3>(case, folder, voice),
    }
}

fn start_in<const D: usize>(
    case: &Case,
    folder: &RunFolder,
    voice: Voice,
) -> Result<RunRecord, Failure>
where
    Space: Dimension<D>,
{
    let simulation = Simulation::<D>::new(case.setup()).map_err(|e| Failure::new(e.to_string()))?;
    let sampler = Sampler::<D>::new(case);
    let series = SeriesWriter::create(&folder.series_file(), &sampler.columns())?;
    let frames = FrameWriter::create(&folder.frames_folder())?;
    voice.say(&format!(
        "{}: {} particles in {}D, {} to {}",
        case.name,
        case.particle_count(),
        D,
        seconds(case.end_time),
        folder.root().display()
    ));
    March {
        case,
        folder,
        voice,
        sampler,
        simulation,
        series,
        frames,
        earlier: 0.0,
    }
    .go(true)
}

fn resume_in<const D: usize>(
    case: &Case,
    folder: &RunFolder,
    voice: Voice,
) -> Result<RunRecord, Failure>
where
    Space: Dimension<D>,
{
    let checkpoints = Checkpoints::open(&folder.checkpoints_folder(), STATE_VERSION)?;
    let restored = checkpoints.latest_good::<Snapshot>()?;
    for error in &restored.passed_over {
        eprintln!("warning: passed over a damaged checkpoint: {error}");
    }
    let snapshot = restored.checkpoint.state;
    let simulation = Simulation::<D>::restore(case.setup(), &snapshot)
        .map_err(|e| Failure::new(format!("{}: {e}", restored.path.display())))?;
    let sampler = Sampler::<D>::new(case);
    let series = SeriesWriter::resume(&folder.series_file(), &sampler.columns(), snapshot.time)?;
    let frames = FrameWriter::resume(&folder.frames_folder(), snapshot.time)?;
    voice.say(&format!(
        "{}: going on from step {}, t = {}, of {}",
        case.name,
        snapshot.steps,
        seconds(snapshot.time),
        restored.path.display()
    ));
    let earlier = page::read_record(folder).map_or(0.0, |record| record.wall_time);
    March {
        case,
        folder,
        voice,
        sampler,
        simulation,
        series,
        frames,
        earlier,
    }
    .go(false)
}

/// The next time at which something is due, from its interval.
struct Due {
    interval: f64,
    next: f64,
}

impl Due {
    /// Things due up to `time` count as done.
    fn after(interval: f64, time: f64) -> Self {
        let mut due = Self {
            interval,
            next: 0.0,
        };
        due.done(time);
        due
    }

    fn is_due(&self, time: f64) -> bool {
        time >= self.next
    }

    fn done(&mut self, time: f64) {
        self.next = ((time / self.interval).floor() + 1.0) * self.interval;
    }
}

struct March<'a, const D: usize> {
    case: &'a Case,
    folder: &'a RunFolder,
    voice: Voice,
    sampler: Sampler<'a, D>,
    simulation: Simulation<D>,
    series: SeriesWriter,
    frames: FrameWriter,
    /// Wall-clock time of earlier sessions, s.
    earlier: f64,
}

impl<const D: usize> March<'_, D> {
    fn go(mut self, from_start: bool) -> Result<RunRecord, Failure> {
        let stop = stop_flag()?;
        let begin = Instant::now();
        let checkpoints = Checkpoints::open(&self.folder.checkpoints_folder(), STATE_VERSION)?;
        let first_step = self.simulation.steps();
        let end = self.case.end_time;
        let mut progress = Progress::new(
            self.voice,
            self.case.particle_count(),
            first_step,
            self.simulation.time(),
            end,
        );
        if from_start {
            self.series.append(&self.sampler.row(&self.simulation))?;
            self.frames.write(&frame(&self.simulation))?;
            checkpoints.save(0, 0.0, &self.simulation.snapshot())?;
        }
        let mut record = self.record("running", begin, first_step);
        self.folder.write_run(&record)?;
        let time = self.simulation.time();
        let mut series_due = Due::after(self.case.output.series, time);
        let mut frame_due = Due::after(self.case.output.frames, time);
        let mut checkpoint_due = Due::after(self.case.output.checkpoints, time);
        let mut last_checkpoint = Instant::now();
        let mut saved = self.simulation.steps();
        while self.simulation.time() < end && !stop.load(Ordering::Relaxed) {
            if let Err(diverged) = self.simulation.step() {
                progress.finish();
                self.folder
                    .write_run(&self.record("diverged", begin, first_step))?;
                return Err(Failure::diverged(&diverged, &self.how_to_go_on()));
            }
            let time = self.simulation.time();
            let at_end = time >= end;
            if series_due.is_due(time) || at_end {
                series_due.done(time);
                self.series.append(&self.sampler.row(&self.simulation))?;
            }
            if frame_due.is_due(time) || at_end {
                frame_due.done(time);
                let path = self.frames.write(&frame(&self.simulation))?;
                self.tell(&progress, &path);
            }
            if checkpoint_due.is_due(time) || at_end || last_checkpoint.elapsed() > CHECKPOINT_EVERY
            {
                checkpoint_due.done(time);
                last_checkpoint = Instant::now();
                saved = self.simulation.steps();
                let path = checkpoints.save(saved, time, &self.simulation.snapshot())?;
                self.tell(&progress, &path);
            }
            progress.update(self.simulation.steps(), time);
        }
        progress.finish();
        let complete = self.simulation.time() >= end;
        if saved != self.simulation.steps() {
            checkpoints.save(
                self.simulation.steps(),
                self.simulation.time(),
                &self.simulation.snapshot(),
            )?;
        }
        record = self.record(
            if complete { "complete" } else { "interrupted" },
            begin,
            first_step,
        );
        if complete {
            page::conclude(self.case, self.folder, &mut record, self.voice)?;
        }
        self.folder.write_run(&record)?;
        if !complete {
            self.voice.say(&format!(
                "stopped at step {}, t = {}; {}",
                self.simulation.steps(),
                seconds(self.simulation.time()),
                self.how_to_go_on()
            ));
        }
        Ok(record)
    }

    fn tell(&self, progress: &Progress, path: &PathBuf) {
        if self.voice.verbose {
            progress.say(&format!("wrote {}", path.display()));
        }
    }

    fn how_to_go_on(&self) -> String {
        format!(
            "to go on from the last checkpoint: meniscus resume {}",
            self.folder.root().display()
        )
    }

    fn record(&self, status: &str, begin: Instant, first_step: u64) -> RunRecord {
        let elapsed = begin.elapsed().as_secs_f64();
        let steps = self.simulation.steps();
        let particles = self.case.particle_count();
        RunRecord {
            version: env!("CARGO_PKG_VERSION").into(),
            status: status.into(),
            machine: format!("{} {}", std::env::consts::OS, std::env::consts::ARCH),
            threads: rayon::current_num_threads(),
            particles,
            steps,
            time: self.simulation.time(),
            wall_time: self.earlier + elapsed,
            particle_steps_per_second: (steps - first_step) as f64 * particles as f64
                / elapsed.max(1e-9),
            dimensionless: crate::numbers::of(self.case)
                .into_iter()
                .map(|number| (number.name.to_owned(), number.value))
                .collect(),
            findings: Vec::new(),
        }
    }
}

/// Set by Ctrl-C; the same for all runs of the process. A second Ctrl-C ends at once.
fn stop_flag() -> Result<Arc<AtomicBool>, Failure> {
    static FLAG: OnceLock<Arc<AtomicBool>> = OnceLock::new();
    if let Some(flag) = FLAG.get() {
        return Ok(flag.clone());
    }
    let flag = FLAG.get_or_init(Arc::default).clone();
    let set = flag.clone();
    let handler = ctrlc::set_handler(move || {
        if set.swap(true, Ordering::Relaxed) {
            std::process::exit(130);
        }
        eprintln!("\nfinishing the step and writing a checkpoint (Ctrl-C again to end at once)");
    });
    match handler {
        Ok(()) | Err(ctrlc::Error::MultipleHandlers) => Ok(flag),
        Err(error) => Err(Failure::new(format!("cannot watch for Ctrl-C: {error}"))),
    }
}

/// A line on how fast a run was.
pub fn speed_line(record: &RunRecord) -> String {
    format!(
        "{} steps in {}, {:.2} M particle-steps/s on {} thread{}",
        record.steps,
        duration(record.wall_time),
        record.particle_steps_per_second * 1e-6,
        record.threads,
        if record.threads == 1 { "" } else { "s" },
    )
}
