//! Drops that become one.

use meniscus_case::Case;
use meniscus_output::Series;
use meniscus_report::number::with_unit;

use super::{Findings, exact, window};

/// When the waist first has the radius that was asked for, by straight lines between the rows.
pub(super) fn waist(case: &Case, series: &Series, findings: &mut Findings) {
    let wanted = case.measure.waist.as_ref().and_then(|waist| waist.reaches);
    let found = window(series, "waist", 0.0, case.end_time);
    let (Some(wanted), Some((time, radius))) = (wanted, found) else {
        return;
    };
    let crossed = (1..radius.len())
        .find(|&k| (radius[k - 1] < wanted) != (radius[k] < wanted))
        .map(|k| {
            let share = (wanted - radius[k - 1]) / (radius[k] - radius[k - 1]);
            time[k - 1] + share * (time[k] - time[k - 1])
        });
    let name = format!(
        "time at which the waist has a radius of {}",
        with_unit(wanted, "m", 4)
    );
    findings.add(
        "waist-time",
        &name,
        "s",
        None,
        exact(crossed.unwrap_or(f64::NAN)),
    );
}
