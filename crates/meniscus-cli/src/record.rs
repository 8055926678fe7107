//! `run.json`: what a folder tells of its run.

use std::path::Path;

use meniscus_case::Case;
use meniscus_output::RunFolder;
use serde::{Deserialize, Serialize};

use crate::failure::Failure;
use crate::findings::Finding;
use crate::numbers;
use crate::progress::{duration, seconds};

/// How a run stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Status {
    /// On its way; where no program writes into the folder, it was killed.
    Running,
    /// It came to its end.
    Complete,
    /// Ctrl-C stopped it.
    Interrupted,
    /// The flow blew up.
    Diverged,
}

/// What `run.json` tells of a run.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct RunRecord {
    /// Version of the program.
    pub version: String,
    /// Name of the case.
    pub case: String,
    /// How it stands.
    pub status: Status,
    /// Operating system and processor.
    pub machine: String,
    /// Threads used.
    pub threads: usize,
    /// Number of particles.
    pub particles: usize,
    /// Steps so far.
    pub steps: u64,
    /// Simulated time, s.
    pub time: f64,
    /// Wall-clock time of all sessions up to here, s.
    pub wall_time: f64,
    /// Dimensionless numbers by name.
    pub dimensionless: Vec<(String, f64)>,
    /// What was measured.
    pub findings: Vec<Finding>,
}

impl RunRecord {
    /// Of a run that has come to this step and time (s) in so much wall-clock time (s).
    pub fn new(case: &Case, status: Status, steps: u64, time: f64, wall_time: f64) -> Self {
        let dimensionless = numbers::of(case)
            .into_iter()
            .map(|number| (number.name.to_owned(), number.value));
        Self {
            version: env!("CARGO_PKG_VERSION").into(),
            case: case.name.clone(),
            status,
            machine: machine(),
            threads: rayon::current_num_threads(),
            particles: case.particle_count(),
            steps,
            time,
            wall_time,
            dimensionless: dimensionless.collect(),
            findings: Vec::new(),
        }
    }

    /// Reads that of a folder.
    ///
    /// # Errors
    /// If it is missing, damaged, or of another version of the program.
    pub fn read(folder: &RunFolder) -> Result<Self, Failure> {
        let path = folder.root().join("run.json");
        std::fs::read_to_string(&path)
            .map_err(|error| error.to_string())
            .and_then(|text| serde_json::from_str(&text).map_err(|error| error.to_string()))
            .map_err(|reason| {
                Failure::new(format!(
                    "cannot read {}: {reason}; `meniscus resume {}` writes it anew",
                    path.display(),
                    folder.root().display()
                ))
            })
    }

    /// A line on how fast the run was.
    pub fn speed(&self) -> String {
        let rate = self.steps as f64 * self.particles as f64 / self.wall_time.max(1e-9);
        format!(
            "{} steps in {}, {:.2} M particle-steps/s on {} thread{}",
            self.steps,
            duration(self.wall_time),
            rate * 1e-6,
            self.threads,
            if self.threads == 1 { "" } else { "s" },
        )
    }

    /// What a reader must know of a run that has not come to its end.
    pub fn reservation(&self, case: &Case, root: &Path) -> Option<String> {
        let how = match self.status {
            Status::Complete => return None,
            Status::Running => "ended before its time",
            Status::Interrupted => "was interrupted",
            Status::Diverged => "diverged",
        };
        let go_on = match self.status {
            Status::Diverged => String::new(),
            _ => format!(" To go on: meniscus resume {}", root.display()),
        };
        Some(format!(
            "The run {how} after t = {} of {}; what is shown is that part.{go_on}",
            seconds(self.time),
            seconds(case.end_time)
        ))
    }
}

/// Operating system, architecture, processor where the system tells.
fn machine() -> String {
    let system = format!("{} {}", std::env::consts::OS, std::env::consts::ARCH);
    let processor = std::fs::read_to_string("/proc/cpuinfo")
        .ok()
        .and_then(|text| {
            let line = text.lines().find(|line| line.starts_with("model name"))?;
            Some(line.split_once(':')?.1.trim().to_owned())
        });
    match processor {
        Some(processor) => format!("{system}, {processor}"),
        None => system,
    }
}
