//! The report of a run, from the files in its folder.

use std::path::Path;
use std::process::ExitCode;

use meniscus::measure::radial_profile;
use meniscus::{Vector, theory};
use meniscus_case::Case;
use meniscus_output::{Frame, FrameReader, RunFolder, Series};
use meniscus_report::number::{significant, with_uncertainty, with_unit};
use meniscus_report::{
    Axis, Curve, Figure, LinePlot, ParticlePictures, Report, ResultRow, Snapshot,
};

use crate::failure::Failure;
use crate::findings::{self, Finding, Findings};
use crate::numbers;
use crate::progress::Voice;
use crate::runner::{RunRecord, name_of, speed_line};
use crate::table;

/// Panels in a row of pictures.
const PANELS: usize = 6;

/// Reads `run.json`, if it is there and whole.
pub fn read_record(folder: &RunFolder) -> Option<RunRecord> {
    let text = std::fs::read_to_string(folder.root().join("run.json")).ok()?;
    serde_json::from_str(&text).ok()
}

/// `meniscus report`: the report of a folder, anew.
pub fn rewrite(root: &Path, voice: Voice) -> Result<ExitCode, Failure> {
    let folder = RunFolder::open(root)?;
    let mut case = Case::from_str(
        &folder.case_file().display().to_string(),
        &folder.read_case()?,
    )?;
    case.name = name_of(root);
    let mut record = read_record(&folder)
        .ok_or_else(|| Failure::new(format!("{} has no whole run.json", root.display())))?;
    conclude(&case, &folder, &mut record, voice)?;
    folder.write_run(&record)?;
    Ok(ExitCode::SUCCESS)
}

/// Measures a finished run, prints its results, writes its report and figures.
pub fn conclude(
    case: &Case,
    folder: &RunFolder,
    record: &mut RunRecord,
    voice: Voice,
) -> Result<(), Failure> {
    let series = Series::read(&folder.series_file())?;
    let measured = findings::measure(case, &series);
    record.findings = measured.numbers.clone();
    let report = build(case, folder, record, &series, &measured)?;
    let broken = |error| Failure::new(format!("cannot draw a figure: {error}"));
    for figure in report.figures() {
        let svg = figure.svg().map_err(broken)?;
        folder.write_figure(&format!("{}.svg", figure.name()), svg.as_bytes())?;
        folder.write_figure(
            &format!("{}.png", figure.name()),
            &figure.png().map_err(broken)?,
        )?;
    }
    let path = folder.write_report(&report.html().map_err(broken)?)?;
    if !voice.quiet {
        println!("{}\n", speed_line(record));
        print_findings(&measured.numbers);
        for complaint in &measured.complaints {
            println!("note: {complaint}");
        }
        println!("\nreport: {}", path.display());
        println!(
            "frames: {} (open in ParaView)",
            folder.frames_folder().join("frames.pvd").display()
        );
    }
    Ok(())
}

fn print_findings(numbers: &[Finding]) {
    let rows: Vec<Vec<String>> = numbers
        .iter()
        .map(|finding| {
            let reference = finding.reference.as_ref();
            let difference = reference
                .filter(|(_, value)| *value != 0.0)
                .map_or_else(String::new, |(_, value)| {
                    format!("{:+.1} %", 100.0 * (finding.computed / value - 1.0))
                });
            vec![
                finding.quantity.clone(),
                match finding.uncertainty {
                    Some(half) => with_uncertainty(finding.computed, half, &finding.unit),
                    None => with_unit(finding.computed, &finding.unit, 4),
                },
                reference.map_or_else(String::new, |(_, value)| {
                    with_unit(*value, &finding.unit, 4)
                }),
                difference,
                reference.map_or_else(String::new, |(source, _)| source.clone()),
            ]
        })
        .collect();
    table::print(
        &["result", "computed", "to compare", "difference", "from"],
        &rows,
    );
}

