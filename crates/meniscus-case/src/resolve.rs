//! From the text of a file to a case: read, fill the bodies, check that the
//! whole makes sense.

use std::ops::Range;
use std::path::Path;

use meniscus::scheme::Scheme;
use meniscus::shape::{Arrangement, FillError, Shape};
use meniscus::{Particle, Vector};
use toml::de::{DeTable, DeValue};

use crate::case::{Body, Case};
use crate::diagnostic::{Diagnostic, Diagnostics, Severity};
use crate::grammar::{Draft, DraftBody, Geometry, document};
use crate::memory::{self, BYTES_PER_PARTICLE};
use crate::overlap::closest_of_two_bodies;
use crate::read::{Context, Echo, Node};
use crate::speed::{SpeedScales, default_sound_speed};

pub(crate) fn resolve(name: &str, source: &str) -> Result<Case, Diagnostics> {
    let table = DeTable::parse(source).map_err(|error| syntax(name, source, &error))?;
    let span = table.span();
    let tree = toml::Spanned::new(span, DeValue::Table(table.into_inner()));
    let context = Context::default();
    let mut node = Node::root(&context, Some(&tree));
    let draft = document(&mut node);
    let mut echo = node.echo;

    let mut problems = context.diagnostics.take();
    let case = if problems.is_empty() { assemble(name, draft, &mut echo, &mut problems) } else { None };
    let diagnostics = Diagnostics::new(name, source, problems);
    match case {
        Some(case) => Ok(Case { warnings: diagnostics, resolved: echo.document(), ..case }),
        None => Err(diagnostics),
    }
}

/// What is not TOML.
fn syntax(name: &str, source: &str, error: &toml::de::Error) -> Diagnostics {
    let span = error.span().unwrap_or(0..0);
    let line_start = source.get(..span.start).and_then(|s| s.rfind('\n')).map_or(0, |newline| newline + 1);
    let line = source.get(line_start..).and_then(|rest| rest.lines().next()).unwrap_or_default();
    let value = line.split_once('=').map_or("", |(_, value)| value.trim());
    // The likeliest slip in a file of quantities.
    let bare_quantity = value.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c))
        && value.contains(|c: char| c.is_alphabetic());
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
fn assemble(name: &str, draft: Draft, echo: &mut Echo, problems: &mut Vec<Diagnostic>) -> Option<Case> {
    let mut note = |severity, span: &Range<usize>, message: String, label: &str, help: String| {
        let (label, help, span) = (label.into(), Some(help), Some(span.clone()));
        problems.push(Diagnostic { severity, message, label, help, span });
    };
    let mut particles: Vec<Particle<3>> = Vec::new();
    let mut bodies = Vec::new();
    let mut failed = false;
    for (index, body) in draft.bodies.iter().enumerate() {
        let mut fail = |message: String, label: &str, help: String| {
            failed = true;
            note(Severity::Error, &body.shape_span, message, label, help);
        };
        let (room, free) = memory::room();
        let filled = match &body.geometry {
            Geometry::Plane(shape, arrangement) => fill(shape, arrangement, room - particles.len().min(room)),
            Geometry::Space(shape, arrangement) => fill(shape, arrangement, room - particles.len().min(room)),
        };
        let (positions, particle_volume) = match filled {
            Ok(filled) => filled,
            Err(FillError::TooMany { estimate, .. }) => {
                let bytes = estimate * BYTES_PER_PARTICLE;
                let coarser = draft.spacing * (1.1 * bytes / free).powf(1.0 / draft.dimension as f64);
                fail(
                    format!("{} is too large for this machine's memory", quoted(&body.name)),
                    &format!("up to {estimate:.1e} particles, {}; {} is free", size(bytes), size(free)),
                    format!("use a spacing of at least {coarser:.2e} m"),
                );
                continue;
            }
            Err(FillError::Empty) => {
                fail(
                    format!("{} holds no particle", quoted(&body.name)),
                    "no point of the arrangement is inside",
                    format!("enlarge the shape, or use a spacing well below {} m", draft.spacing),
                );
                continue;
            }
            Err(FillError::Unbounded) => {
                fail(
                    format!("{} has no end", quoted(&body.name)),
                    "endless",
                    "intersect it with a shape that has an end".into(),
                );
                continue;
            }
            // The file's spacing has been checked.
            Err(error @ FillError::Spacing(_)) => {
                fail(error.to_string(), "cannot be filled", "give a positive spacing".into());
                continue;
            }
        };
        if let Some((axis, x)) = outside(&positions, &draft.periodic) {
            fail(
                format!("{} reaches outside the periodic box", quoted(&body.name)),
                &format!("a particle at {axis} = {x:.4e} m"),
                format!("keep it within [periodic] {axis}, or widen the box"),
            );
            continue;
        }
        let density = draft.fluids.get(body.fluid)?.fluid.density;
        let mass = density * particle_volume;
        let count = positions.len();
        bodies.push(Body {
            name: body.name.clone(),
            fluid: body.fluid,
            particles: count,
            volume: particle_volume * count as f64,
            mass: mass * count as f64,
        });
        particles.extend(moving(body, &positions, mass, index as u16));
    }
    if failed {
        return None;
    }

    if draft.bodies.len() > 1
        && let Some((i, j)) = closest_of_two_bodies(&particles, &draft.periodic, 0.5 * draft.spacing)
    {
        let (one, other) = (&draft.bodies[particles[i].body as usize], &draft.bodies[particles[j].body as usize]);
        let x = particles[j].position.0;
        note(
            Severity::Error,
            &other.shape_span,
            format!("{} and {} overlap", quoted(&one.name), quoted(&other.name)),
            &format!("two particles less than half a spacing apart near {:.4e}, {:.4e}, {:.4e} m", x[0], x[1], x[2]),
            "move one of them, or cut one out of the other with a difference".into(),
        );
        return None;
    }

    let volumes: Vec<(usize, f64)> = bodies.iter().map(|body| (body.fluid, body.volume)).collect();
    let mut fluids: Vec<_> = draft.fluids.iter().map(|draft| draft.fluid.clone()).collect();
    let speeds =
        SpeedScales::new(draft.dimension, &particles, &fluids, &volumes, draft.physics.body_force.as_ref());
    let sound_speed = default_sound_speed(&speeds);
    for (fluid, draft) in fluids.iter_mut().zip(&draft.fluids) {
        match &draft.sound_speed_span {
            None => {
                fluid.sound_speed = sound_speed;
                let text = Echo::text(&format!("{sound_speed} m/s"));
                echo.insert(&["fluid", &fluid.name], "sound_speed", text);
            }
            Some(span) if fluid.sound_speed < sound_speed * (1.0 - 1e-9) && speeds.largest() > 0.0 => {
                let change = (speeds.largest() / fluid.sound_speed).powi(2);
                note(
                    Severity::Warning,
                    span,
                    format!("the sound speed of {} is low for the speeds of this case", quoted(&fluid.name)),
                    &format!("density will change by about {:.1} %", 100.0 * change),
                    format!(
                        "the case shows speeds of {:.3} m/s: ten times that, {sound_speed:.3} m/s, keeps density within about 1 %",
                        speeds.largest()
                    ),
                );
            }
            Some(_) => {}
        }
    }
    let any_tension = fluids.iter().any(|fluid| fluid.surface_tension > 0.0);
    if draft.physics.surface_tension.is_none() {
        let with_tension = draft.fluids.iter().filter(|draft| draft.fluid.surface_tension > 0.0);
        for span in with_tension.filter_map(|draft| draft.surface_tension_span.as_ref()) {
            note(
                Severity::Warning,
                span,
                "this surface tension does nothing".into(),
                "[physics] surface_tension is \"none\"",
                "choose a model there, or leave it out for the default".into(),
            );
        }
    }
    let physics = draft.physics;
    Some(Case {
        name: Path::new(name).file_stem().map_or(name.into(), |stem| stem.to_string_lossy().into_owned()),
        title: draft.title,
        description: draft.description,
        dimension: draft.dimension,
        spacing: draft.spacing,
        end_time: draft.end_time,
        scheme: Scheme {
            kernel: draft.kernel,
            smoothing_length: draft.smoothing_length,
            density: physics.density,
            pressure: physics.pressure,
            artificial_viscosity: physics.artificial_viscosity,
            viscosity: physics.viscosity,
            body_force: physics.body_force,
            surface_tension: physics.surface_tension.filter(|_| any_tension),
            damping: physics.damping,
            time_step: physics.time_step,
        },
        fluids,
        bodies,
        periodic: draft.periodic,
        output: draft.output,
        measure: draft.measure,
        speeds,
        warnings: Diagnostics::new(name, "", Vec::new()),
        particles,
        resolved: String::new(),
    })
}

