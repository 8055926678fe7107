//! How round the first body is, how large, and how dense.

use meniscus::theory;
use meniscus_case::Case;
use meniscus_output::Series;

use super::{Findings, mean};
use crate::sample::asked::ROUNDNESS;

/// Identities and names of the columns' means.
const NUMBERS: [(&str, &str); ROUNDNESS.len()] = [
    ("circularity", "deviation of the outermost radius"),
    ("outline-radius", "mean radius of the outermost particles"),
    ("enclosing-radius", "radius that they enclose"),
    ("equivalent-radius", "radius by mass and density"),
    ("centre-pressure", "pressure at the centre"),
    ("centre-density", "density at the centre"),
];

/// Means over the time that is asked for, and what they say of compression.
pub fn measure(case: &Case, series: &Series, findings: &mut Findings) {
    let (Some(asked), Some(body)) = (&case.measure.roundness, case.bodies.first()) else {
        return;
    };
    for ((column, unit), (id, name)) in ROUNDNESS.into_iter().zip(NUMBERS) {
        match mean(series, column, asked) {
            Some(found) => findings.add(id, name, unit, None, found),
            None => findings
                .complaints
                .push(format!("no {name}: the series has none in that time")),
        }
    }
    let start = theory::equivalent_radius(body.volume, case.dimension);
    let size = if case.dimension == 2 {
        "area"
    } else {
        "volume"
    };
    for (column, id, by) in [
        ("equivalent radius", "compression", "mass and density"),
        (
            "enclosing radius",
            "outline-compression",
            "outermost particles",
        ),
    ] {
        if let Some(radius) = mean(series, column, asked) {
            let ratio = (radius.value / start).powi(case.dimension as i32);
            let slope = case.dimension as f64 * ratio / radius.value;
            let lost = meniscus::measure::Estimate {
                value: 100.0 * (1.0 - ratio),
                half_width: 100.0 * slope * radius.half_width,
            };
            findings.add(id, &format!("loss of {size} by {by}"), "%", None, lost);
        }
    }
}
