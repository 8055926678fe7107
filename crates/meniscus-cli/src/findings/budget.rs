//! Whether the liquid's energy and momentum are what was put into it.

use meniscus_case::Case;
use meniscus_output::Series;

use super::{Findings, exact};
use crate::sample::budget::BUDGET;
use crate::sample::wall_names;

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

/// The largest impulse along any axis, by the end, that neither body force nor walls explain, over the
/// sum of what the walls gave, %. As good as the series is fine.
fn unexplained_impulse(case: &Case, series: &Series) -> Option<f64> {
    if case.scheme.damping != 0.0 || case.walls.is_empty() {
        return None;
    }
    let time = series.column("time")?;
    let mass: f64 = case.bodies.iter().map(|body| body.mass).sum();
    let (mut worst, mut given): (f64, f64) = (0.0, 0.0);
    for (d, axis) in ["x", "y", "z"].iter().enumerate().take(case.dimension) {
        let mut on_walls = vec![0.0; time.len()];
        for wall in wall_names(case) {
            let load = series.column(&format!("{wall} force {axis}"))?;
            on_walls.iter_mut().zip(load).for_each(|(sum, x)| *sum += x);
        }
        let weight = |t: f64| (case.scheme.body_force.as_ref()).map_or(0.0, |g| mass * g.at(t)[d]);
        let momentum = series.column(&format!("momentum {axis}"))?;
        let mut missing = momentum.last()? - momentum.first()?;
        for k in 1..time.len() {
            let half = 0.5 * (time[k] - time[k - 1]);
            missing -= half * (weight(time[k]) + weight(time[k - 1]));
            missing += half * (on_walls[k] + on_walls[k - 1]);
            given += half * (on_walls[k].abs() + on_walls[k - 1].abs());
        }
        worst = worst.max(missing.abs());
    }
    (given > 0.0).then_some(100.0 * worst / given)
}

/// What was lost at the end, beside the work that was done.
pub fn measure(case: &Case, series: &Series, findings: &mut Findings) {
    if let Some(share) = unexplained_impulse(case, series) {
        let name = "impulse that nothing explains, of the walls'";
        let nothing = Some(("exact", 0.0));
        findings.add("impulse-missing", name, "%", nothing, exact(share));
    }
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
