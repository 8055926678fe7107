//! A first body that swings a little.

use std::f64::consts::TAU;

use meniscus::measure::{DampedCosine, OscillationSurfaceTension};
use meniscus_case::Case;
use meniscus_output::Series;

use super::{Findings, of_first_body, window};
use crate::expected;

/// Surface tension, period and damping, by damped cosines fitted to its semi-axes.
pub(super) fn measure(case: &Case, series: &Series, findings: &mut Findings) {
    let (Some(asked), Some(body)) = (&case.measure.oscillation, case.bodies.first()) else {
        return;
    };
    let fluid = &case.fluids[body.fluid];
    let given = Some(("given", fluid.surface_tension)).filter(|(_, sigma)| *sigma > 0.0);
    let theory = expected::oscillation(case);
    let by_moments = [
        ("semi-axis x", "", "axis x (moments)"),
        ("semi-axis y", "-y", "axis y (moments)"),
    ];
    let by_tips = [
        ("tip semi-axis x", "-tip-x", "axis x (tips)"),
        ("tip semi-axis y", "-tip-y", "axis y (tips)"),
    ];
    // Second moments show mode 2 alone.
    let columns: Vec<_> = match asked.mode {
        2 => by_moments.into_iter().chain(by_tips).collect(),
        _ => by_tips.to_vec(),
    };
    let main = columns[0].1;
    for (column, suffix, label) in columns {
        let column = of_first_body(case, column);
        let Some((time, values)) = window(series, &column, asked.from, asked.to) else {
            findings.complaints.push(format!(
                "no oscillation was fitted: the series has no column \"{column}\" (a periodic box)"
            ));
            return;
        };
        let fit = match DampedCosine::fit(&time, &values) {
            Ok(fit) => fit,
            Err(error) => {
                findings
                    .complaints
                    .push(format!("no oscillation was fitted to {label}: {error}"));
                // What the moments do not show, the tips do not show either.
                if suffix == main {
                    return;
                }
                continue;
            }
        };
        // In another fluid the period tells, beside theory; no formula leads back to sigma.
        let immersed = theory.as_ref().is_some_and(|theory| theory.immersed);
        let (density, dimension) = (fluid.density, case.dimension);
        let sigma =
            OscillationSurfaceTension::measure(&fit, asked.mode, density, body.volume, dimension);
        if !immersed {
            let id = format!("sigma-oscillation{suffix}");
            let name = format!("surface tension by {label}");
            findings.add(&id, &name, "N/m", given, sigma.plain);
        }
        if suffix == main {
            let viscous = theory.as_ref().and_then(|t| t.viscous);
            let period = match (immersed, viscous) {
                (true, Some(v)) => Some(("two viscous fluids", TAU / v.angular_frequency)),
                (true, None) => theory.as_ref().map(|t| ("Lamb, inviscid", t.period)),
                (false, _) => theory.as_ref().map(|t| ("Rayleigh, inviscid", t.period)),
            };
            if !immersed {
                let id = "sigma-oscillation-corrected";
                let name = "the same, corrected for damping";
                findings.add(id, name, "N/m", given, sigma.damping_corrected);
            }
            findings.add("period", "period", "s", period, fit.period());
            let rate = viscous.map(|v| ("linear viscous theory", v.damping_rate));
            findings.add("damping-rate", "damping rate", "/s", rate, fit.damping_rate);
            findings.fit = Some(fit);
        }
    }
}
