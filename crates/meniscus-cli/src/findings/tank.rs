//! How the surface in a tank meets its walls.

use meniscus::theory::meniscus_rise;
use meniscus_case::Case;
use meniscus_output::Series;

use super::{Findings, mean};
use crate::sample::asked::MENISCUS;

/// Means over both walls and the time that is asked for.
pub fn measure(case: &Case, series: &Series, findings: &mut Findings) {
    let Some(asked) = &case.measure.meniscus else {
        return;
    };
    let rise = asked.expected.zip(asked.capillary_length);
    let rise = rise.map(|(angle, length)| ("exact meniscus", meniscus_rise(angle, length)));
    let angle = asked.expected.map(|angle| ("expected", angle.to_degrees()));
    let numbers = [
        (0, 0, "liquid-level", "level of the liquid", None),
        (1, 2, "meniscus-rise", "rise at the walls", rise),
        (3, 4, "meniscus-angle", "contact angle at the walls", angle),
        (
            5,
            6,
            "capillary-length",
            "capillary length by the shape",
            None,
        ),
    ];
    for (left, right, id, name, reference) in numbers {
        if id == "capillary-length" && asked.capillary_length.is_some() {
            continue;
        }
        let unit = MENISCUS[left].1;
        let sides = [left, right].map(|column| mean(series, MENISCUS[column].0, &asked.window));
        if let [Some(mut found), Some(other)] = sides {
            found.value = 0.5 * (found.value + other.value);
            // Both swing together.
            found.half_width = 0.5 * (found.half_width + other.half_width);
            findings.add(id, name, unit, reference, found);
        } else {
            findings
                .complaints
                .push(format!("no {name}: the series has none in that time"));
        }
    }
}
