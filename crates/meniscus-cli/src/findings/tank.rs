//! How the surface in a tank meets its walls.

use meniscus::theory::PlateMeniscus;
use meniscus_case::Case;
use meniscus_output::Series;

use super::{Findings, mean};
use crate::sample::asked::MENISCUS;

/// Capillary lengths between two walls that know nothing of each other.
const LONE: f64 = 8.0;
/// Places over which the level is averaged, from the middle to an eighth of the gap.
const PLACES: u32 = 16;

/// How far above the level, the mean of the middle quarter, the surface between two walls meets them, m.
fn exact_rise(gap: f64, angle: f64, length: f64) -> f64 {
    let plates = PlateMeniscus::new(gap, angle, length);
    let place = |k: u32| (f64::from(k) + 0.5) / f64::from(PLACES) * 0.125 * gap;
    let level = (0..PLACES).map(|k| plates.height(place(k))).sum::<f64>() / f64::from(PLACES);
    plates.wall - level
}

/// Means over both walls and the time that is asked for.
pub fn measure(case: &Case, series: &Series, findings: &mut Findings) {
    let Some(asked) = &case.measure.meniscus else {
        return;
    };
    let [left, right] = asked.walls;
    let rise = asked.expected.zip(asked.capillary_length);
    let rise =
        rise.map(|(angle, length)| ("exact meniscus", exact_rise(right - left, angle, length)));
    // The angle is read from the meniscus of a lone wall.
    let narrow = (asked.capillary_length).is_some_and(|length| right - left < LONE * length);
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
        if id == "capillary-length" && asked.capillary_length.is_some()
            || id == "meniscus-angle" && narrow
        {
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
