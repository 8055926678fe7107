//! From the text of a file to a case: read, fill the bodies, choose what the
//! file leaves to the flow, check that the whole makes sense.

use std::path::{Path, PathBuf};

use meniscus::scheme::{Fluid, Scheme};
use toml::de::{DeTable, DeValue};

use crate::adaptive_smoothing;
use crate::bodies::{Filled, fill_all};
use crate::case::Case;
use crate::coefficients::{Coefficients, Given};
use crate::diagnostic::{Diagnostic, Diagnostics, Severity};
use crate::doubts::doubts;
use crate::grammar::{Draft, document};
use crate::pairwise;
use crate::read::{Context, Echo, Node};
use crate::speed::{SpeedScales, default_sound_speed};
use crate::van_der_waals;
use crate::walls::largest_speed;

pub(crate) fn resolve(
    name: &str,
    source: &str,
    measured: &Coefficients,
) -> Result<Case, Diagnostics> {
    let table = DeTable::parse(source).map_err(|error| syntax(name, source, &error))?;
    let tree = DeValue::Table(table.into_inner());
    let context = Context {
        folder: Path::new(name)
            .parent()
            .map_or_else(PathBuf::new, Path::to_path_buf),
        ..Context::default()
    };
    let mut node = Node::root(&context, Some(&tree));
    let mut draft = document(&mut node);
    let mut echo = node.echo;

    let mut problems = context.diagnostics.take();
    let case = if problems.is_empty() {
        measured.apply(&mut draft, &mut echo);
        van_der_waals::complete(&mut draft);
        assemble(name, draft, &mut echo, &mut problems)
    } else {
        None
    };
    let diagnostics = Diagnostics::new(name, source, problems);
    match case {
        Some(case) => Ok(Case {
            warnings: diagnostics,
            resolved: echo.document(),
            ..case
        }),
        None => Err(diagnostics),
    }
}

/// What is not TOML.
fn syntax(name: &str, source: &str, error: &toml::de::Error) -> Diagnostics {
    let span = error.span().unwrap_or(0..0);
    let before = source.get(..span.start).unwrap_or_default();
    let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
    let line = source[line_start..].lines().next().unwrap_or_default();
    let value = line.split_once('=').map_or("", |(_, value)| value.trim());
    // The likeliest slip in a file of quantities.
    let bare_quantity = value.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c))
        && value.contains(char::is_alphabetic);
    let help = if bare_quantity {
        format!("a quantity with its unit stands in quotes: \"{value}\"")
    } else {
        "a line is a [section], or key = value with text in quotes".into()
    };
    let problem = Diagnostic {
        severity: Severity::Error,
        message: format!("this is not TOML: {}", error.message()),
        label: "here".into(),
        help: Some(help),
        span: Some(span),
    };
    Diagnostics::new(name, source, vec![problem])
}

