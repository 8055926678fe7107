//! `meniscus appraise`: one suite of tests over every model of surface tension.
//!
//! - `model`: which there are
//! - `calibrations`: how strong pairwise forces are
//! - `suite`: the tests; each makes `trial`s, case files with what is to be read from them
//! - `score`: what the runs came to
//! - `cost`: what their steps cost
//! - `page`, `plots`: the comparison for people; `advice`: which model for which flow;
//!   `time_to_solution`: at equal error

mod advice;
mod calibrations;
mod cost;
mod model;
mod page;
mod plots;
mod score;
mod suite;
mod time_to_solution;
mod trial;

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

use clap::Args;
use meniscus_case::Case;
use meniscus_output::RunFolder;
use serde::Serialize;

use crate::batch::{self, Earlier, Job, Pages};
use crate::failure::Failure;
use crate::interrupt;
use crate::progress::duration;
use crate::terminal::{Voice, answer, complain};
use calibrations::Calibrations;
use model::{MODELS, Model};
use score::{Run, Score};
use suite::Effort;
use trial::Trial;

/// What to appraise.
#[derive(Args, Clone, Debug)]
pub struct What {
    /// Only these models, such as continuum,akinci.
    #[arg(long, value_delimiter = ',', value_parser = model::by_name)]
    models: Option<Vec<Model>>,
    /// Only these tests, such as laplace,swing.
    #[arg(long, value_delimiter = ',')]
    tests: Option<Vec<String>>,
    /// Only this dimension.
    #[arg(long, value_parser = clap::value_parser!(u8).range(2..=3))]
    dimension: Option<u8>,
    /// Coarser resolutions and fewer starts.
    #[arg(long)]
    quick: bool,
    /// Print JSON instead of the page.
    #[arg(long)]
    json: bool,
}

/// What `--json` prints.
#[derive(Serialize)]
struct Answer<'a> {
    scores: &'a [Score],
    costs: &'a [cost::Cost],
}

/// Runs the suite.
///
/// A run that fails costs its own numbers only.
pub fn appraise(
    what: &What,
    out: Option<&Path>,
    earlier: Earlier,
    voice: Voice,
) -> Result<ExitCode, Failure> {
    let begin = Instant::now();
    let root = out.map_or_else(|| PathBuf::from("out/appraise"), Path::to_path_buf);
    let effort = if what.quick {
        Effort::Quick
    } else {
        Effort::Full
    };
    let models = what.models.clone().unwrap_or_else(|| MODELS.to_vec());
    let mut trials: Vec<_> = (models
        .iter()
        .flat_map(|&model| suite::trials(model, effort)))
    .collect();
    if let Some(tests) = &what.tests {
        refuse_unknown(tests, trials.iter().map(|trial| trial.test))?;
        trials.retain(|trial| tests.iter().any(|test| *test == trial.test));
    }
    let dimensions = match what.dimension {
        Some(dimension) => vec![usize::from(dimension)],
        None => vec![2, 3],
    };
    trials.retain(|trial| dimensions.contains(&trial.dimension));
    refuse_nothing(&trials, effort)?;
    let runs = root.join("runs");
    let mut calibrations = Calibrations::new(root.join("calibration.toml"), voice);
    let mut jobs = Vec::new();
    let mut claimed: BTreeMap<String, Result<Case, String>> = BTreeMap::new();
    for trial in &trials {
        let claim = match calibrations.case(trial) {
            Ok(case) => {
                jobs.push(Job::claim(&trial.name(), case.clone(), &runs, earlier)?);
                Ok(case)
            }
            Err(refused) => Err(refused.message().to_owned()),
        };
        claimed.insert(trial.name(), claim);
    }
    // Standard output of --json belongs to the JSON.
    let count = jobs.len();
    let done = std::sync::atomic::AtomicUsize::new(0);
    let tell = |line: &str| {
        let so_far = 1 + done.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
        if !voice.quiet {
            complain(&format!("{so_far} of {count}: {line}"));
        }
    };
    let outcomes = batch::run_all(jobs, Pages::Left, &tell);
    if interrupt::asked() {
        return Ok(ExitCode::from(interrupt::EXIT_CODE));
    }
    let mut scores = Vec::new();
    for trial in &trials {
        let name = trial.name();
        let run = match (claimed.get(&name), outcomes.get(&name)) {
            (Some(Ok(case)), Some(Ok(done))) => Ok((case, done)),
            (Some(Err(reason)), _) | (_, Some(Err(reason))) => Err(reason.as_str()),
            _ => Err("not run"),
        };
        let run = match run {
            Ok((case, done)) => Ok(Run {
                case,
                done,
                folder: RunFolder::open(&runs.join(&name))?,
            }),
            Err(reason) => Err(reason),
        };
        scores.extend(score::scores(trial, run.as_ref().map_err(|reason| *reason)));
    }
    let mut costs = Vec::new();
    for &model in &models {
        for &dimension in &dimensions {
            if interrupt::asked() {
                return Ok(ExitCode::from(interrupt::EXIT_CODE));
            }
            match cost::cost(model, dimension) {
                Ok(cost) => costs.push(cost),
                Err(failure) => complain(&format!(
                    "no cost of {} in {dimension}D: {}",
                    model.name,
                    failure.message()
                )),
            }
        }
    }
    let figures = plots::draw(&root, &scores)?;
    let page = page::Page {
        command: &command(what),
        scores: &scores,
        costs: &costs,
        figures: &figures,
    }
    .markdown();
    let file = root.join("appraisal.md");
    meniscus_output::replace_file(&file, |out| std::io::Write::write_all(out, page.as_bytes()))?;
    if what.json {
        let all = Answer {
            scores: &scores,
            costs: &costs,
        };
        answer(&serde_json::to_string_pretty(&all).map_err(|e| Failure::new(e.to_string()))?)?;
    } else {
        answer(&page)?;
    }
    if !voice.quiet {
        complain(&format!(
            "{count} runs in {}; the page is {}",
            duration(begin.elapsed().as_secs_f64()),
            file.display()
        ));
    }
    Ok(ExitCode::SUCCESS)
}

/// The command line that asked for this.
fn command(what: &What) -> String {
    let mut command = "meniscus appraise".to_owned();
    if let Some(models) = &what.models {
        let names: Vec<&str> = models.iter().map(|model| model.name).collect();
        command += &format!(" --models {}", names.join(","));
    }
    if let Some(tests) = &what.tests {
        command += &format!(" --tests '{}'", tests.join(","));
    }
    if let Some(dimension) = what.dimension {
        command += &format!(" --dimension {dimension}");
    }
    if what.quick {
        command += " --quick";
    }
    command
}

fn refuse_nothing(trials: &[Trial], effort: Effort) -> Result<(), Failure> {
    let words = match (trials.is_empty(), effort) {
        (false, _) => return Ok(()),
        (true, Effort::Quick) => {
            "the quick suite has no such run; without --quick there may be one"
        }
        (true, Effort::Full) => "the suite has no such run",
    };
    Err(Failure::new(words.to_owned()))
}

fn refuse_unknown(
    asked: &[String],
    known: impl Iterator<Item = &'static str>,
) -> Result<(), Failure> {
    let known: BTreeSet<&str> = known.collect();
    match asked.iter().find(|test| !known.contains(test.as_str())) {
        Some(unknown) => Err(Failure::new(format!(
            "there is no test \"{unknown}\"; there are {}",
            Vec::from_iter(known).join(", ")
        ))),
        None => Ok(()),
    }
}
