//! Pictures of the particles at chosen times.

use meniscus_case::Case;
use meniscus_output::{Field, Frame, FrameReader};
use meniscus_report::{Direction, Figure, Movie, ParticlePictures, Snapshot, View};

use super::{evenly, walls};
use crate::failure::Failure;
use crate::findings::Findings;

/// Panels of a figure.
const PANELS: usize = 6;
/// Pictures of a movie, at most.
const MOVIE: usize = 60;

/// Pressure and speed, and with several bodies where the liquid came from: over the first period of an oscillation, else over the whole run.
pub fn figures(
    case: &Case,
    reader: &FrameReader,
    measured: &Findings,
) -> Result<Vec<Figure>, Failure> {
    let Some(&end) = reader.times().last() else {
        return Ok(Vec::new());
    };
    let period = measured.fit.as_ref().map(|fit| fit.period().value);
    let span = period.map_or(end, |period| period.min(end));
    let chosen = match &case.output.pictures[..] {
        [] => evenly(reader.times(), 0.0, span, PANELS),
        asked => (asked.iter())
            .flat_map(|&time| evenly(reader.times(), time, time, 1))
            .collect(),
    };
    let frames = chosen
        .into_iter()
        .map(|k| reader.read(k))
        .collect::<Result<Vec<Frame>, _>>()?;
    let (inside, outside) = match case.dimension {
        2 => ("Particles", "Particles"),
        _ => (
            "Particles of a slice through the middle",
            "Particles, seen from the side",
        ),
    };
    let mut speed = from_outside(case, &frames, "Speed", "m/s");
    if case.dimension == 2 {
        speed = speed.arrows(arrows(&frames));
    }
    let mut figures = vec![
        pictures(case, &frames, "Pressure", "Pa")
            .view(slice(case, &frames))
            .figure("pressure", &format!("{inside}, coloured by pressure.")),
        speed.figure("speed", &format!("{outside}, coloured by speed.")),
    ];
    if case.scheme.van_der_waals.is_some() {
        figures.push(
            pictures(case, &frames, "Temperature", "K")
                .view(slice(case, &frames))
                .figure(
                    "temperature",
                    &format!("{inside}, coloured by temperature."),
                ),
        );
    }
    if case.bodies.len() > 1 {
        let names: Vec<&str> = case.bodies.iter().map(|body| body.name.as_str()).collect();
        figures.push(
            pictures(case, &frames, "Body", "")
                .named(&names)
                .view(slice(case, &frames))
                .figure(
                    "body",
                    &format!("{inside}, coloured by the body they began in."),
                ),
        );
    }
    if !case.measure.curvature.is_empty() {
        for (label, unit) in [
            ("Colour", ""),
            ("Normal length", "1/m"),
            ("Curvature", "1/m"),
        ] {
            let name = label.to_lowercase();
            figures.push(
                pictures(case, &frames[..1], label, unit)
                    .view(slice(case, &frames))
                    .figure(
                        &name.replace(' ', "-"),
                        &format!("{inside} at the start, coloured by {name}."),
                    ),
            );
        }
    }
    Ok(figures)
}

/// The movie that the case asks for, if it does.
pub fn movie(case: &Case, reader: &FrameReader) -> Result<Option<Movie>, Failure> {
    let Some(name) = case.output.movie else {
        return Ok(None);
    };
    let end = reader.times().last().copied().unwrap_or(0.0);
    let frames = evenly(reader.times(), 0.0, end, MOVIE)
        .into_iter()
        .map(|k| reader.read(k))
        .collect::<Result<Vec<Frame>, _>>()?;
    let label = name[..1].to_uppercase() + &name[1..];
    let unit = (frames.first())
        .and_then(|frame| frame.fields.iter().find(|field| field.name == name))
        .map_or_else(String::new, |field| field.unit.clone());
    let caption = format!("Particles, coloured by {name}.");
    let names: Vec<&str> = match name {
        "body" => case.bodies.iter().map(|body| body.name.as_str()).collect(),
        "fluid" => case
            .fluids
            .iter()
            .map(|fluid| fluid.name.as_str())
            .collect(),
        _ => Vec::new(),
    };
    let pictures = from_outside(case, &frames, &label, &unit).named(&names);
    Ok(Some(pictures.movie("movie", &caption)))
}

