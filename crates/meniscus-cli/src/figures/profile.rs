//! Pressure against distance from the centre, beside Young and Laplace.

use meniscus::measure::radial_profile;
use meniscus::{Vector, theory};
use meniscus_case::Case;
use meniscus_output::{Frame, FrameReader, OutputError};
use meniscus_report::{Axis, Curve, Figure, LinePlot};

use super::{evenly, walls};
use crate::findings::Findings;
use crate::progress::seconds;

/// Frames that a mean is taken over, at most.
const FRAMES: usize = 24;
/// Points that are drawn, about: more would only cover one another.
const POINTS: usize = 4000;
/// Where the figure ends, in radii of the body.
const EDGE: f64 = 1.15;

/// Of the only body, over the last period where it oscillates, over the
/// window of a static pressure where that is measured, else of the last frame.
pub fn figure(
    case: &Case,
    reader: &FrameReader,
    measured: &Findings,
) -> Result<Option<Figure>, OutputError> {
    let ([body], false) = (&case.bodies[..], case.periodic.iter().any(Option::is_some)) else {
        return Ok(None);
    };
    let sigma = case.fluids[body.fluid].surface_tension;
    let (Some(&end), true) = (reader.times().last(), sigma > 0.0) else {
        return Ok(None);
    };
    let from = match (&measured.fit, &case.measure.static_pressure) {
        (Some(fit), _) => (end - fit.period().value).max(0.0),
        (None, Some(asked)) => asked.window.from.min(end),
        (None, None) => end,
    };
    let radius = theory::equivalent_radius(body.volume, case.dimension);
    let mut all = Cloud::default();
    let mut last = Cloud::default();
    let chosen = evenly(reader.times(), from, end, FRAMES);
    for &k in &chosen {
        last = Cloud::of(&reader.read(k)?);
        all.positions.extend(&last.positions);
        all.pressure.extend(&last.pressure);
    }
    let bins = (radius / case.spacing).ceil().max(4.0) as usize;
    let means = radial_profile(
        &all.positions,
        &all.pressure,
        Vector::ZERO,
        radius * EDGE,
        bins,
    );
    let (distances, pressures): (Vec<f64>, Vec<f64>) = (last.positions.iter())
        .zip(&last.pressure)
        .step_by(1 + last.positions.len() / POINTS)
        .map(|(position, pressure)| (position.norm(), *pressure))
        .unzip();
    let (bin_radius, bin_mean): (Vec<f64>, Vec<f64>) =
        means.iter().map(|bin| (bin.radius, bin.mean)).unzip();
    let jump = theory::pressure_jump(sigma, radius, case.dimension);
    let plot = LinePlot::new(
        Axis::new("Distance from the centre", "m").limits(0.0, EDGE * radius),
        Axis::new("Pressure", "Pa"),
    )
    .with(Curve::points("particles", &distances, &pressures))
    .with(Curve::line("mean", &bin_radius, &bin_mean))
    .with(Curve::dashed(
        "Young and Laplace, at rest",
        &[0.0, radius, radius, EDGE * radius],
        &[jump, jump, 0.0, 0.0],
    ));
    let mut caption = format!("Pressure of the particles at t = {}", seconds(end));
    if let [first, _, ..] = chosen[..] {
        let begin = seconds(reader.times()[first]);
        caption.push_str(&format!(
            ", and its mean over {} frames from t = {begin}",
            chosen.len()
        ));
    }
    Ok(Some(
        plot.figure("pressure-profile", &format!("{caption}.")),
    ))
}

/// Particles about their mean position.
#[derive(Default)]
struct Cloud {
    positions: Vec<Vector<f64, 3>>,
    pressure: Vec<f64>,
}

impl Cloud {
    fn of(frame: &Frame) -> Self {
        let is_wall = walls(frame);
        let liquid: Vec<usize> = (0..frame.positions.len())
            .filter(|&i| !is_wall(i))
            .collect();
        let mut centre = Vector::<f64, 3>::ZERO;
        for &i in &liquid {
            centre += Vector(frame.positions[i]) * (1.0 / liquid.len() as f64);
        }
        let pressure = frame.fields.iter().find(|field| field.name == "pressure");
        let pressures = pressure.map(|field| liquid.iter().map(|&i| field.values[i]).collect());
        Self {
            positions: (liquid.iter())
                .map(|&i| Vector(frame.positions[i]) - centre)
                .collect(),
            pressure: pressures.unwrap_or_default(),
        }
    }
}
