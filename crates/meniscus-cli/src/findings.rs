//! What a finished run shows: numbers beside what they should be.

mod at_rest;
pub mod budget;
mod contact_angle;
mod crown;
mod extremes;
mod hydrostatics;
mod jet;
mod merging;
mod oscillation;
mod roundness;
mod spreading;
mod tank;
mod van_der_waals;

use meniscus::measure::{DampedCosine, Estimate};
use meniscus_case::{Case, Window};
use meniscus_output::Series;
use serde::{Deserialize, Serialize};

use crate::sample::arc::DEVIATION;
use crate::sample::{body_names, of_body};

/// A number that was measured.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Finding {
    /// A name that does not change, for programs.
    pub id: String,
    /// What it is.
    pub quantity: String,
    /// Its unit; empty for a plain number.
    pub unit: String,
    /// Where the value to compare with comes from, and that value.
    pub reference: Option<(String, f64)>,
    /// The measured value.
    pub computed: f64,
    /// Half width of its 95 % interval, where one is known.
    pub uncertainty: Option<f64>,
}

/// All that the case asks for, and what went wrong on the way, as sentences.
#[derive(Default)]
pub struct Findings {
    /// Numbers.
    pub numbers: Vec<Finding>,
    /// The fit of the first semi-axis.
    pub fit: Option<DampedCosine>,
    /// What could not be measured, and why.
    pub complaints: Vec<String>,
}

/// Measures the series of a run.
pub fn measure(case: &Case, series: &Series) -> Findings {
    let mut findings = Findings::default();
    oscillation::measure(case, series, &mut findings);
    extremes::measure(case, series, &mut findings);
    merging::waist(case, series, &mut findings);
    merging::breakup(case, series, &mut findings);
    merging::mixing(case, series, &mut findings);
    merging::drops(case, series, &mut findings);
    spreading::measure(case, series, &mut findings);
    jet::measure(case, series, &mut findings);
    curvature(case, series, &mut findings);
    at_rest::measure(case, series, &mut findings);
    roundness::measure(case, series, &mut findings);
    hydrostatics::measure(case, series, &mut findings);
    crown::measure(case, series, &mut findings);
    contact_angle::measure(case, series, &mut findings);
    tank::measure(case, series, &mut findings);
    budget::measure(case, series, &mut findings);
    van_der_waals::measure(case, series, &mut findings);
    common(case, series, &mut findings);
    findings
}

impl Findings {
    /// Adds a number; one that came out as none is a complaint.
    fn add(
        &mut self,
        id: &str,
        quantity: &str,
        unit: &str,
        reference: Option<(&str, f64)>,
        found: Estimate,
    ) {
        if !found.value.is_finite() {
            self.complaints
                .push(format!("{quantity}: no value came out"));
            return;
        }
        self.numbers.push(Finding {
            id: id.into(),
            quantity: quantity.into(),
            unit: unit.into(),
            reference: reference
                .filter(|(_, value)| value.is_finite())
                .map(|(source, value)| (source.to_owned(), value)),
            computed: found.value,
            uncertainty: Some(found.half_width).filter(|width| width.is_finite()),
        });
    }
}

/// A number without an interval.
fn exact(value: f64) -> Estimate {
    Estimate {
        value,
        half_width: f64::NAN,
    }
}

/// The samples of a column from one time to another.
fn window(series: &Series, name: &str, from: f64, to: f64) -> Option<(Vec<f64>, Vec<f64>)> {
    let time = series.column("time")?;
    let values = series.column(name)?;
    // Samples fall up to a step after the time they are due.
    let inside = |t: f64| t >= from && t <= to * (1.0 + 1e-3);
    Some(
        time.iter()
            .zip(values)
            .filter(|(t, _)| inside(**t))
            .map(|(t, v)| (*t, *v))
            .unzip(),
    )
}

