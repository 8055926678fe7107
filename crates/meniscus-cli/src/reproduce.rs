//! `meniscus reproduce`: the cases of a paper, and its numbers beside ours.
//!
//! The paper's folder holds `reproduction.toml`: what to print, from which
//! case, and what the paper and theory say.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::ExitCode;

use meniscus_case::Case;
use meniscus_output::RunFolder;
use meniscus_report::number::significant;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::failure::Failure;
use crate::findings::Finding;
use crate::progress::{Voice, duration};
use crate::{runner, table};

/// `reproduction.toml`
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Reproduction {
    title: String,
    /// What the table shows beyond the single numbers.
    #[serde(default)]
    remarks: Vec<String>,
    number: Vec<Number>,
}

/// One number of the paper.
#[derive(Clone, Deserialize)]
#[serde(deny_unknown_fields)]
struct Number {
    id: String,
    /// What it is, for the table.
    about: String,
    /// Case file beside `reproduction.toml`.
    case: String,
    /// Which finding of that case.
    finding: String,
    /// Whether the finding is divided by what it is compared with.
    #[serde(default)]
    ratio: bool,
    /// The paper's value, if it prints one.
    published: Option<f64>,
    /// The exact value, if theory gives one.
    theory: Option<f64>,
    /// How far from the published value still counts as the same; without a
    /// published value, from theory's.
    tolerance: f64,
}

/// One line of the answer.
#[derive(Serialize)]
struct Row {
    id: String,
    about: String,
    published: Option<f64>,
    theory: Option<f64>,
    computed: f64,
    uncertainty: Option<f64>,
    tolerance: f64,
    verdict: &'static str,
}

/// Runs all cases of `paper`, several at a time, one thread each.
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
    let begin = std::time::Instant::now();
    let findings = run_cases(&plan, paper, &root, force, json, voice)?;
    let rows: Vec<Row> = plan
        .number
        .iter()
        .map(|number| judge(number, &findings))
        .collect::<Result<_, _>>()?;
    if json {
        let text = serde_json::to_string_pretty(&rows).map_err(|e| Failure::new(e.to_string()))?;
        println!("{text}");
    } else {
        println!("\n{}", plan.title);
        print(&rows);
        for remark in &plan.remarks {
            println!("\n{remark}");
        }
        println!(
            "\nall cases in {}; their reports are in {}",
            duration(begin.elapsed().as_secs_f64()),
            root.display()
        );
    }
    let all = rows.iter().all(|row| row.verdict == "reproduced");
    Ok(if all {
        ExitCode::SUCCESS
    } else {
        ExitCode::from(2)
    })
}

fn run_cases(
    plan: &Reproduction,
    paper: &Path,
    root: &Path,
    force: bool,
    json: bool,
    voice: Voice,
) -> Result<BTreeMap<String, Vec<Finding>>, Failure> {
    let mut cases = BTreeMap::new();
    for number in &plan.number {
        if !cases.contains_key(&number.case) {
            let case = Case::from_file(&paper.join(&number.case))?;
            let cost = case.particle_count() as f64 * case.end_time;
            cases.insert(number.case.clone(), (case, cost));
        }
    }
    let mut cases: Vec<(String, (Case, f64))> = cases.into_iter().collect();
    // The longest first, so that none is left over alone at the end.
    cases.sort_by(|a, b| b.1.1.total_cmp(&a.1.1));
    // All folders are claimed before the first run begins.
    let mut jobs = Vec::new();
    for (name, (case, _)) in cases {
        let folder = RunFolder::create(&root.join(&case.name), case.to_toml(), force)?;
        jobs.push((name, case, folder));
    }
    let silent = Voice {
        quiet: true,
        verbose: false,
    };
    jobs.into_par_iter()
        .with_max_len(1)
        .map(|(name, case, folder)| {
            let alone = rayon::ThreadPoolBuilder::new()
                .num_threads(1)
                .build()
                .map_err(|error| Failure::new(format!("cannot start a thread: {error}")))?;
            let record = alone.install(|| runner::start(&case, &folder, silent))?;
            if !json {
                voice.say(&format!("{}: {}", case.name, runner::speed_line(&record)));
            }
            if record.status != "complete" {
                return Err(Failure::new(format!("{} was interrupted", case.name)));
            }
            Ok((name, record.findings))
        })
        .collect()
}

fn judge(number: &Number, findings: &BTreeMap<String, Vec<Finding>>) -> Result<Row, Failure> {
    let finding = findings
        .get(&number.case)
        .and_then(|all| all.iter().find(|finding| finding.id == number.finding))
        .ok_or_else(|| {
            let known: Vec<&str> = findings
                .get(&number.case)
                .into_iter()
                .flatten()
                .map(|f| f.id.as_str())
                .collect();
            Failure::new(format!(
                "{}: {} measured no \"{}\"; it measured {}",
                number.id,
                number.case,
                number.finding,
                known.join(", ")
            ))
        })?;
    let divisor = match (&finding.reference, number.ratio) {
        (Some((_, value)), true) => *value,
        _ => 1.0,
    };
    let computed = finding.computed / divisor;
    let verdict = match number.published.or(number.theory) {
        Some(value) if (computed - value).abs() <= number.tolerance => "reproduced",
        Some(_) => "differs",
        None => "shown",
    };
    Ok(Row {
        id: number.id.clone(),
        about: number.about.clone(),
        published: number.published,
        theory: number.theory,
        computed,
        uncertainty: finding.uncertainty.map(|half| half / divisor),
        tolerance: number.tolerance,
        verdict,
    })
}

fn print(rows: &[Row]) {
    let shown = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), |v| significant(v, 4));
    let signed = |value: f64| format!("{value:+.3}");
    let cells: Vec<Vec<String>> = rows
        .iter()
        .map(|row| {
            vec![
                row.about.clone(),
                shown(row.published),
                shown(row.theory),
                format!("{:.4}", row.computed),
                row.uncertainty
                    .map_or_else(String::new, |half| format!("{half:.4}")),
                row.published
                    .map_or_else(String::new, |v| signed(row.computed - v)),
                row.theory
                    .map_or_else(String::new, |v| signed(row.computed - v)),
                significant(row.tolerance, 2),
                row.verdict.to_owned(),
            ]
        })
        .collect();
    table::print(
        &[
            "number",
            "published",
            "theory",
            "computed",
            "+-",
            "to published",
            "to theory",
            "tolerance",
            "verdict",
        ],
        &cells,
    );
}
