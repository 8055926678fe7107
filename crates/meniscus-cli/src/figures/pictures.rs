//! Pictures of the particles at chosen times.

use meniscus_case::Case;
use meniscus_output::{Frame, FrameReader};
use meniscus_report::{Direction, Figure, ParticlePictures, Snapshot, View};

use super::{evenly, walls};
use crate::failure::Failure;
use crate::findings::Findings;

/// Panels of a figure.
const PANELS: usize = 6;

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
    let frames = evenly(reader.times(), 0.0, span, PANELS)
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
    let mut figures = vec![
        pictures(case, &frames, "Pressure", "Pa")
            .view(slice(case, &frames))
            .figure("pressure", &format!("{inside}, coloured by pressure.")),
        pictures(case, &frames, "Speed", "m/s")
            .view(View::Whole(direction(case)))
            .figure("speed", &format!("{outside}, coloured by speed.")),
    ];
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
        thickness: case.spacing,
    }
}
