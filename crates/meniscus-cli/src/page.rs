//! The report of a run, from its case, its series and its frames.

use meniscus::scheme::{SurfaceTension, TimeStep};
use meniscus_case::Case;
use meniscus_output::{RunFolder, Series};
use meniscus_report::number::{significant, with_uncertainty, with_unit};
use meniscus_report::{Report, ResultRow};

use crate::failure::Failure;
use crate::findings::{Finding, Findings};
use crate::record::RunRecord;
use crate::{figures, numbers};

/// The report; nothing is written.
pub fn build(
    case: &Case,
    folder: &RunFolder,
    record: &RunRecord,
    series: &Series,
    measured: &Findings,
) -> Result<Report, Failure> {
    let mut report = Report::new(case.title.as_deref().unwrap_or(&case.name));
    let main = measured.numbers.iter().find(|found| found.unit == "N/m");
    let summary: Vec<String> = main
        .map(headline)
        .into_iter()
        .chain(case.description.clone())
        .collect();
    report = report.summary(&summary.join(" "));
    let reservation = record.reservation(case, folder.root());
    let warnings = case.warnings.iter().map(|warning| &warning.message);
    for warning in reservation
        .iter()
        .chain(warnings)
        .chain(&measured.complaints)
    {
        report = report.warning(warning);
    }
    for finding in &measured.numbers {
        report = report.result(ResultRow {
            quantity: finding.quantity.clone(),
            unit: finding.unit.clone(),
            reference: finding.reference.clone(),
            computed: finding.computed,
            uncertainty: finding.uncertainty,
        });
    }
    for figure in figures::of(case, folder, series, measured)? {
        report = report.figure(figure);
    }
    if let Some(movie) = figures::movie(case, folder)? {
        report = report.movie(movie);
    }
    for (name, value) in parameters(case) {
        report = report.parameter(&name, &value);
    }
    for number in numbers::of(case) {
        report = report.dimensionless(number.name, number.value, number.meaning);
    }
    Ok(report
        .run_information("meniscus", &record.version)
        .run_information("machine", &record.machine)
        .run_information("cost", &record.speed())
        .reproduce(&format!(
            "meniscus run {} --out NEW-FOLDER",
            folder.case_file().display()
        )))
}

fn headline(finding: &Finding) -> String {
    let found = match finding.uncertainty {
        Some(half) => with_uncertainty(finding.computed, half, "N/m"),
        None => with_unit(finding.computed, "N/m", 4),
    };
    let given = finding
        .reference
        .as_ref()
        .filter(|(_, value)| *value > 0.0)
        .map_or_else(String::new, |(_, value)| {
            format!(
                "; {} was put in (ratio {:.3})",
                with_unit(*value, "N/m", 4),
                finding.computed / value
            )
        });
    format!("Measured {}: {found}{given}.", finding.quantity)
}

fn parameters(case: &Case) -> Vec<(String, String)> {
    let mut rows = Vec::new();
    let mut add = |name: &str, value: String| rows.push((name.to_owned(), value));
    let scheme = &case.scheme;
    add("particles", case.particle_count().to_string());
    add("dimensions", case.dimension.to_string());
    add("spacing", with_unit(case.spacing, "m", 4));
    add("kernel", scheme.kernel.name().to_owned());
    add(
        "smoothing length",
        format!(
            "{} ({} spacings)",
            with_unit(scheme.smoothing_length, "m", 4),
            significant(scheme.smoothing_length / case.spacing, 4)
        ),
    );
    add(
        "surface tension model",
        match &scheme.surface_tension {
            Some(SurfaceTension::Balanced(_)) => "in balance with the pressure gradient".into(),
            Some(SurfaceTension::JancikHyhlik(_)) => "Jancik and Hyhlik".into(),
            Some(SurfaceTension::Continuum(_)) => "continuum surface force".into(),
            Some(SurfaceTension::Pairwise(model)) => format!("pairwise forces ({})", model.name()),
            None if scheme.van_der_waals.is_some() => "cohesion of a van der Waals fluid".into(),
            Some(SurfaceTension::CapillaryPressure(_)) => "capillary pressure".into(),
            Some(SurfaceTension::TotalVariation(_)) => "total variation".into(),
            None => "none".into(),
        },
    );
    add(
        "artificial viscosity",
        scheme.artificial_viscosity.to_string(),
    );
    add(
        "time step",
        match scheme.time_step {
            TimeStep::Fixed(dt) => with_unit(dt, "s", 4),
            TimeStep::Adaptive { .. } => "adaptive".into(),
        },
    );
    add("end time", with_unit(case.end_time, "s", 4));
    for fluid in &case.fluids {
        let mut add = |what: &str, value: f64, unit: &str| {
            let name = format!("{what} of {}", fluid.name);
            rows.push((name, with_unit(value, unit, 4)));
        };
        add("density", fluid.density, "kg/m^3");
        add("surface tension", fluid.surface_tension, "N/m");
        add("viscosity", fluid.viscosity, "Pa s");
        add("speed of sound", fluid.sound_speed, "m/s");
    }
    for body in &case.bodies {
        rows.push((
            format!("particles of {}", body.name),
            body.particles.to_string(),
        ));
    }
    for wall in &case.walls {
        rows.push((
            format!("particles of {}", wall.name),
            wall.particles.to_string(),
        ));
    }
    rows
}
