//! `meniscus reproduce`: the cases of a paper, and its numbers beside ours.
//!
//! The paper's folder holds `reproduction.toml`: what to print, from which
//! case, and what the paper and theory say.

use std::collections::{BTreeMap, VecDeque};
use std::path::Path;
use std::process::ExitCode;
use std::sync::{Mutex, PoisonError};
use std::time::Instant;

use meniscus_case::Case;
use meniscus_output::RunFolder;
use serde::Deserialize;

use crate::conclude::write_report;
use crate::convergence::Convergence;
use crate::failure::{Failure, NOT_REPRODUCED};
use crate::findings::Finding;
use crate::progress::duration;
use crate::record::Status;
use crate::regression::Regression;
use crate::terminal::{Voice, answer, complain};
use crate::verdict::{Row, Verdict, rows_as_table};
use crate::{interrupt, runner};

/// `reproduction.toml`
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Reproduction {
    title: String,
    /// What the table shows beyond the single numbers.
    #[serde(default)]
    remarks: Vec<String>,
    number: Vec<Number>,
    /// How the deviation from theory falls with resolution.
    #[serde(default)]
    convergence: Vec<Convergence>,
    /// Lines through numbers of drops of several sizes.
    #[serde(default)]
    regression: Vec<Regression>,
}

/// One number of the paper.
#[derive(Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Number {
    /// A name that does not change, for programs.
    pub id: String,
    /// What it is, for the table.
    pub about: String,
    /// Case file beside `reproduction.toml`.
    pub case: String,
    /// Which finding of that case.
    pub finding: String,
    /// Whether the finding is divided by what it is compared with.
    #[serde(default)]
    pub ratio: bool,
    /// Size of the unit of the table in SI, such as 1e-6; one for SI itself.
    pub unit: Option<f64>,
    /// The paper's value, if it prints one.
    pub published: Option<f64>,
    /// The exact value, if theory gives one.
    pub theory: Option<f64>,
    /// How far from the published value still counts as the same; without a
    /// published value, from theory's.
    pub tolerance: f64,
    /// Why it is known to differ, where it does: no failure then.
    pub differs: Option<String>,
}

impl Number {
    /// One that follows from those of several cases.
    pub fn derived(id: &str, about: &str, tolerance: f64) -> Self {
        Self {
            id: id.to_owned(),
            about: about.to_owned(),
            case: String::new(),
            finding: String::new(),
            ratio: false,
            unit: None,
            published: None,
            theory: None,
            tolerance,
            differs: None,
        }
    }
}

/// What a case gave, or why it gave nothing.
type Outcome = Result<Vec<Finding>, String>;

/// Runs all cases of `paper`, several at a time.
///
/// A case that fails costs its own numbers only.
pub fn reproduce(
    paper: &Path,
    json: bool,
    out: Option<&Path>,
    force: bool,
    voice: Voice,
) -> Result<ExitCode, Failure> {
    let file = paper.join("reproduction.toml");
    let text = std::fs::read_to_string(&file)
        .map_err(|error| Failure::new(format!("cannot read {}: {error}", file.display())))?;
    let plan: Reproduction = toml::from_str(&text)
        .map_err(|error| Failure::new(format!("{}: {error}", file.display())))?;
    let name = runner::name_of(paper);
    let root = out.map_or_else(
        || Path::new("out").join("reproduce").join(name),
        Path::to_path_buf,
    );
    let begin = Instant::now();
    let jobs = claim(&plan, paper, &root, force)?;
    // Standard output of --json belongs to the JSON.
    let tell = |line: &str| match json {
        true if voice.quiet => {}
        true => complain(line),
        false => voice.say(line),
    };
    let outcomes = run_all(jobs, &tell);
    let (mut rows, mut problems) = (Vec::new(), Vec::new());
    let mut values = Vec::new();
    for number in &plan.number {
        let found = value_of(number, outcomes.get(&number.case));
        problems.extend(found.as_ref().err().cloned());
        values.push((number, found.as_ref().ok().map(|(value, _)| *value)));
        rows.push(Row::judge(number, found.ok()));
    }
    for group in &plan.convergence {
        match group.judge(&values) {
            Ok((number, order)) => rows.push(Row::judge(&number, order.map(|p| (p, None)))),
            Err(problem) => problems.push(problem),
        }
    }
    for group in &plan.regression {
        let finding = |case: &str, id: &str| {
            let findings = outcomes.get(case)?.as_ref().ok()?;
            Some(findings.iter().find(|found| found.id == id)?.computed)
        };
        match group.judge(&values, finding) {
            Ok((number, value)) => rows.push(Row::judge(&number, value.map(|y| (y, None)))),
            Err(problem) => problems.push(problem),
        }
    }
    if json {
        answer(&serde_json::to_string_pretty(&rows).map_err(|e| Failure::new(e.to_string()))?)?;
    } else {
        let known = rows.iter().filter_map(Row::known_difference);
        let remarks: String = (plan.remarks.iter().cloned().chain(known))
            .map(|r| format!("\n\n{r}"))
            .collect();
        let table = rows_as_table(&rows);
        answer(&format!("\n{}\n\n{table}{remarks}\n", plan.title))?;
        voice.say(&format!(
            "all cases in {}; their reports are in {}",
            duration(begin.elapsed().as_secs_f64()),
            root.display()
        ));
    }
    for problem in &problems {
        complain(&format!("error: {problem}"));
    }
    let failed = [Verdict::Differs, Verdict::NotComputed];
    Ok(if interrupt::asked() {
        ExitCode::from(interrupt::EXIT_CODE)
    } else if rows.iter().any(|row| failed.contains(&row.verdict)) {
        ExitCode::from(NOT_REPRODUCED)
    } else {
        ExitCode::SUCCESS
    })
}

