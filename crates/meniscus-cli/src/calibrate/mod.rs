//! `meniscus calibrate`: how strong pairwise forces must be for the surface tension of a case.
//!
//! - `film`: a flat film of the liquid, and what it pulls with
//! - `search`: the strength at which that is right
//! - `store`: what was found, on disk, and for which inputs
//! - here: the command, and cases made ready to run

mod film;
mod search;
mod store;

use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

use meniscus_case::{Case, Coefficients};
use meniscus_report::number::with_unit;
use serde::Serialize;

use crate::failure::Failure;
use crate::progress::duration;
use crate::table::table;
use crate::terminal::{Voice, answer};
use film::Film;
use store::{Entry, Store};

/// What `--json` prints of a fluid.
#[derive(Serialize)]
struct Row<'a> {
    fluid: &'a str,
    /// N/m
    asked: f64,
    /// N/m
    shown_by_estimate: f64,
    cohesion_factor: f64,
    half_width: f64,
}

/// Measures the coefficients of a case anew, and stores them beside it.
pub fn calibrate(path: &Path, json: bool, voice: Voice) -> Result<ExitCode, Failure> {
    let case = Case::from_file(path)?;
    let films = films(&case);
    if films.is_empty() {
        return Err(Failure::new(format!(
            "{} leaves nothing to be measured: only pairwise forces, such as \"akinci\", have a strength that follows from `surface_tension`, unless the file gives `cohesion_factor`",
            path.display()
        )));
    }
    let file = store::beside(path);
    let mut store = Store::default();
    for film in &films {
        store.put(measure(film)?);
    }
    store.write(&file)?;
    let rows: Vec<Row<'_>> = (store.film.iter())
        .map(|entry| Row {
            fluid: &entry.fluid,
            asked: entry.asked,
            shown_by_estimate: entry.by_estimate * entry.asked,
            cohesion_factor: entry.cohesion_factor,
            half_width: entry.half_width,
        })
        .collect();
    if json {
        answer(&serde_json::to_string_pretty(&rows).map_err(|e| Failure::new(e.to_string()))?)?;
        return Ok(ExitCode::SUCCESS);
    }
    let cells = |row: &Row<'_>| {
        vec![
            row.fluid.to_owned(),
            with_unit(row.asked, "N/m", 4),
            with_unit(row.shown_by_estimate, "N/m", 3),
            format!("{:.3}", row.cohesion_factor),
            format!("{:.3}", row.half_width),
        ]
    };
    let header = [
        "fluid",
        "asked for",
        "a film of the estimate",
        "factor",
        "±",
    ];
    answer(&table(&header, &rows.iter().map(cells).collect::<Vec<_>>()))?;
    voice.say(&format!("stored in {}", file.display()));
    Ok(ExitCode::SUCCESS)
}

/// Reads a case file to run it: with what stands beside it, and what is missing measured and put there.
pub fn ready(path: &Path, tell: &dyn Fn(&str)) -> Result<Case, Failure> {
    let case = Case::from_file(path)?;
    if films(&case).is_empty() {
        return Ok(case);
    }
    let file = store::beside(path);
    let measured = coefficients(&case, &file, tell)?;
    Ok(Case::from_file_with(path, &measured)?)
}

/// The coefficients of a case, from a file, and from films where it holds none for them.
pub fn coefficients(
    case: &Case,
    file: &Path,
    tell: &dyn Fn(&str),
) -> Result<Coefficients, Failure> {
    let mut store = Store::read(file)?;
    let mut measured = Coefficients::default();
    for film in films(case) {
        let name = &film.fluid.name;
        let entry = match store.find(&film.inputs()) {
            Some(entry) => entry.clone(),
            None => {
                tell(&format!(
                    "measuring the cohesion of {name} on flat films ..."
                ));
                let begin = Instant::now();
                let entry = measure(&film)?;
                store.put(entry.clone());
                let stored = match store.write(file) {
                    Ok(()) => format!("stored in {}", file.display()),
                    Err(failure) => format!("not stored: {}", failure.message()),
                };
                tell(&format!(
                    "{}; took {}, {stored}",
                    sentence(&entry),
                    duration(begin.elapsed().as_secs_f64()),
                ));
                entry
            }
        };
        measured
            .cohesion
            .insert(name.clone(), entry.cohesion_factor);
    }
    Ok(measured)
}

/// What is known of a case without measuring: its coefficients, and lines that tell of them.
pub fn known(path: &Path, case: &Case) -> Result<(Coefficients, Vec<String>), Failure> {
    let file = store::beside(path);
    let (mut measured, mut lines) = (Coefficients::default(), Vec::new());
    let films = films(case);
    if films.is_empty() {
        return Ok((measured, lines));
    }
    let store = Store::read(&file)?;
    for film in films {
        let name = &film.fluid.name;
        match store.find(&film.inputs()) {
            Some(entry) => {
                lines.push(format!("{}, from {}", sentence(entry), file.display()));
                let factor = entry.cohesion_factor;
                measured.cohesion.insert(name.clone(), factor);
            }
            None => lines.push(format!(
                "not measured yet: `meniscus run` measures that of {name} first, which takes some seconds"
            )),
        }
    }
    Ok((measured, lines))
}

fn sentence(entry: &Entry) -> String {
    format!(
        "cohesion of {} is {:.3} ± {:.3} times that of a sharp surface",
        entry.fluid, entry.cohesion_factor, entry.half_width
    )
}

fn films(case: &Case) -> Vec<Film> {
    let left = (case.given.cohesion.iter().enumerate()).filter(|(_, given)| !**given);
    left.filter_map(|(index, _)| Film::new(case, index))
        .collect()
}

fn measure(film: &Film) -> Result<Entry, Failure> {
    let name = &film.fluid.name;
    let found = search::search(film).map_err(|failure| {
        Failure::new(format!(
            "{}\nto run with the strength of a sharp surface all the same: cohesion_factor = 1 in [fluid.{name}]",
            failure.message()
        ))
    })?;
    let asked = film.fluid.surface_tension;
    Ok(Entry {
        fluid: film.fluid.name.clone(),
        asked,
        by_estimate: found.by_estimate / asked,
        cohesion_factor: found.factor.value,
        half_width: found.factor.half_width,
        inputs: film.inputs(),
    })
}
