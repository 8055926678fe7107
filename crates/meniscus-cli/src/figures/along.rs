//! Curvature along a round part of the surface.

use std::f64::consts::PI;

use meniscus_case::{Arc, Case};
use meniscus_output::FrameReader;
use meniscus_report::{Axis, Curve, Figure, LinePlot};

use super::walls;
use crate::failure::Failure;
use crate::sample::arc::along;

/// At the start, with what a circle or sphere has.
pub fn figure(case: &Case, reader: &FrameReader) -> Result<Option<Figure>, Failure> {
    let (Some(arc), true) = (&case.measure.curvature_along, !reader.times().is_empty()) else {
        return Ok(None);
    };
    let frame = reader.read(0)?;
    let Some(field) = frame.fields.iter().find(|field| field.name == "curvature") else {
        return Ok(None);
    };
    let is_wall = walls(&frame);
    let rows = (0..frame.positions.len())
        .filter(|&i| !is_wall(i))
        .map(|i| (frame.positions[i], field.values[i]));
    // Beyond the part that is measured too.
    let whole = Arc {
        from: 0.0,
        to: PI,
        ..arc.clone()
    };
    let mut found = along(&whole, case.spacing, rows);
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (angle, curvature): (Vec<f64>, Vec<f64>) =
        found.into_iter().map(|(a, k)| (a.to_degrees(), k)).unzip();
    let exact = (case.dimension - 1) as f64 / arc.radius;
    let ends = [arc.from.to_degrees(), arc.to.to_degrees()];
    let plot = LinePlot::new(
        Axis::new("Angle (degrees)", ""),
        Axis::new("Curvature", "1/m"),
    )
    .with(Curve::points("computed", &angle, &curvature))
    .with(Curve::dashed("of a round surface", &ends, &[exact, exact]));
    let caption = "Curvature of the outermost particles along the arc, at the start.";
    Ok(Some(plot.figure("curvature-along", caption)))
}
