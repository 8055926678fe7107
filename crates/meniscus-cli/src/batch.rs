//! Many cases, run side by side.

use std::collections::{BTreeMap, VecDeque};
use std::path::Path;
use std::sync::{Mutex, PoisonError};

use meniscus_case::Case;
use meniscus_output::RunFolder;

use crate::conclude::{measure, write_report};
use crate::failure::Failure;
use crate::findings::Finding;
use crate::record::{RunRecord, Status};
use crate::terminal::Voice;
use crate::{interrupt, runner};

/// A case to run, with its folder.
pub struct Job {
    /// What its outcome goes by.
    pub name: String,
    /// The case.
    pub case: Case,
    /// Where its files go.
    pub folder: RunFolder,
    /// How the run stands that is gone on with.
    standing: Option<RunRecord>,
}

/// What becomes of runs that stand where others are to go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Earlier {
    /// They are in the way.
    Refused,
    /// They are replaced.
    Replaced,
    /// Of the same case and version of the program, they are gone on with, or taken as they are where they came to their end.
    Continued,
}

impl Job {
    /// A job whose folder, named after the case, is made in `root`.
    ///
    /// # Errors
    /// If a run stands there already that is not to be replaced, or is another than the one to go on with.
    pub fn claim(name: &str, case: Case, root: &Path, earlier: Earlier) -> Result<Self, Failure> {
        let root = root.join(&case.name);
        let continued = earlier == Earlier::Continued && root.join("case.toml").is_file();
        let (folder, standing) = if continued {
            Self::take_up(&root, &case)?
        } else {
            let replace = earlier == Earlier::Replaced;
            (RunFolder::create(&root, case.to_toml(), replace)?, None)
        };
        Ok(Self {
            name: name.to_owned(),
            case,
            folder,
            standing,
        })
    }

    /// The folder of a run of this case, and how it stands; none where it starts anew, since it diverged or has no checkpoint.
    fn take_up(root: &Path, case: &Case) -> Result<(RunFolder, Option<RunRecord>), Failure> {
        let refuse = |whose: &str| {
            Err(Failure::new(format!(
                "{} holds a run {whose}: --continue goes on with runs of the same case and version alone, --force replaces any",
                root.display()
            )))
        };
        let folder = RunFolder::open(root)?;
        if folder.read_case()? != case.to_toml() {
            return refuse("of another case");
        }
        if root.join("run.json").is_file() {
            let record = RunRecord::read(&folder)?;
            if record.version != env!("CARGO_PKG_VERSION") {
                return refuse(&format!("of version {}", record.version));
            }
            let stands = match record.status {
                Status::Complete => true,
                Status::Diverged => false,
                Status::Running | Status::Interrupted => runner::can_go_on(&folder),
            };
            if stands {
                return Ok((folder, Some(record)));
            }
        }
        drop(folder);
        Ok((RunFolder::create(root, case.to_toml(), true)?, None))
    }

    /// Runs it to its end, from where it stands.
    fn run(&self, voice: Voice) -> Result<RunRecord, Failure> {
        match &self.standing {
            Some(record) if record.status == Status::Complete => Ok(record.clone()),
            Some(record) => runner::go_on(&self.case, &self.folder, record.wall_time, voice),
            None => runner::start(&self.case, &self.folder, voice),
        }
    }
}

/// What a case gave.
pub struct Done {
    /// Its numbers.
    pub findings: Vec<Finding>,
    /// What it took.
    pub record: RunRecord,
}

/// What a case gave, or why it gave nothing.
pub type Outcome = Result<Done, String>;

/// Whether reports and figures are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pages {
    /// Of every case.
    Written,
    /// Of none, for the sake of time: `meniscus report FOLDER` writes one later.
    Left,
}

/// Runs the jobs side by side, the threads of this pool shared out among them. A case that
/// fails costs its own outcome only.
pub fn run_all(
    mut jobs: Vec<Job>,
    pages: Pages,
    tell: &(dyn Fn(&str) + Sync),
) -> BTreeMap<String, Outcome> {
    // The longest first, so that none is left over alone at the end.
    let cost = |job: &Job| job.case.particle_count() as f64 * job.case.end_time / job.case.spacing;
    jobs.sort_by(|a, b| cost(b).total_cmp(&cost(a)));
    let threads = rayon::current_num_threads();
    let workers = threads.min(jobs.len()).max(1);
    let queue = Mutex::new(VecDeque::from(jobs));
    let outcomes = Mutex::new(BTreeMap::new());
    std::thread::scope(|scope| {
        for worker in 0..workers {
            let share = threads / workers + usize::from(worker < threads % workers);
            let (queue, outcomes) = (&queue, &outcomes);
            scope.spawn(move || {
                loop {
                    let next = queue
                        .lock()
                        .unwrap_or_else(PoisonError::into_inner)
                        .pop_front();
                    let Some(job) = next else { break };
                    let outcome = run_one(&job, pages, share, tell);
                    let mut all = outcomes.lock().unwrap_or_else(PoisonError::into_inner);
                    all.insert(job.name, outcome);
                }
            });
        }
    });
    outcomes
        .into_inner()
        .unwrap_or_else(PoisonError::into_inner)
}

fn run_one(job: &Job, pages: Pages, threads: usize, tell: &(dyn Fn(&str) + Sync)) -> Outcome {
    if interrupt::asked() {
        return Err(format!("{}: not run", job.case.name));
    }
    let silent = Voice {
        quiet: true,
        verbose: false,
    };
    let run = || -> Result<Done, Failure> {
        let mut record = job.run(silent)?;
        let measured = match pages {
            Pages::Written => write_report(&job.case, &job.folder, &mut record)?,
            Pages::Left => measure(&job.case, &job.folder, &mut record)?.0,
        };
        if record.status != Status::Complete {
            return Err(Failure::new("interrupted".into()));
        }
        let taken = (job.standing.as_ref()).is_some_and(|record| record.status == Status::Complete);
        let how = if taken {
            "taken as it stands".to_owned()
        } else {
            record.speed()
        };
        tell(&format!("{}: {how}", job.case.name));
        Ok(Done {
            findings: measured.numbers,
            record,
        })
    };
    rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .map_err(|error| Failure::new(format!("cannot start threads: {error}")))
        .and_then(|pool| pool.install(run))
        .map_err(|failure| format!("{}: {}", job.case.name, failure.message()))
}
