//! `meniscus check`: what a case is and what it will cost, without running it.

use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

use meniscus::Simulation;
use meniscus::rates::{Dimension, Space};
use meniscus::scheme::TimeStep;
use meniscus::time::step::StepLimits;
use meniscus_case::{BYTES_PER_PARTICLE, Case};
use meniscus_report::number::{significant, with_unit};

use crate::failure::Failure;
use crate::numbers;
use crate::progress::{duration, seconds};

/// Steps are timed for this long, s.
const TRIAL: f64 = 1.0;

/// Prints what there is to know of a case.
pub fn check(path: &Path) -> Result<ExitCode, Failure> {
    let case = Case::from_file(path)?;
    if !case.warnings.is_empty() {
        let colour = std::io::IsTerminal::is_terminal(&std::io::stdout());
        println!("{}", case.warnings.render(colour));
    }
    match case.dimension {
        2 => describe::<2>(&case)?,
        _ => describe::<3>(&case)?,
    }
    Ok(ExitCode::SUCCESS)
}

fn describe<const D: usize>(case: &Case) -> Result<(), Failure>
where
    Space: Dimension<D>,
{
    let (mass_unit, volume_unit) = if D == 2 {
        ("kg/m", "m^2")
    } else {
        ("kg", "m^3")
    };
    println!("{}", case.title.as_deref().unwrap_or(&case.name));
    for body in &case.bodies {
        let fluid = &case.fluids[body.fluid];
        line(
            &body.name,
            &format!(
                "{} particles of {}, {}, {}",
                body.particles,
                fluid.name,
                with_unit(body.volume, volume_unit, 5),
                with_unit(body.mass, mass_unit, 5)
            ),
        );
    }
    line(
        "particles",
        &format!(
            "{} in {D}D, {} apart",
            case.particle_count(),
            with_unit(case.spacing, "m", 4)
        ),
    );
    for number in numbers::of(case) {
        line(
            number.name,
            &format!("{:<12} {}", significant(number.value, 4), number.meaning),
        );
    }
    for fluid in &case.fluids {
        line(
            &format!("c of {}", fluid.name),
            &with_unit(fluid.sound_speed, "m/s", 4),
        );
    }
    let error = 100.0 * numbers::expected_density_error(case);
    line(
        "density error",
        &format!("about {} % expected, (U/c)^2", significant(error, 2)),
    );

    let mut simulation =
        Simulation::<D>::new(case.setup()).map_err(|e| Failure::new(e.to_string()))?;
    let limits = expected_limits(case, simulation.limits());
    println!("time step");
    let (governing, shortest) = limits.governing();
    for (limit, value) in limits.all() {
        let mark = if limit == governing {
            "  <- governs"
        } else {
            ""
        };
        let shown = if value.is_finite() {
            seconds(value)
        } else {
            "none".into()
        };
        line(&limit.to_string(), &format!("{shown}{mark}"));
    }
    let step = match case.scheme.time_step {
        TimeStep::Fixed(dt) => {
            line(
                "used",
                &format!(
                    "{} (fixed, {} of the shortest limit)",
                    seconds(dt),
                    significant(dt / shortest, 3)
                ),
            );
            dt
        }
        TimeStep::Adaptive { safety } => {
            line(
                "used",
                &format!("{} (adaptive)", seconds(safety * shortest)),
            );
            safety * shortest
        }
    };
    let steps = (case.end_time / step).ceil();
    println!("cost");
    line(
        "steps",
        &format!("{steps:.0} to {}", seconds(case.end_time)),
    );
    let bytes = case.particle_count() as f64 * BYTES_PER_PARTICLE as f64;
    line(
        "memory",
        &format!("about {} MB", significant(bytes * 1e-6, 2)),
    );
    let begin = Instant::now();
    let mut done = 0;
    while begin.elapsed().as_secs_f64() < TRIAL && f64::from(done) < steps {
        if let Err(diverged) = simulation.step() {
            return Err(Failure::diverged(
                &diverged,
                "the case cannot run like this",
            ));
        }
        done += 1;
    }
    let per_step = begin.elapsed().as_secs_f64() / f64::from(done.max(1));
    line(
        "time",
        &format!(
            "about {} on {} threads here ({done} steps timed, {} M particle-steps/s)",
            duration(per_step * steps),
            rayon::current_num_threads(),
            significant(case.particle_count() as f64 / per_step * 1e-6, 2)
        ),
    );
    Ok(())
}

/// Limits at the start, with the speeds that the case is expected to reach.
fn expected_limits(case: &Case, at_start: StepLimits) -> StepLimits {
    let support = case.scheme.kernel.support() * case.scheme.smoothing_length;
    let expected = StepLimits::new(
        &case.fluids,
        case.scheme.smoothing_length,
        support,
        case.speeds.largest(),
        0.0,
    );
    StepLimits {
        force: at_start.force,
        ..expected
    }
}

fn line(name: &str, text: &str) {
    println!("  {name:<14} {text}");
}
