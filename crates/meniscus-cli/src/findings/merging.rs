//! Drops that merge, break or mix.

use meniscus_case::Case;
use meniscus_output::Series;
use meniscus_report::number::with_unit;

use super::{Findings, exact, window};

/// When the waist first has the radius that was asked for, by straight lines between the rows,
/// and its radius at the time that was asked for.
pub(super) fn waist(case: &Case, series: &Series, findings: &mut Findings) {
    let found = window(series, "waist", 0.0, case.end_time);
    let (Some(asked), Some((time, radius))) = (&case.measure.waist, found) else {
        return;
    };
    if let Some(then) = asked.time {
        let row = time.iter().position(|t| *t >= then);
        let found = row.and_then(|row| radius.get(row)).copied();
        let name = format!("radius of the waist at {}", with_unit(then, "s", 4));
        let found = exact(found.unwrap_or(f64::NAN));
        findings.add("waist-radius", &name, "m", None, found);
    }
    if let Some(wanted) = asked.reaches {
        let crossed = (1..radius.len())
            .find(|&k| (radius[k - 1] < wanted) != (radius[k] < wanted))
            .map(|k| {
                let share = (wanted - radius[k - 1]) / (radius[k] - radius[k - 1]);
                time[k - 1] + share * (time[k] - time[k - 1])
            });
        let wanted = with_unit(wanted, "m", 4);
        let name = format!("time at which the waist has a radius of {wanted}");
        let found = exact(crossed.unwrap_or(f64::NAN));
        findings.add("waist-time", &name, "s", None, found);
    }
}

/// What shape a body has when it breaks: at the end of the run, or as the first tenth of it has
/// come off. A bag is thin in the middle, a drop that is sheared at its rim is thick there.
pub(super) fn breakup(case: &Case, series: &Series, findings: &mut Findings) {
    let column = |name: &str| window(series, name, 0.0, case.end_time);
    let (Some((time, share)), true) = (column("largest piece"), case.measure.breakup.is_some())
    else {
        return;
    };
    let broken = share.iter().position(|share| *share < 0.9);
    let row = broken.unwrap_or(share.len().saturating_sub(1));
    let at = |name: &str| {
        let values = column(name).map(|(_, values)| values);
        values
            .and_then(|values| values.get(row).copied())
            .unwrap_or(f64::NAN)
    };
    let mut add = |id, name, unit, value| findings.add(id, name, unit, None, exact(value));
    let when = time.get(row).copied().unwrap_or(f64::NAN);
    match broken {
        Some(_) => add(
            "breakup-time",
            "time at which a tenth has come off",
            "s",
            when,
        ),
        None => add(
            "breakup-time",
            "not broken: what follows is of the end",
            "s",
            when,
        ),
    }
    add("pieces", "pieces", "", at("pieces"));
    add("span", "radius across its way", "m", at("span"));
    let name = "rim ahead of the centre, over that radius (below 0: opens backward)";
    add("opening", name, "", at("opening"));
    let film = at("centre thickness") / at("span");
    let ratio = at("centre thickness") / at("rim thickness");
    add("film", "thickness in the middle over that radius", "", film);
    let name = "thickness in the middle over that of the rim";
    add("thickness-ratio", name, "", ratio);
    let name = "mode: 1 bag open forward, -1 bag open backward, 2 sheared rim, 0 neither";
    add("mode", name, "", mode(at("opening"), film, ratio));
}

/// How a drop breaks, by numbers of its shape. A bag is bent by more than a tenth of its radius and
/// a film in the middle, thinner than a quarter of it; a rim that is sheared off is bent as much,
/// before a middle that is no film and thicker than the rim.
fn mode(opening: f64, film: f64, ratio: f64) -> f64 {
    if opening.abs() < 0.1 {
        0.0
    } else if film < 0.25 {
        opening.signum()
    } else if ratio > 1.0 {
        2.0
    } else {
        0.0
    }
}

/// By how much the first body has mixed with others.
pub(super) fn mixing(case: &Case, series: &Series, findings: &mut Findings) {
    let (Some((_, contacts)), true) = (
        window(series, "contacts", 0.0, case.end_time),
        case.measure.mixing,
    ) else {
        return;
    };
    // A tenth of the run at either end: particles near each other come and go.
    let part = (contacts.len() / 10).max(1);
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let (first, last) = (
        &contacts[..part.min(contacts.len())],
        &contacts[contacts.len().saturating_sub(part)..],
    );
    let name = "contacts across the surface, last over first tenth of the run";
    findings.add(
        "mixing",
        name,
        "",
        Some(("no mixing", 1.0)),
        exact(mean(last) / mean(first)),
    );
}

/// How many drops there are at the end.
pub(super) fn drops(case: &Case, series: &Series, findings: &mut Findings) {
    let last = |name: &str| series.column(name).and_then(<[f64]>::last).copied();
    if let (true, Some(count), Some(held)) =
        (case.measure.drops, last("drops"), last("liquid in drops"))
    {
        findings.add("drops", "drops at the end", "", None, exact(count));
        let name = "share of the liquid in them";
        findings.add("liquid-in-drops", name, "%", None, exact(100.0 * held));
    }
}
