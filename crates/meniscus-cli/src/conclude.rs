//! The end of a run: its report and figures, and its results on the terminal.

use std::path::Path;
use std::process::ExitCode;

use meniscus_case::Case;
use meniscus_output::{RunFolder, Series};
use meniscus_report::number::{with_uncertainty, with_unit};

use crate::failure::Failure;
use crate::findings::{self, Finding, Findings};
use crate::page;
use crate::record::{RunRecord, Status};
use crate::runner::case_of;
use crate::table::{signed, table};
use crate::terminal::Voice;

/// `meniscus report`: the report of a folder, anew.
pub fn rewrite(root: &Path, voice: Voice) -> Result<ExitCode, Failure> {
    let folder = RunFolder::open(root)?;
    let case = case_of(&folder)?;
    let mut record = RunRecord::read(&folder)?;
    let measured = write_report(&case, &folder, &mut record)?;
    show(&folder, &record, &measured, voice);
    Ok(ExitCode::SUCCESS)
}

/// Measures a run from its files, and writes what was found into its record.
pub fn measure(
    case: &Case,
    folder: &RunFolder,
    record: &mut RunRecord,
) -> Result<(Findings, Series), Failure> {
    let series = Series::read(&folder.series_file())?;
    // A run that was killed came further than its record tells.
    let last = series.column("time").and_then(<[f64]>::last);
    if let (Some(&time), Status::Running) = (last, record.status) {
        record.time = record.time.max(time);
    }
    let measured = findings::measure(case, &series);
    record.findings = measured.numbers.clone();
    folder.write_run(record)?;
    Ok((measured, series))
}

/// Measures a run from its files, and writes its report and figures.
pub fn write_report(
    case: &Case,
    folder: &RunFolder,
    record: &mut RunRecord,
) -> Result<Findings, Failure> {
    let (measured, series) = measure(case, folder, record)?;
    let report = page::build(case, folder, record, &series, &measured)?;
    let broken = |error| Failure::new(format!("cannot draw a figure: {error}"));
    for figure in report.figures() {
        let (svg, png) = (figure.svg().map_err(broken)?, figure.png().map_err(broken)?);
        folder.write_figure(&format!("{}.svg", figure.name()), svg.as_bytes())?;
        folder.write_figure(&format!("{}.png", figure.name()), &png)?;
    }
    for movie in report.movies() {
        let png = movie.png().map_err(broken)?;
        folder.write_figure(&format!("{}.png", movie.name()), &png)?;
    }
    folder.write_report(&report.html().map_err(broken)?)?;
    Ok(measured)
}

/// Where the report stands.
pub fn file_of(folder: &RunFolder) -> String {
    folder.root().join("report.html").display().to_string()
}

/// Prints the results of a run.
pub fn show(folder: &RunFolder, record: &RunRecord, measured: &Findings, voice: Voice) {
    voice.say(&record.speed());
    voice.say(&format!("\n{}", results(&measured.numbers)));
    for complaint in &measured.complaints {
        voice.say(&format!("note: {complaint}"));
    }
    voice.say(&format!("\nreport: {}", file_of(folder)));
    voice.say(&format!(
        "frames: {} (open in ParaView)",
        folder.frames_folder().join("frames.pvd").display()
    ));
}

fn results(numbers: &[Finding]) -> String {
    let row = |finding: &Finding| {
        let (source, value) = match &finding.reference {
            Some((source, value)) => (source.clone(), Some(*value)),
            None => (String::new(), None),
        };
        let shown = |value| with_unit(value, &finding.unit, 4);
        let difference = value
            .filter(|value| *value != 0.0)
            .map(|value| format!("{} %", signed(100.0 * (finding.computed / value - 1.0), 1)));
        vec![
            finding.quantity.clone(),
            match finding.uncertainty {
                Some(half) => with_uncertainty(finding.computed, half, &finding.unit),
                None => shown(finding.computed),
            },
            value.map_or_else(String::new, shown),
            difference.unwrap_or_default(),
            source,
        ]
    };
    let rows: Vec<Vec<String>> = numbers.iter().map(row).collect();
    table(
        &["result", "computed", "to compare", "difference", "from"],
        &rows,
    )
}
