//! `meniscus calibrate`: how strong pairwise forces, or the cohesion of a van der Waals fluid, must be for the surface
//! tension and the contact angles of a case.
//!
//! - `film`: a flat film of the liquid, free or on a wall, and what it pulls with; `liquid`: what holds it together;
//!   `inputs`: what that depends on
//! - `search`: the strength at which that is right
//! - `store`: what was found, on disk, and for which inputs
//! - `open`: what a case leaves to be measured
//! - here: the command, and cases made ready to run

mod film;
mod inputs;
mod liquid;
mod open;
mod search;
mod store;

use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

use meniscus_case::{Case, Coefficients};
use meniscus_report::number::{significant, with_unit};
use serde::Serialize;

use crate::failure::Failure;
use crate::progress::duration;
use crate::table::table;
use crate::terminal::{Voice, answer};
use open::{Open, Whose};
use store::{Entry, Store};

/// What `--json` prints of a coefficient.
#[derive(Serialize)]
struct Row<'a> {
    name: &'a str,
    /// "N/m" or "deg"
    unit: &'static str,
    asked: f64,
    by_estimate: f64,
    factor: f64,
    factor_half_width: f64,
    half_width: f64,
}

/// Measures the coefficients of a case anew, and stores them beside it.
pub fn calibrate(path: &Path, json: bool, voice: Voice) -> Result<ExitCode, Failure> {
    let case = Case::from_file(path)?;
    if !leaves_any(&case) {
        return Err(Failure::new(format!(
            "{} leaves nothing to be measured: only pairwise forces, such as \"akinci\", and a van der Waals fluid of substance = {{ liquid = ... }} have a strength that follows from `surface_tension`, unless the file gives `cohesion_factor` (and walls `adhesion_factor`)",
            path.display()
        )));
    }
    let file = store::beside(path);
    let mut store = Store::default();
    let silent = |_: &str| {};
    open::complete(&case, &mut store, Some(&silent))?;
    store.write(&file)?;
    let rows: Vec<Row<'_>> = (store.fluid.iter().map(|entry| row(entry, "N/m")))
        .chain(store.wall.iter().map(|entry| row(entry, "deg")))
        .collect();
    if json {
        answer(&serde_json::to_string_pretty(&rows).map_err(|e| Failure::new(e.to_string()))?)?;
        return Ok(ExitCode::SUCCESS);
    }
    let cells = |row: &Row<'_>| {
        let shown = |value: f64, figures| match row.unit {
            "deg" => format!("{} deg", significant(value, figures)),
            unit => with_unit(value, unit, figures),
        };
        vec![
            row.name.to_owned(),
            shown(row.asked, 4),
            shown(row.by_estimate, 3),
            format!("{:.3}", row.factor),
            format!("{:.3}", row.factor_half_width),
            shown(row.half_width, 2),
        ]
    };
    let header = [
        "of",
        "asked for",
        "films of the estimate",
        "factor",
        "±",
        "± of what is asked for",
    ];
    answer(&table(&header, &rows.iter().map(cells).collect::<Vec<_>>()))?;
    voice.say(&format!("stored in {}", file.display()));
    Ok(ExitCode::SUCCESS)
}

fn row<'a>(entry: &'a Entry, unit: &'static str) -> Row<'a> {
    Row {
        name: &entry.name,
        unit,
        asked: entry.asked,
        by_estimate: entry.by_estimate,
        factor: entry.factor,
        factor_half_width: entry.factor_half_width,
        half_width: entry.half_width,
    }
}

/// Whether there is anything that only films can tell.
fn leaves_any(case: &Case) -> bool {
    !case.given.is_complete()
}

/// Reads a case file to run it: with what stands beside it, and what is missing measured and put there.
pub fn ready(path: &Path, tell: &dyn Fn(&str)) -> Result<Case, Failure> {
    let case = Case::from_file(path)?;
    if !leaves_any(&case) {
        return Ok(case);
    }
    let measured = coefficients(&case, &store::beside(path), tell)?;
    Ok(Case::from_file_with(path, &measured)?)
}

/// The coefficients of a case, from a file, and from films where it holds none for them.
pub fn coefficients(
    case: &Case,
    file: &Path,
    tell: &dyn Fn(&str),
) -> Result<Coefficients, Failure> {
    let mut store = Store::read(file)?;
    let begin = Instant::now();
    let open = open::complete(case, &mut store, Some(tell))?;
    if open.measured > 0 {
        let took = duration(begin.elapsed().as_secs_f64());
        tell(&match store.write(file) {
            Ok(()) => format!("took {took}, stored in {}", file.display()),
            Err(failure) => format!("took {took}, not stored: {}", failure.message()),
        });
    }
    Ok(open.coefficients)
}

/// What is known of a case without measuring: its coefficients, and lines that tell of them.
pub fn known(path: &Path, case: &Case) -> Result<(Coefficients, Vec<String>), Failure> {
    let file = store::beside(path);
    if !leaves_any(case) {
        return Ok((Coefficients::default(), Vec::new()));
    }
    let Open {
        coefficients,
        found,
        missing,
        ..
    } = open::complete(case, &mut Store::read(&file)?, None)?;
    let mut lines: Vec<String> = (found.iter())
        .map(|(whose, entry)| format!("{}, from {}", sentence(*whose, entry), file.display()))
        .collect();
    lines.extend((missing.iter()).map(|what| {
        format!("{what} is not measured yet: `meniscus run` does so first: some seconds in the plane, minutes in space")
    }));
    Ok((coefficients, lines))
}

/// What was found, for people.
fn sentence(whose: Whose, entry: &Entry) -> String {
    if entry.factor_half_width.is_infinite() {
        return format!(
            "{} {} stays that of a sharp surface: films do not come near {} degrees at any strength",
            whose.what(),
            entry.name,
            significant(entry.asked, 3)
        );
    }
    format!(
        "{} {} is {:.3} ± {:.3} times that of a sharp surface",
        whose.what(),
        entry.name,
        entry.factor,
        entry.factor_half_width
    )
}
