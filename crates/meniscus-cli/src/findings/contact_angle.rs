//! How a drop stands on a wall.

use meniscus_case::Case;
use meniscus_output::Series;

use super::{Findings, exact, mean, window};
use crate::sample::asked::CONTACT_ANGLE;

/// Identities and names of the means of the first four columns.
const NUMBERS: [(&str, &str); 4] = [
    ("contact-angle", "contact angle by a circle or sphere"),
    ("contact-angle-tangent", "contact angle by the tangent"),
    ("wetted-radius", "radius of the wetted area"),
    ("drop-height", "height of the drop"),
];

/// Means over the time that is asked for, and how far the drop left the wall in all the run.
pub fn measure(case: &Case, series: &Series, findings: &mut Findings) {
    let Some(asked) = &case.measure.contact_angle else {
        return;
    };
    let expected = asked.expected.map(f64::to_degrees);
    for ((column, unit), (id, name)) in CONTACT_ANGLE.into_iter().zip(NUMBERS) {
        let reference = expected
            .filter(|_| unit == "deg")
            .map(|angle| ("expected", angle));
        match mean(series, column, &asked.window) {
            Some(found) => findings.add(id, name, unit, reference, found),
            None => findings
                .complaints
                .push(format!("no {name}: the series has none in that time")),
        }
    }
    let (gap, unit) = CONTACT_ANGLE[NUMBERS.len()];
    if let Some((_, gaps)) = window(series, gap, 0.0, case.end_time) {
        let largest = gaps.into_iter().fold(f64::NAN, f64::max);
        let name = "largest gap below the drop";
        findings.add("largest-gap", name, unit, None, exact(largest));
    }
}