/// Seen from the side. In 3D walls, and fluids around those with surface tension, are left out:
/// they would hide all.
fn from_outside(case: &Case, frames: &[Frame], label: &str, unit: &str) -> ParticlePictures {
    if case.dimension == 2 {
        return pictures(case, frames, label, unit);
    }
    let has_surface = |fluid: f64| {
        let fluid = case.fluids.get(fluid as usize);
        fluid.is_some_and(|fluid| fluid.surface_tension > 0.0)
    };
    let hides = case.fluids.iter().any(|fluid| fluid.surface_tension > 0.0);
    let seen: Vec<Frame> = (frames.iter())
        .map(|frame| {
            let is_wall = walls(frame);
            let fluid = frame.fields.iter().find(|field| field.name == "fluid");
            let fluid = |i: usize| fluid.map_or(0.0, |field| field.values[i]);
            let keep = |i: &usize| !is_wall(*i) && (!hides || has_surface(fluid(*i)));
            only(frame, (0..frame.positions.len()).filter(keep))
        })
        .collect();
    pictures(case, &seen, label, unit).view(View::Whole(direction(case)))
}

/// A frame of some of its particles, with its scalar fields.
fn only(frame: &Frame, rows: impl Iterator<Item = usize>) -> Frame {
    let rows: Vec<usize> = rows.collect();
    let scalars = (frame.fields.iter()).filter(|field| field.values.len() == frame.positions.len());
    Frame {
        positions: rows.iter().map(|&i| frame.positions[i]).collect(),
        fields: scalars
            .map(|field| {
                let values = rows.iter().map(|&i| field.values[i]).collect();
                Field::scalar(&field.name, &field.unit, values)
            })
            .collect(),
        ..*frame
    }
}

fn pictures(case: &Case, frames: &[Frame], label: &str, unit: &str) -> ParticlePictures {
    let name = label.to_lowercase();
    let snapshot = |frame: &Frame| {
        let field = frame.fields.iter().find(|field| field.name == name);
        let mut values = field.map(|field| field.values.clone()).unwrap_or_default();
        let is_wall = walls(frame);
        for (i, value) in values.iter_mut().enumerate() {
            if is_wall(i) {
                // Drawn grey.
                *value = f64::NAN;
            }
        }
        Snapshot {
            time: frame.time,
            positions: frame.positions.clone(),
            diameter: case.spacing,
            values,
        }
    };
    let empty = ParticlePictures::new(label, unit);
    (frames.iter().map(snapshot)).fold(empty, ParticlePictures::with)
}

/// Where the liquid of each frame goes; walls do not show it.
fn arrows(frames: &[Frame]) -> Vec<Vec<[f64; 3]>> {
    let of = |frame: &Frame| {
        let is_wall = walls(frame);
        let velocity = frame.fields.iter().find(|field| field.name == "velocity");
        let values = velocity.map_or(&[][..], |field| &field.values);
        (values.chunks_exact(3).enumerate())
            .map(|(i, v)| {
                if is_wall(i) {
                    [0.0; 3]
                } else {
                    [v[0], v[1], v[2]]
                }
            })
            .collect()
    };
    frames.iter().map(of).collect()
}

/// In three dimensions along y, z upwards.
fn direction(case: &Case) -> Direction {
    if case.dimension == 2 {
        Direction::Z
    } else {
        Direction::Y
    }
}

/// What shows the inside: everything in 2D, in 3D a layer through the mean position.
fn slice(case: &Case, frames: &[Frame]) -> View {
    if case.dimension == 2 {
        return View::Whole(direction(case));
    }
    let depths = || (frames.iter().flat_map(|frame| &frame.positions)).map(|x| x[1]);
    View::Slice {
        direction: direction(case),
        at: depths().sum::<f64>() / depths().count().max(1) as f64,
        // More than a layer: the middle of a body is often between two.
        thickness: 1.5 * case.spacing,
    }
}
