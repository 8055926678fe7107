//! `meniscus check`: what a case is and what it will cost, without running it.

use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

use meniscus::physics::surface_tension::pairwise::estimate::Resolution;
use meniscus::rates::{Dimension, Space};
use meniscus::scheme::{TimeStep, VanDerWaals};
use meniscus::time::step::StepLimits;
use meniscus::{Simulation, SurfaceTension, theory};
use meniscus_case::{BYTES_PER_PARTICLE, Case};
use meniscus_report::number::{significant, with_unit};

use crate::calibrate;
use crate::failure::Failure;
use crate::numbers;
use crate::progress::{duration, seconds};
use crate::terminal::{Voice, answer};

/// Steps are timed for this long, s.
const TRIAL: f64 = 0.5;

/// Prints what there is to know of a case.
pub fn check(path: &Path, voice: Voice) -> Result<ExitCode, Failure> {
    let (measured, of_films) = calibrate::known(path, &Case::from_file(path)?)?;
    let case = Case::from_file_with(path, &measured)?;
    voice.warn_of(&case);
    match case.dimension {
        2 => describe::<2>(&case, &of_films)?,
        _ => describe::<3>(&case, &of_films)?,
    }
    Ok(ExitCode::SUCCESS)
}

fn describe<const D: usize>(case: &Case, of_films: &[String]) -> Result<(), Failure>
where
    Space: Dimension<D>,
{
    let mut simulation =
        Simulation::<D>::new(case.setup()).map_err(|e| Failure::new(e.to_string()))?;
    let mut lines = vec![case.title.clone().unwrap_or_else(|| case.name.clone())];
    what(case, &mut lines);
    lines.extend(of_films.iter().map(|text| line("calibration", text)));
    let step = time_step(case, simulation.limits(), &mut lines);
    let steps = (case.end_time / step).ceil();
    let bytes = case.particle_count() as f64 * BYTES_PER_PARTICLE;
    lines.push("cost".into());
    lines.push(line(
        "steps",
        &format!("{steps:.0} to t = {}", seconds(case.end_time)),
    ));
    let megabytes = significant(bytes * 1e-6, 2);
    lines.push(line("memory", &format!("about {megabytes} MB")));
    // The trial takes a moment: what is known is said before it.
    answer(&lines.join("\n"))?;

    let begin = Instant::now();
    let mut done = 0_u32;
    while begin.elapsed().as_secs_f64() < TRIAL && f64::from(done) < steps {
        simulation
            .step()
            .map_err(|diverged| Failure::diverged(&diverged, "the case cannot run as it stands"))?;
        done += 1;
    }
    let per_step = begin.elapsed().as_secs_f64() / f64::from(done.max(1));
    let threads = rayon::current_num_threads();
    answer(&line(
        "time",
        &format!(
            "about {} on {threads} thread{} here ({} M particle-steps/s over {done} steps)",
            duration(per_step * steps),
            if threads == 1 { "" } else { "s" },
            significant(case.particle_count() as f64 / per_step * 1e-6, 2)
        ),
    ))
}

/// What the case is: bodies, numbers, sound.
fn what(case: &Case, lines: &mut Vec<String>) {
    let (mass_unit, volume_unit, volume_word) = match case.dimension {
        2 => ("kg/m", "m^2", "area"),
        _ => ("kg", "m^3", "volume"),
    };
    for body in &case.bodies {
        let text = format!(
            "{} particles of {}, {volume_word} {}, mass {}",
            body.particles,
            case.fluids[body.fluid].name,
            with_unit(body.volume, volume_unit, 5),
            with_unit(body.mass, mass_unit, 5)
        );
        lines.push(line(&body.name, &text));
    }
    for wall in &case.walls {
        lines.push(line(
            &wall.name,
            &format!("{} particles of wall", wall.particles),
        ));
    }
    let text = format!(
        "{} in {}D, {} apart",
        case.particle_count(),
        case.dimension,
        with_unit(case.spacing, "m", 4)
    );
    lines.push(line("particles", &text));
    for number in numbers::of(case) {
        let value = significant(number.value, 4);
        let text = format!("{value:<9} {}", number.meaning);
        lines.push(line(number.name, &text));
    }
    if let Some(model) = &case.scheme.van_der_waals {
        lines.extend(van_der_waals(case, model));
        return;
    }
    for fluid in &case.fluids {
        let text = format!(
            "{} in {}, {} expected",
            with_unit(fluid.sound_speed, "m/s", 4),
            fluid.name,
            with_unit(case.speeds.largest(), "m/s", 3)
        );
        lines.push(line("sound speed", &text));
    }
    lines.extend(pairwise(case));
    let percent = significant(100.0 * numbers::expected_density_error(case), 2);
    let text = format!("about {percent} % expected, (largest speed / sound speed)^2");
    lines.push(line("density error", &text));
}

