//! `meniscus reproduce`: the cases of a paper, and its numbers beside ours.
//!
//! The paper's folder holds `reproduction.toml`: what to print, from which
//! case, and what the paper and theory say.

use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

use serde::Deserialize;

use crate::batch::{self, Earlier, Job, Pages};
use crate::calibrate;
use crate::convergence::Convergence;
use crate::failure::{Failure, NOT_REPRODUCED};
use crate::progress::duration;
use crate::regression::Regression;
use crate::side_by_side::{Panel, SideBySide};
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
    /// The last frames of several cases side by side.
    #[serde(default)]
    picture: Vec<SideBySide>,
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

/// Runs all cases of `paper`, several at a time.
///
/// A case that fails costs its own numbers only.
pub fn reproduce(
    paper: &Path,
    json: bool,
    out: Option<&Path>,
    earlier: Earlier,
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
    // Standard output of --json belongs to the JSON.
    let tell = |line: &str| match json {
        true if voice.quiet => {}
        true => complain(line),
        false => voice.say(line),
    };
    let jobs = claim(&plan, paper, &root, earlier, &tell)?;
    let panels: Vec<Panel> = jobs.iter().map(Panel::of).collect();
    let outcomes = batch::run_all(jobs, Pages::Written, &tell);
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
            let outcome = outcomes.get(case)?.as_ref().ok()?;
            Some(
                outcome
                    .findings
                    .iter()
                    .find(|found| found.id == id)?
                    .computed,
            )
        };
        match group.judge(&values, finding) {
            Ok((number, value)) => rows.push(Row::judge(&number, value.map(|y| (y, None)))),
            Err(problem) => problems.push(problem),
        }
    }
    for picture in &plan.picture {
        match picture.draw(&panels, &root) {
            Ok(path) => tell(&format!("picture: {}", path.display())),
            Err(failure) => problems.push(failure.message().to_owned()),
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

/// All cases, each with its folder: nothing runs before every case is read and every folder is
/// free. What may not be as meant in a case stands in its report; a paper means it so.
fn claim(
    plan: &Reproduction,
    paper: &Path,
    root: &Path,
    earlier: Earlier,
    tell: &dyn Fn(&str),
) -> Result<Vec<Job>, Failure> {
    let mut jobs: Vec<Job> = Vec::new();
    for number in &plan.number {
        if jobs.iter().all(|job| job.name != number.case) {
            let case = calibrate::ready(&paper.join(&number.case), tell)?;
            jobs.push(Job::claim(&number.case, case, root, earlier)?);
        }
    }
    Ok(jobs)
}

/// The number that a case found for a line of the table, and its uncertainty.
fn value_of(
    number: &Number,
    outcome: Option<&batch::Outcome>,
) -> Result<(f64, Option<f64>), String> {
    let findings = match outcome {
        Some(Ok(outcome)) => &outcome.findings,
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
