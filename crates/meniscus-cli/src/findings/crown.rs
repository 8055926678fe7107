//! Power laws of a crown's radii.

use meniscus::measure::PowerLaw;
use meniscus_case::Case;
use meniscus_output::Series;

use super::{Findings, exact, window};

/// Exponents of base and rim, and how high the rim gets.
pub fn measure(case: &Case, series: &Series, findings: &mut Findings) {
    let Some(asked) = &case.measure.crown else {
        return;
    };
    let (from, to) = (asked.window.from, asked.window.to);
    for (column, id, name) in [
        (
            "crown base radius",
            "crown-base-exponent",
            "exponent of the crown's base radius",
        ),
        (
            "crown rim radius",
            "crown-rim-exponent",
            "exponent of the crown's rim radius",
        ),
    ] {
        let Some((time, radius)) = window(series, column, from, to) else {
            continue;
        };
        match PowerLaw::fit(&time, &radius, asked.start) {
            Ok(fit) => {
                let theory = Some(("Yarin and Weiss", 0.5));
                findings.add(id, name, "", theory, fit.exponent);
            }
            Err(error) => findings.complaints.push(format!("no {name}: {error}")),
        }
    }
    if let Some((_, height)) = window(series, "crown rim height", from, to) {
        let highest = height.into_iter().fold(f64::NAN, f64::max);
        let name = "largest height of the crown's rim";
        findings.add("crown-height", name, "m", None, exact(highest));
    }
}