/// What the equation of state says of the fluid at the start.
fn van_der_waals(case: &Case, model: &VanDerWaals) -> Vec<String> {
    let substance = &model.substance;
    let critical = substance.critical_point();
    let reduced = model.temperature / critical.temperature;
    let fluid = &case.fluids[0];
    let mut lines = vec![
        line(
            "sound speed",
            &format!(
                "{} in {} at the start, {} of its repulsion alone; {} expected",
                with_unit(fluid.sound_speed, "m/s", 4),
                fluid.name,
                with_unit(
                    substance.stiff_sound_speed(fluid.density, model.temperature),
                    "m/s",
                    4
                ),
                with_unit(case.speeds.largest(), "m/s", 3)
            ),
        ),
        line(
            "substance",
            &format!(
                "R {}, a {}, b {}, xi {}",
                with_unit(substance.gas_constant, "J/kg/K", 4),
                with_unit(substance.cohesion, "Pa m^6/kg^2", 4),
                with_unit(substance.excluded_volume, "m^3/kg", 4),
                significant(substance.degrees_of_freedom, 3)
            ),
        ),
        line(
            "critical point",
            &format!(
                "{}, {}, {}",
                with_unit(critical.temperature, "K", 4),
                with_unit(critical.pressure, "Pa", 4),
                with_unit(critical.density, "kg/m^3", 4)
            ),
        ),
        line(
            "at the start",
            &format!(
                "{}, {} of the critical point",
                with_unit(model.temperature, "K", 4),
                significant(reduced, 3)
            ),
        ),
    ];
    let Some(phases) = theory::coexistence(reduced) else {
        return lines;
    };
    let density = |ratio: f64| with_unit(ratio * critical.density, "kg/m^3", 4);
    let (liquid, vapour) = (density(phases.liquid), density(phases.vapour));
    lines.push(line(
        "liquid, vapour",
        &format!("{liquid} and {vapour} side by side at that temperature"),
    ));
    let sharp = theory::step_surface_tension(
        substance.cohesion,
        phases.liquid * critical.density,
        case.scheme.kernel,
        model.cohesion_range * case.scheme.smoothing_length,
        case.dimension,
    );
    let sharp = with_unit(sharp, "N/m", 4);
    lines.push(line(
        "sharp surface",
        &format!("{sharp} of that liquid; a soft one has less"),
    ));
    if fluid.surface_tension > 0.0 {
        let asked = with_unit(fluid.surface_tension, "N/m", 4);
        lines.push(line("soft surface", &format!("{asked} asked for")));
    }
    lines
}

/// What pairwise forces make of evenly spread particles with a sharp surface.
fn pairwise(case: &Case) -> Vec<String> {
    let Some(SurfaceTension::Pairwise(model)) = case.scheme.surface_tension else {
        return Vec::new();
    };
    let resolution = Resolution {
        kernel: case.scheme.kernel,
        smoothing_length: case.scheme.smoothing_length,
        spacing: case.spacing,
        dimension: case.dimension,
    };
    let mut lines = Vec::new();
    for fluid in &case.fluids {
        let sigma = |value: f64| with_unit(value, "N/m", 4);
        let text = format!(
            "{} in {}, {} with the pressure that cohesion makes",
            sigma(model.surface_tension(fluid, &resolution)),
            fluid.name,
            sigma(model.net_surface_tension(fluid, &resolution))
        );
        lines.push(line("sharp surface", &text));
        let pressure = with_unit(model.cohesion_pressure(fluid, &resolution), "Pa", 4);
        let text = format!("{pressure} in {}, in bulk", fluid.name);
        lines.push(line("cohesion", &text));
    }
    for (wall, scheme) in case.walls.iter().zip(&case.scheme.walls) {
        let fluid = &case.fluids[wall.fluid];
        let text = match model.contact_angle(scheme.adhesion, fluid, &resolution) {
            Some(angle) => format!("{:.1} degrees at {}", angle.to_degrees(), wall.name),
            None => format!("complete wetting at {}", wall.name),
        };
        lines.push(line("contact angle", &text));
    }
    lines
}

/// The limits of the time step, which governs, and the step itself, s.
fn time_step(case: &Case, at_start: StepLimits, lines: &mut Vec<String>) -> f64 {
    let limits = expected_limits(case, at_start);
    let (governing, shortest) = limits.governing();
    lines.push("time step".into());
    for (limit, value) in limits.all() {
        let shown = match value.is_finite() {
            true => seconds(value),
            false => "no limit".into(),
        };
        let mark = if limit == governing {
            "  <- governs"
        } else {
            ""
        };
        lines.push(line(&limit.to_string(), &format!("{shown}{mark}")));
    }
    let (step, how) = match case.scheme.time_step {
        TimeStep::Fixed(dt) => {
            let share = significant(dt / shortest, 3);
            (dt, format!("fixed, {share} times the shortest limit"))
        }
        TimeStep::Adaptive { safety } => (safety * shortest, "adaptive".into()),
    };
    lines.push(line("used", &format!("{} ({how})", seconds(step))));
    step
}

/// Limits at the start, with the speeds that the case is expected to reach.
fn expected_limits(case: &Case, at_start: StepLimits) -> StepLimits {
    let h = case.scheme.smoothing_length;
    let support = case.scheme.kernel.support() * h;
    if case.scheme.van_der_waals.is_some() {
        // Its state says more than what any case expects.
        return at_start;
    }
    let expected = StepLimits::new(&case.fluids, h, support, case.speeds.largest(), 0.0);
    StepLimits {
        force: at_start.force,
        pairwise: at_start.pairwise,
        ..expected
    }
}

fn line(name: &str, text: &str) -> String {
    format!("  {name:<14} {text}")
}