/// Fills the bodies and checks the whole; none if an error turns up.
fn assemble(
    name: &str,
    draft: Draft,
    echo: &mut Echo,
    problems: &mut Vec<Diagnostic>,
) -> Option<Case> {
    let Filled {
        particles,
        bodies,
        walls,
    } = fill_all(&draft, problems)?;
    let mut fluids: Vec<Fluid> = draft
        .fluids
        .iter()
        .map(|draft| draft.fluid.clone())
        .collect();
    let volumes: Vec<(usize, f64)> = bodies
        .iter()
        .map(|body| (body.fluid, body.volume))
        .collect();
    let body_force = draft.physics.body_force.as_ref();
    let of_fluid = bodies.iter().map(|body| body.particles).sum();
    let liquid = &particles[..of_fluid];
    let mut speeds = SpeedScales::new(draft.dimension, liquid, &fluids, &volumes, body_force);
    speeds.initial = speeds.initial.max(largest_speed(&walls, &particles));
    speeds.cohesion = pairwise::cohesion_speed(&draft, &fluids);
    let (walls, wall_schemes) = walls.into_iter().unzip();
    choose_sound_speeds(&draft, &speeds, &mut fluids, echo, problems);
    warn_of_idle_surface_tension(&draft, problems);
    problems.extend(doubts(&draft, &volumes));
    pairwise::check(&draft, problems);
    adaptive_smoothing::check(&draft, problems);
    van_der_waals::check(&draft, problems);
    if problems.iter().any(|p| p.severity == Severity::Error) {
        return None;
    }
    let any_tension =
        pairwise::has_gamma(&draft) || fluids.iter().any(|fluid| fluid.surface_tension > 0.0);
    let given = Given::of(&draft);
    let stem = Path::new(name).file_stem();
    let own = (draft.fluids.iter()).find_map(|draft| draft.van_der_waals.clone());
    let (model, span) = own.map(|own| (own.model, own.span)).unzip();
    let physics = draft.physics;
    let case = Case {
        name: stem.map_or(name.into(), |stem| stem.to_string_lossy().into_owned()),
        title: draft.title,
        description: draft.description,
        dimension: draft.dimension,
        spacing: draft.spacing,
        end_time: draft.end_time,
        scheme: Scheme {
            kernel: draft.kernel,
            smoothing_length: draft.smoothing_length,
            adaptive_smoothing: physics.adaptive_smoothing,
            density: physics.density,
            density_diffusion: physics.density_diffusion,
            pressure: physics.pressure,
            artificial_viscosity: physics.artificial_viscosity,
            viscosity: physics.viscosity,
            body_force: physics.body_force,
            velocity_smoothing: physics.velocity_smoothing,
            surface_tension: physics.surface_tension.filter(|_| any_tension),
            van_der_waals: model,
            damping: physics.damping,
            walls: wall_schemes,
            integrator: physics.integrator,
            time_step: physics.time_step,
            precision: draft.precision,
        },
        fluids,
        bodies,
        walls,
        periodic: draft.periodic,
        deformation: draft.deformation,
        output: draft.output,
        measure: draft.measure,
        speeds,
        given,
        warnings: Diagnostics::new(name, "", Vec::new()),
        particles,
        resolved: String::new(),
    };
    let refused = span.and_then(|span| Some((span, van_der_waals::refused(&case)?)));
    if let Some((span, reason)) = refused {
        problems.push(Diagnostic {
            severity: Severity::Error,
            message: reason,
            label: "of this kind".into(),
            help: None,
            span: Some(span),
        });
        return None;
    }
    Some(case)
}

/// Gives fluids without a sound speed the default, and warns of one that is too low.
fn choose_sound_speeds(
    draft: &Draft,
    speeds: &SpeedScales,
    fluids: &mut [Fluid],
    echo: &mut Echo,
    problems: &mut Vec<Diagnostic>,
) {
    let right = default_sound_speed(speeds);
    for (fluid, draft) in fluids.iter_mut().zip(&draft.fluids) {
        if draft.van_der_waals.is_some() {
            continue;
        }
        let Some(span) = &draft.sound_speed_span else {
            fluid.sound_speed = right;
            echo.insert(
                &["fluid", &fluid.name],
                "sound_speed",
                Echo::text(&format!("{right} m/s")),
            );
            continue;
        };
        if speeds.largest() > 0.0 && fluid.sound_speed < right * (1.0 - 1e-9) {
            let change = 100.0 * (speeds.largest() / fluid.sound_speed).powi(2);
            problems.push(Diagnostic {
                severity: Severity::Warning,
                message: format!("the sound speed of \"{}\" is low for the speeds of this case", fluid.name),
                label: format!("density will change by about {change:.1} %"),
                help: Some(format!(
                    "the case shows {:.3} m/s: ten times that, {right:.3} m/s, keeps density within about 1 %",
                    speeds.largest()
                )),
                span: Some(span.clone()),
            });
        }
    }
}

fn warn_of_idle_surface_tension(draft: &Draft, problems: &mut Vec<Diagnostic>) {
    if draft.physics.surface_tension.is_some() {
        return;
    }
    let idle = draft
        .fluids
        .iter()
        .filter(|draft| draft.fluid.surface_tension > 0.0 && draft.van_der_waals.is_none());
    problems.extend(
        idle.filter_map(|draft| draft.surface_tension_span.clone())
            .map(|span| Diagnostic {
                severity: Severity::Warning,
                message: "this surface tension does nothing".into(),
                label: "[physics] surface_tension is \"none\"".into(),
                help: Some("choose a model there, or leave it out for the default".into()),
                span: Some(span),
            }),
    );
}