fn build(
    case: &Case,
    folder: &RunFolder,
    record: &RunRecord,
    series: &Series,
    measured: &Findings,
) -> Result<Report, Failure> {
    let mut report = Report::new(case.title.as_deref().unwrap_or(&case.name));
    if let Some(description) = &case.description {
        report = report.summary(description);
    }
    if let Some(main) = measured
        .numbers
        .iter()
        .find(|finding| finding.unit == "N/m")
    {
        report = report.summary(&headline(main));
    }
    for warning in case.warnings.iter() {
        report = report.warning(&warning.message);
    }
    for complaint in &measured.complaints {
        report = report.warning(complaint);
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
    for figure in figures(case, folder, series, measured)? {
        report = report.figure(figure);
    }
    for (name, value) in parameters(case) {
        report = report.parameter(&name, &value);
    }
    for number in numbers::of(case) {
        report = report.dimensionless(number.name, number.value, number.meaning);
    }
    let command = format!(
        "meniscus run {} --out NEW-FOLDER",
        folder.case_file().display()
    );
    Ok(report
        .run_information("meniscus", &record.version)
        .run_information("machine", &record.machine)
        .run_information("cost", &speed_line(record))
        .reproduce(&command))
}

fn headline(finding: &Finding) -> String {
    let found = match finding.uncertainty {
        Some(half) => with_uncertainty(finding.computed, half, "N/m"),
        None => with_unit(finding.computed, "N/m", 4),
    };
    let given = finding
        .reference
        .as_ref()
        .map_or_else(String::new, |(_, value)| {
            let ratio = significant(finding.computed / value, 4);
            format!(
                "; {} was put in (ratio {ratio})",
                with_unit(*value, "N/m", 4)
            )
        });
    format!("Measured {}: {found}{given}.", finding.quantity)
}

fn parameters(case: &Case) -> Vec<(String, String)> {
    let mut rows = vec![
        ("particles".to_owned(), case.particle_count().to_string()),
        ("dimensions".to_owned(), case.dimension.to_string()),
        ("spacing".to_owned(), with_unit(case.spacing, "m", 4)),
        ("kernel".to_owned(), case.scheme.kernel.name().to_owned()),
        (
            "smoothing length".to_owned(),
            format!(
                "{} ({} spacings)",
                with_unit(case.scheme.smoothing_length, "m", 4),
                significant(case.scheme.smoothing_length / case.spacing, 4)
            ),
        ),
        (
            "artificial viscosity".to_owned(),
            significant(case.scheme.artificial_viscosity, 4),
        ),
        ("end time".to_owned(), with_unit(case.end_time, "s", 4)),
    ];
    for fluid in &case.fluids {
        let mut add = |what: &str, value: f64, unit: &str| {
            rows.push((
                format!("{what} of {}", fluid.name),
                with_unit(value, unit, 4),
            ));
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
    rows
}

fn figures(
    case: &Case,
    folder: &RunFolder,
    series: &Series,
    measured: &Findings,
) -> Result<Vec<Figure>, Failure> {
    let reader = FrameReader::open(&folder.frames_folder())?;
    let chosen = chosen_frames(reader.times(), measured);
    let frames: Vec<Frame> = chosen
        .iter()
        .map(|&k| reader.read(k))
        .collect::<Result<_, _>>()?;
    let mut figures = Vec::new();
    for (field, unit, caption) in [
        ("pressure", "Pa", "Particles coloured by pressure."),
        ("speed", "m/s", "Particles coloured by speed."),
    ] {
        let label = format!("{}{}", field[..1].to_uppercase(), &field[1..]);
        let mut pictures = ParticlePictures::new(&label, unit);
        for frame in &frames {
            let values = frame.fields.iter().find(|f| f.name == field);
            pictures = pictures.with(Snapshot {
                time: frame.time,
                positions: frame.positions.clone(),
                diameter: case.spacing,
                values: values.map(|f| f.values.clone()).unwrap_or_default(),
            });
        }
        figures.push(pictures.figure(field, caption));
    }
    figures.extend(axes(case, series, measured));
    figures.extend(energies(case, series));
    if let Some(last) = reader.times().len().checked_sub(1) {
        figures.extend(profile(case, &reader.read(last)?));
    }
    Ok(figures)
}

/// Frames for the pictures: over the first period of an oscillation, else over the whole run.
fn chosen_frames(times: &[f64], measured: &Findings) -> Vec<usize> {
    let Some(&end) = times.last() else {
        return Vec::new();
    };
    let span = measured
        .fit
        .as_ref()
        .map_or(end, |fit| fit.period().value.min(end));
    let mut chosen: Vec<usize> = (0..PANELS)
        .map(|k| {
            let wanted = span * k as f64 / (PANELS - 1) as f64;
            (0..times.len())
                .min_by(|&a, &b| {
                    (times[a] - wanted)
                        .abs()
                        .total_cmp(&(times[b] - wanted).abs())
                })
                .unwrap_or(0)
        })
        .collect();
    chosen.dedup();
    chosen
}

fn axes(case: &Case, series: &Series, measured: &Findings) -> Option<Figure> {
    let time = series.column("time")?;
    let (x, y) = (series.column("semi-axis x")?, series.column("semi-axis y")?);
    let mut plot = LinePlot::new(Axis::new("Time", "s"), Axis::new("Semi-axis", "m"))
        .with(Curve::line("x", time, x))
        .with(Curve::line("y", time, y));
    let mut caption =
        "Semi-axes of the ellipse with the second moments of the particles.".to_owned();
    if let (Some(fit), Some(asked)) = (&measured.fit, &case.measure.oscillation) {
        let body = case.bodies.first()?;
        let fluid = &case.fluids[body.fluid];
        let radius = theory::equivalent_radius(body.volume, case.dimension);
        let viscosity = numbers::effective_viscosity(case, body.fluid);
        let (rho, sigma) = (fluid.density, fluid.surface_tension);
        if let Some(exact) =
            theory::viscous_oscillation(asked.mode, sigma, rho, viscosity, radius, case.dimension)
        {
            let curve: Vec<f64> = time
                .iter()
                .map(|t| {
                    let decay = (-exact.damping_rate * t).exp();
                    radius + (x[0] - radius) * decay * (exact.angular_frequency * t).cos()
                })
                .collect();
            plot = plot.with(Curve::dashed("x, linear viscous theory", time, &curve));
            caption.push_str(" Dashed: linear theory with the surface tension put in and the viscosity that the artificial viscosity stands for.");
        }
        let window: Vec<f64> = time
            .iter()
            .copied()
            .filter(|t| *t >= asked.from && *t <= asked.to)
            .collect();
        let thinned: Vec<f64> = window
            .iter()
            .copied()
            .step_by(1 + window.len() / 60)
            .collect();
        let fitted: Vec<f64> = thinned.iter().map(|&t| fit.at(t)).collect();
        plot = plot.with(Curve::points("x, damped cosine fitted", &thinned, &fitted));
    }
    Some(plot.figure("semi-axes", &caption))
}

fn energies(case: &Case, series: &Series) -> Option<Figure> {
    let time = series.column("time")?;
    let kinetic = series.column("kinetic energy")?;
    let compression = series.column("compression energy")?;
    let surface = series.column("surface energy")?;
    let unit = if case.dimension == 2 { "J/m" } else { "J" };
    let mut plot = LinePlot::new(Axis::new("Time", "s"), Axis::new("Energy", unit))
        .with(Curve::line("kinetic", time, kinetic))
        .with(Curve::line("compression", time, compression));
    if surface.iter().all(|e| e.is_finite()) {
        // Above that of the circle or sphere, which no shape can give back.
        let least: f64 = case
            .bodies
            .iter()
            .map(|body| {
                let radius = theory::equivalent_radius(body.volume, case.dimension);
                let sigma = case.fluids[body.fluid].surface_tension;
                meniscus::measure::surface_energy([radius; 2], sigma)
                    * if case.dimension == 2 {
                        1.0
                    } else {
                        2.0 * radius
                    }
            })
            .sum();
        let free: Vec<f64> = surface.iter().map(|e| e - least).collect();
        let total: Vec<f64> = (0..time.len())
            .map(|i| kinetic[i] + compression[i] + free[i])
            .collect();
        plot = plot
            .with(Curve::line("surface, above the round shape's", time, &free))
            .with(Curve::dashed("sum", time, &total));
    }
    Some(plot.figure(
        "energies",
        "Energies; that of the surface is of the ellipse or ellipsoid with the same second moments.",
    ))
}

/// Pressure against radius in the last frame, beside Young and Laplace.
fn profile(case: &Case, frame: &Frame) -> Option<Figure> {
    let [body] = &case.bodies[..] else {
        return None;
    };
    if case.periodic.iter().any(Option::is_some) {
        return None;
    }
    let pressure = &frame.fields.iter().find(|f| f.name == "pressure")?.values;
    let positions: Vec<Vector<f64, 3>> = frame.positions.iter().map(|p| Vector(*p)).collect();
    let mut centre = Vector::<f64, 3>::ZERO;
    for position in &positions {
        centre += *position * (1.0 / positions.len() as f64);
    }
    let radius = theory::equivalent_radius(body.volume, case.dimension);
    let sigma = case.fluids[body.fluid].surface_tension;
    let jump = theory::pressure_jump(sigma, radius, case.dimension);
    let bins = (radius / case.spacing).ceil() as usize;
    let means = radial_profile(&positions, pressure, centre, radius * 1.1, bins.max(4));
    let distances: Vec<f64> = positions.iter().map(|p| (*p - centre).norm()).collect();
    let bin_radius: Vec<f64> = means.iter().map(|bin| bin.radius).collect();
    let bin_mean: Vec<f64> = means.iter().map(|bin| bin.mean).collect();
    let step_radius = [0.0, radius, radius, 1.15 * radius];
    let step = [jump, jump, 0.0, 0.0];
    let plot = LinePlot::new(
        Axis::new("Distance from the centre", "m"),
        Axis::new("Pressure", "Pa"),
    )
    .with(Curve::points("particles", &distances, pressure))
    .with(Curve::line("mean over rings", &bin_radius, &bin_mean))
    .with(Curve::dashed("Young and Laplace", &step_radius, &step));
    Some(plot.figure(
        "pressure-profile",
        &format!("Pressure at t = {}.", crate::progress::seconds(frame.time)),
    ))
}
