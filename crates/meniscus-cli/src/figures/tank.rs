//! The surface in a tank, beside the exact meniscus.

use meniscus::measure::surface_profile;
use meniscus::{Vector, theory};
use meniscus_case::Case;
use meniscus_output::{FrameReader, Series};
use meniscus_report::{Axis, Curve, Figure, LinePlot};

use super::walls;
use crate::failure::Failure;
use crate::findings::mean;
use crate::progress::seconds;
use crate::sample::asked::MENISCUS;

/// Points of a drawn curve.
const POINTS: usize = 200;

/// At the end of the run, with the menisci of the angle and the capillary length that the case
/// gives, or else those fitted.
pub fn figure(
    case: &Case,
    reader: &FrameReader,
    series: &Series,
) -> Result<Option<Figure>, Failure> {
    let (Some(asked), Some(last)) = (&case.measure.meniscus, reader.times().len().checked_sub(1))
    else {
        return Ok(None);
    };
    let frame = reader.read(last)?;
    let is_wall = walls(&frame);
    let liquid: Vec<usize> = (0..frame.positions.len())
        .filter(|&i| !is_wall(i))
        .collect();
    let place = |&i: &usize| Vector(frame.positions[i]);
    let profile = if case.dimension == 2 {
        let places: Vec<_> = liquid
            .iter()
            .map(|i| Vector::<f64, 2>::from_3d(place(i).0))
            .collect();
        surface_profile(&places, case.spacing, asked.walls)
    } else {
        let places: Vec<_> = liquid.iter().map(place).collect();
        surface_profile(&places, case.spacing, asked.walls)
    };
    let (x, z): (Vec<f64>, Vec<f64>) = profile.into_iter().map(|[x, z]| (x, z)).unzip();
    let mut plot = LinePlot::new(Axis::new("x", "m"), Axis::new("Height", "m"))
        .with(Curve::points("particles of the surface", &x, &z));
    let of = |column: usize| mean(series, MENISCUS[column].0, &asked.window).map(|m| m.value);
    let fitted = |a: usize| Some(0.5 * (of(a)? + of(a + 1)?));
    let angle = asked.expected.or_else(|| fitted(3).map(f64::to_radians));
    let length = asked.capillary_length.or_else(|| fitted(5));
    let mut caption = format!("Particles of the surface at t = {}.", seconds(frame.time));
    if let (Some(level), Some(angle), Some(length)) = (of(0), angle, length) {
        let [left, right] = asked.walls;
        let places: Vec<f64> = (0..=POINTS)
            .map(|i| left + (right - left) * i as f64 / POINTS as f64)
            .collect();
        let height = |x: &f64| {
            let away = [x - left, right - x];
            let rises = away.map(|away| theory::meniscus_height(away, angle, length));
            // Theirs is the line of the centres, half a spacing below the surface.
            level - 0.5 * case.spacing + rises[0] + rises[1]
        };
        let heights: Vec<f64> = places.iter().map(height).collect();
        plot = plot.with(Curve::dashed("exact meniscus", &places, &heights));
        caption.push_str(&format!(
            " The exact menisci at {:.0} degrees with a capillary length of {:.3e} m, half a spacing lower.",
            angle.to_degrees(),
            length
        ));
    }
    Ok(Some(plot.figure("meniscus", &caption)))
}