/// Positions in 3D, and the volume of one particle.
fn fill<const D: usize>(
    shape: &Shape<D>,
    arrangement: &Arrangement<D>,
    room: usize,
) -> Result<(Vec<[f64; 3]>, f64), FillError> {
    let positions = arrangement.fill(shape, room)?;
    Ok((positions.iter().map(Vector::to_3d).collect(), arrangement.particle_volume()))
}

/// A coordinate that is not in the periodic box.
fn outside(positions: &[[f64; 3]], periodic: &[Option<(f64, f64)>; 3]) -> Option<(char, f64)> {
    let axes = ['x', 'y', 'z'].into_iter().zip(periodic).enumerate();
    for (d, (axis, interval)) in axes {
        let Some((low, high)) = interval else { continue };
        if let Some(x) = positions.iter().find(|x| !(*low..*high).contains(&x[d])) {
            return Some((axis, x[d]));
        }
    }
    None
}

/// A body's particles, each with its share of the body's motion.
fn moving(body: &DraftBody, positions: &[[f64; 3]], mass: f64, index: u16) -> impl Iterator<Item = Particle<3>> {
    let mut centre = Vector::<f64, 3>::ZERO;
    for position in positions {
        centre += Vector(*position) * (1.0 / positions.len() as f64);
    }
    let (velocity, omega, fluid) = (Vector(body.velocity), body.angular_velocity, body.fluid as u16);
    positions.iter().map(move |&position| {
        let position = Vector(position);
        let r = position - centre;
        let turning = Vector([
            omega[1] * r[2] - omega[2] * r[1],
            omega[2] * r[0] - omega[0] * r[2],
            omega[0] * r[1] - omega[1] * r[0],
        ]);
        Particle { position, velocity: velocity + turning, mass, fluid, body: index }
    })
}

fn quoted(name: &str) -> String {
    format!("\"{name}\"")
}

/// Bytes as people say them.
fn size(bytes: f64) -> String {
    let units = ["B", "kB", "MB", "GB", "TB", "PB", "EB"];
    let power = ((bytes.max(1.0).log10() / 3.0) as usize).min(units.len() - 1);
    format!("{:.1} {}", bytes / 1000_f64.powi(power as i32), units[power])
}
