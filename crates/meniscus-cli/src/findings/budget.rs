//! Whether the liquid's energy is what was put into it.

use meniscus_case::Case;
use meniscus_output::Series;

use super::{Findings, exact};
use crate::sample::budget::BUDGET;

/// Work put into the liquid since the start, less what kinetic and compression energy gained: over
/// time, as long as the series goes. Heat by friction, and what went into the surface.
pub fn lost(series: &Series) -> Option<Vec<f64>> {
    let [_, weight, walls] = BUDGET.map(|name| series.column(name));
    let (weight, walls) = (weight?, walls?);
    let kinetic = series.column("kinetic energy")?;
    let compression = series.column("compression energy")?;
    let start = kinetic.first()? + compression.first()?;
    Some(
        (0..kinetic.len())
            .map(|i| weight[i] + walls[i] - (kinetic[i] + compression[i] - start))
            .collect(),
    )
}

/// What was lost at the end, beside the work that was done.
pub fn measure(case: &Case, series: &Series, findings: &mut Findings) {
    let Some(lost) = lost(series) else {
        return;
    };
    let unit = if case.dimension == 2 { "J/m" } else { "J" };
    let last = |name: &str| series.column(name).and_then(<[f64]>::last).copied();
    for (name, id) in BUDGET[1..].iter().zip(["work-body-force", "work-walls"]) {
        if let Some(work) = last(name).filter(|work| *work != 0.0) {
            findings.add(id, name, unit, None, exact(work));
        }
    }
    if let Some(&end) = lost.last() {
        let name = "energy lost to heat and surface";
        findings.add("energy-lost", name, unit, None, exact(end));
    }
}