/// The mean of a column over a time; none where the series has nothing there.
pub fn mean(series: &Series, name: &str, over: &Window) -> Option<Estimate> {
    let (_, mut values) = window(series, name, over.from, over.to)?;
    // What could not be measured at a time says nothing of the others.
    values.retain(|value| value.is_finite());
    if values.is_empty() {
        return None;
    }
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let variance = values.iter().map(|y| (y - mean).powi(2)).sum::<f64>() / values.len() as f64;
    // Samples of a flow at rest are not independent: the spread itself, not that of a mean.
    Some(Estimate {
        value: mean,
        half_width: 1.96 * variance.sqrt(),
    })
}

/// The name of a column of the first body.
fn of_first_body(case: &Case, quantity: &str) -> String {
    of_body(&body_names(case), 0, quantity)
}

/// Curvature at the places asked for, at the start.
fn curvature(case: &Case, series: &Series, findings: &mut Findings) {
    for place in &case.measure.curvature {
        let column = series.column(&format!("curvature at {}", place.name));
        if let Some(&first) = column.and_then(<[f64]>::first) {
            let id = format!("curvature-{}", place.name);
            let name = format!("curvature at {}, at the start", place.name);
            findings.add(&id, &name, "1/m", None, exact(first));
        }
    }
    let deviation = series.column(DEVIATION.0).and_then(<[f64]>::first);
    if let (Some(&deviation), Some(_)) = (deviation, &case.measure.curvature_along) {
        let name = "rms of curvature times R, less 1, along the arc at the start";
        findings.add(
            "arc-deviation",
            name,
            "",
            Some(("exact", 0.0)),
            exact(deviation),
        );
    }
}

/// A weakly compressible flow changes its density by about 1 %.
const LARGEST_CHANGE_OF_DENSITY: f64 = 0.05;
/// Drift of the mean velocity, over the speed scale of the flow.
const LARGEST_DRIFT: f64 = 0.01;

/// What every run tells.
fn common(case: &Case, series: &Series, findings: &mut Findings) {
    let finite = |name: &str| {
        let values = series.column(name)?.iter().copied();
        Some(values.filter(|value| value.is_finite()))
    };
    let least = finite("least density").and_then(|values| values.reduce(f64::min));
    let largest = finite("largest density").and_then(|values| values.reduce(f64::max));
    let stiff = case.scheme.van_der_waals.is_none();
    if let (true, Some(least), Some(largest), [fluid]) = (stiff, least, largest, &case.fluids[..]) {
        let change = (largest / fluid.density - 1.0).max(1.0 - least / fluid.density);
        let name = "largest change of density";
        findings.add("density-change", name, "%", None, exact(100.0 * change));
        if change > LARGEST_CHANGE_OF_DENSITY {
            findings.complaints.push(format!(
                "density changed by {:.0} %, which no weakly compressible flow should: do not trust this run; \
                 raise sound_speed, refine the spacing, or look where particles were thrown about",
                100.0 * change
            ));
        }
    }
    let mass: f64 = case.bodies.iter().map(|body| body.mass).sum();
    let drift = ["momentum x", "momentum y", "momentum z"]
        .iter()
        .filter_map(|name| series.column(name))
        .filter_map(|column| Some((column.last()? - column.first()?).abs() / mass))
        .reduce(f64::max);
    if let (Some(drift), None, true) = (drift, &case.scheme.body_force, case.walls.is_empty()) {
        let nothing = Some(("exact", 0.0));
        let name = "drift of the mean velocity";
        findings.add("momentum-drift", name, "m/s", nothing, exact(drift));
        let scale = case.speeds.largest();
        if scale > 0.0 && drift > LARGEST_DRIFT * scale {
            findings.complaints.push(format!(
                "the whole drifts at {:.0} % of the speed scale of the flow, which nothing outside it causes: \
                 this model of surface tension does not conserve momentum where particles are disordered",
                100.0 * drift / scale
            ));
        }
    }
}
