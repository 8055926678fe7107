//! What a finished run shows: numbers beside what they should be.

use meniscus::measure::{DampedCosine, Estimate, OscillationSurfaceTension};
use meniscus::theory;
use meniscus_case::Case;
use meniscus_output::Series;
use serde::{Deserialize, Serialize};

use crate::numbers::effective_viscosity;

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
    oscillation(case, series, &mut findings);
    static_pressure(case, series, &mut findings);
    common(case, series, &mut findings);
    findings
}

fn add(
    findings: &mut Findings,
    id: &str,
    quantity: &str,
    unit: &str,
    theory: Option<(&str, f64)>,
    found: Estimate,
) {
    findings.numbers.push(Finding {
        id: id.into(),
        quantity: quantity.into(),
        unit: unit.into(),
        reference: theory.map(|(source, value)| (source.to_owned(), value)),
        computed: found.value,
        uncertainty: Some(found.half_width).filter(|width| width.is_finite()),
    });
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

fn oscillation(case: &Case, series: &Series, findings: &mut Findings) {
    let Some(asked) = &case.measure.oscillation else {
        return;
    };
    let Some(body) = case.bodies.first() else {
        return;
    };
    let fluid = &case.fluids[body.fluid];
    let radius = theory::equivalent_radius(body.volume, case.dimension);
    let omega = theory::angular_frequency(
        asked.mode,
        fluid.surface_tension,
        fluid.density,
        radius,
        case.dimension,
    );
    let given = Some(("given", fluid.surface_tension));
    let columns = [
        ("semi-axis x", "", "semi-axis x by second moments"),
        ("semi-axis y", "-y", "semi-axis y by second moments"),
        ("tip semi-axis x", "-tip-x", "semi-axis x by tips"),
        ("tip semi-axis y", "-tip-y", "semi-axis y by tips"),
    ];
    for (column, suffix, label) in columns {
        let Some((time, values)) = window(series, column, asked.from, asked.to) else {
            findings.complaints.push(format!(
                "no oscillation was fitted: the series has no column \"{column}\" (several bodies, or a periodic box)"
            ));
            return;
        };
        let fit = match DampedCosine::fit(&time, &values) {
            Ok(fit) => fit,
            Err(error) => {
                findings.complaints.push(format!(
                    "no oscillation could be fitted to {label}: {error}"
                ));
                continue;
            }
        };
        let sigma = OscillationSurfaceTension::measure(
            &fit,
            asked.mode,
            fluid.density,
            body.volume,
            case.dimension,
        );
        let name = format!("surface tension from the frequency of {label}");
        add(
            findings,
            &format!("sigma-oscillation{suffix}"),
            &name,
            "N/m",
            given,
            sigma.plain,
        );
        if suffix.is_empty() {
            let name = "the same, corrected for damping";
            add(
                findings,
                "sigma-oscillation-corrected",
                name,
                "N/m",
                given,
                sigma.damping_corrected,
            );
            let period = Some(("Rayleigh, inviscid", std::f64::consts::TAU / omega));
            add(findings, "period", "period", "s", period, fit.period());
            let viscosity = effective_viscosity(case, body.fluid);
            let rate = theory::lamb_damping_rate(asked.mode, viscosity, radius, case.dimension);
            let lamb = Some(("Lamb, with nu of the artificial viscosity", rate));
            add(
                findings,
                "damping-rate",
                "damping rate",
                "1/s",
                lamb,
                fit.damping_rate,
            );
            findings.fit = Some(fit);
        }
    }
}

fn static_pressure(case: &Case, series: &Series, findings: &mut Findings) {
    let Some(asked) = &case.measure.static_pressure else {
        return;
    };
    let Some(body) = case.bodies.first() else {
        return;
    };
    let Some((_, values)) =
        window(series, "inner pressure", asked.from, asked.to).filter(|w| !w.0.is_empty())
    else {
        findings
            .complaints
            .push("no static pressure was measured: the series has none in that time".into());
        return;
    };
    let fluid = &case.fluids[body.fluid];
    let radius = theory::equivalent_radius(body.volume, case.dimension);
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let variance = values.iter().map(|p| (p - mean).powi(2)).sum::<f64>() / values.len() as f64;
    // Samples of a flow at rest are not independent: the spread itself, not that of a mean.
    let pressure = Estimate {
        value: mean,
        half_width: 1.96 * variance.sqrt(),
    };
    let jump = theory::pressure_jump(fluid.surface_tension, radius, case.dimension);
    add(
        findings,
        "inner-pressure",
        "pressure inside (r < R/2)",
        "Pa",
        Some(("Laplace", jump)),
        pressure,
    );
    let factor = theory::surface_tension_from_pressure(1.0, radius, case.dimension);
    let sigma = Estimate {
        value: mean * factor,
        half_width: pressure.half_width * factor,
    };
    let given = Some(("given", fluid.surface_tension));
    add(
        findings,
        "sigma-static",
        "surface tension from the pressure inside",
        "N/m",
        given,
        sigma,
    );
}

fn common(case: &Case, series: &Series, findings: &mut Findings) {
    let extreme = |name: &str, pick: fn(f64, f64) -> f64| {
        let values = series.column(name)?;
        values
            .iter()
            .copied()
            .filter(|v| v.is_finite())
            .reduce(pick)
    };
    let exact = |value: f64| Estimate {
        value,
        half_width: f64::NAN,
    };
    let one_fluid = case.fluids.len() == 1;
    if let (Some(least), Some(largest), true) = (
        extreme("least density", f64::min),
        extreme("largest density", f64::max),
        one_fluid,
    ) {
        let rho = case.fluids[0].density;
        let change = (largest / rho - 1.0).max(1.0 - least / rho);
        let expected = Some((
            "expected, (U/c)^2",
            crate::numbers::expected_density_error(case),
        ));
        add(
            findings,
            "density-change",
            "largest change of density",
            "",
            expected,
            exact(change),
        );
    }
    let momentum = ["momentum x", "momentum y", "momentum z"]
        .iter()
        .filter_map(|name| series.column(name))
        .map(|column| (column[column.len().saturating_sub(1)] - column[0]).abs())
        .fold(0.0, f64::max);
    let mass: f64 = case.bodies.iter().map(|body| body.mass).sum();
    if case.scheme.body_force.is_none() && mass > 0.0 {
        let velocity = momentum / mass;
        add(
            findings,
            "momentum-drift",
            "drift of the mean velocity",
            "m/s",
            Some(("exact", 0.0)),
            exact(velocity),
        );
    }
}
