//! Swings too large for a fit.

use meniscus_case::Case;
use meniscus_output::Series;

use super::{Findings, exact, of_first_body, window};

/// The largest reach of the first body along x, and when it is back at its least.
pub(super) fn measure(case: &Case, series: &Series, findings: &mut Findings) {
    if !case.measure.extremes {
        return;
    }
    let Some((time, reach)) = window(
        series,
        &of_first_body(case, "tip semi-axis x"),
        0.0,
        case.end_time,
    ) else {
        findings
            .complaints
            .push("no extremes: in a periodic box the reach of a body is not followed".into());
        return;
    };
    // Of particle centres, as papers print it.
    let reach: Vec<f64> = reach.iter().map(|x| x - 0.5 * case.spacing).collect();
    let first_from = |start: usize, sign: f64| {
        (start.max(1)..reach.len().saturating_sub(1)).find(|&k| {
            // Half a per cent off either way is no swing.
            let beyond = &reach[k..];
            let turned =
                (beyond.iter()).find(|&&x| (sign * (x - reach[k])).abs() > 0.005 * reach[0]);
            sign * (reach[k] - reach[k - 1]) >= 0.0
                && turned.is_some_and(|x| sign * (x - reach[k]) < 0.0)
                && reach[k..]
                    .iter()
                    .take_while(|x| sign * (*x - reach[k]) > -0.005 * reach[0])
                    .all(|x| sign * (x - reach[k]) <= 0.0)
        })
    };
    let Some(top) = first_from(1, 1.0) else {
        findings
            .complaints
            .push("no extremes: the first body does not swing".into());
        return;
    };
    findings.add(
        "largest-extent",
        "largest extent along x",
        "m",
        None,
        exact(reach[top]),
    );
    findings.add(
        "largest-extent-time",
        "time of the largest extent",
        "s",
        None,
        exact(time[top]),
    );
    let at_end = |axis: &str| {
        let name = of_first_body(case, &format!("semi-axis {axis}"));
        series
            .column(&name)
            .and_then(|column| column.last().copied())
    };
    let axes: Vec<f64> = ["x", "y", "z"].into_iter().filter_map(at_end).collect();
    let longest = axes.iter().copied().fold(f64::NAN, f64::max);
    let aspect = longest / axes.iter().copied().fold(f64::NAN, f64::min);
    let name = "longest over shortest semi-axis, at the end";
    findings.add("aspect-end", name, "", None, exact(aspect));
    match first_from(top + 1, -1.0) {
        Some(back) => findings.add(
            "swing-period",
            "time of the least extent after it",
            "s",
            None,
            exact(time[back]),
        ),
        None => findings
            .complaints
            .push("the first body does not swing back before the end".into()),
    }
}