/// A case to run, under its file's name, with its folder.
struct Job {
    name: String,
    case: Case,
    folder: RunFolder,
}

/// All cases, the costliest first, each with its folder: nothing runs before
/// every case is read and every folder is free. What may not be as meant in a
/// case stands in its report; a paper means it so.
fn claim(
    plan: &Reproduction,
    paper: &Path,
    root: &Path,
    force: bool,
) -> Result<VecDeque<Job>, Failure> {
    let mut cases: Vec<(&str, Case)> = Vec::new();
    for number in &plan.number {
        if cases.iter().all(|(name, _)| *name != number.case) {
            let case = Case::from_file(&paper.join(&number.case))?;
            cases.push((&number.case, case));
        }
    }
    // The longest first, so that none is left over alone at the end.
    let cost = |case: &Case| case.particle_count() as f64 * case.end_time;
    cases.sort_by(|a, b| cost(&b.1).total_cmp(&cost(&a.1)));
    cases
        .into_iter()
        .map(|(name, case)| {
            Ok(Job {
                folder: RunFolder::create(&root.join(&case.name), case.to_toml(), force)?,
                name: name.to_owned(),
                case,
            })
        })
        .collect()
}

/// Runs the jobs side by side, the threads of this pool shared out among them.
fn run_all(jobs: VecDeque<Job>, tell: &(dyn Fn(&str) + Sync)) -> BTreeMap<String, Outcome> {
    let threads = rayon::current_num_threads();
    let workers = threads.min(jobs.len()).max(1);
    let queue = Mutex::new(jobs);
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
                    let outcome = run_one(&job, share, tell);
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

fn run_one(job: &Job, threads: usize, tell: &(dyn Fn(&str) + Sync)) -> Outcome {
    if interrupt::asked() {
        return Err(format!("{}: not run", job.case.name));
    }
    let silent = Voice {
        quiet: true,
        verbose: false,
    };
    let run = || -> Result<Vec<Finding>, Failure> {
        let mut record = runner::start(&job.case, &job.folder, silent)?;
        let measured = write_report(&job.case, &job.folder, &mut record)?;
        if record.status != Status::Complete {
            return Err(Failure::new("interrupted".into()));
        }
        tell(&format!("{}: {}", job.case.name, record.speed()));
        Ok(measured.numbers)
    };
    rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .map_err(|error| Failure::new(format!("cannot start threads: {error}")))
        .and_then(|pool| pool.install(run))
        .map_err(|failure| format!("{}: {}", job.case.name, failure.message()))
}

/// The number that a case found for a line of the table, and its uncertainty.
fn value_of(number: &Number, outcome: Option<&Outcome>) -> Result<(f64, Option<f64>), String> {
    let findings = match outcome {
        Some(Ok(findings)) => findings,
        Some(Err(reason)) => return Err(format!("{}: no value: {reason}", number.id)),
        None => return Err(format!("{}: {} was not run", number.id, number.case)),
    };
    let Some(finding) = findings.iter().find(|found| found.id == number.finding) else {
        let known: Vec<&str> = findings.iter().map(|found| found.id.as_str()).collect();
        return Err(format!(
            "{}: {} found no \"{}\"; it found {}",
            number.id,
            number.case,
            number.finding,
            known.join(", ")
        ));
    };
    let divisor = match (&finding.reference, number.ratio) {
        (_, false) => 1.0,
        (Some((_, value)), true) if *value != 0.0 => *value,
        (_, true) => {
            return Err(format!(
                "{}: ratio = true, but \"{}\" of {} has nothing to be divided by",
                number.id, number.finding, number.case
            ));
        }
    };
    let divisor = divisor * number.unit.unwrap_or(1.0);
    let uncertainty = finding.uncertainty.map(|half| half / divisor.abs());
    Ok((finding.computed / divisor, uncertainty))
}
