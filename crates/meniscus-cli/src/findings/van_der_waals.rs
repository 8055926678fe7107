//! A drop of a van der Waals fluid: its energy, its inside, its surface tension, its swings.

use meniscus::measure::Estimate;
use meniscus::theory;
use meniscus_case::{Case, Deformation};
use meniscus_output::Series;

use super::{Findings, exact, mean, of_first_body};
use crate::sample::van_der_waals::PROFILE;

/// Identities of the columns of a profile.
const IDS: [&str; PROFILE.len()] = [
    "inside-density",
    "inside-temperature",
    "half-density-radius",
    "surface-thickness",
    "outer-rings",
    "outline-deviation",
    "inside-radius",
    "mechanical-pressure",
    "sigma-mechanical",
    "liquid-density",
    "vapour-density",
];

/// All that such a drop shows.
pub(super) fn measure(case: &Case, series: &Series, findings: &mut Findings) {
    if case.scheme.van_der_waals.is_none() {
        return;
    }
    energy(case, series, findings);
    profile(case, series, findings);
    if let Some(asked) = &case.deformation {
        swings(case, asked, series, findings);
    }
}

/// From when on nothing from outside changes the energy, s.
fn free_from(case: &Case) -> Option<f64> {
    let free = case.scheme.damping == 0.0 && case.scheme.body_force.is_none();
    let from = match &case.deformation {
        Some(asked) => asked.time * (1.0 + 1e-9),
        None => 0.0,
    };
    free.then_some(from)
}

fn energy(case: &Case, series: &Series, findings: &mut Findings) {
    let unit = if case.dimension == 2 { "J/m" } else { "J" };
    let rows = series.column("time").zip(series.column("total energy"));
    if let (Some(from), Some((time, total))) = (free_from(case), rows) {
        let mut rest = (time.iter().zip(total)).filter(|(t, _)| **t >= from);
        if let Some((_, start)) = rest.next() {
            let drift = rest.map(|(_, e)| (e - start).abs()).fold(0.0, f64::max);
            let nothing = Some(("exact", 0.0));
            let name = "largest drift of kinetic and internal energy";
            findings.add("energy-drift", name, unit, nothing, exact(drift));
            findings.add("energy", "their sum", unit, None, exact(*start));
        }
    }
    let last = |name: &str| series.column(name).and_then(<[f64]>::last).copied();
    if let Some(temperature) = last("mean temperature") {
        let name = "mean temperature at the end";
        findings.add("temperature-end", name, "K", None, exact(temperature));
    }
}

fn profile(case: &Case, series: &Series, findings: &mut Findings) {
    let (Some(asked), Some(model)) = (&case.measure.drop_profile, &case.scheme.van_der_waals)
    else {
        return;
    };
    let mut means = [exact(f64::NAN); PROFILE.len()];
    for (slot, (column, _)) in means.iter_mut().zip(PROFILE) {
        *slot = mean(series, column, asked).unwrap_or(*slot);
    }
    let phases = mean(series, "mean temperature", asked).and_then(|temperature| {
        let critical = model.substance.critical_point();
        let phases = theory::coexistence(temperature.value / critical.temperature)?;
        Some([phases.liquid, phases.vapour].map(|density| density * critical.density))
    });
    let [density, _, _, _, _, _, radius, pressure, ..] = means;
    let drop = density.value.is_finite();
    let long = model.cohesion_range * case.scheme.smoothing_length;
    let kernel = case.scheme.kernel;
    let cohesion = model.substance.cohesion;
    let step = theory::step_surface_tension(cohesion, density.value, kernel, long, case.dimension);
    let asked = case.fluids[0].surface_tension;
    let tension = if asked > 0.0 {
        ("given", asked)
    } else {
        ("sharp surface", step)
    };
    for ((found, (name, unit)), id) in means.into_iter().zip(PROFILE).zip(IDS) {
        let [liquid, vapour] = phases.unwrap_or([f64::NAN; 2]);
        let reference = match id {
            "sigma-mechanical" => Some(tension),
            "inside-density" | "liquid-density" => Some(("Maxwell", liquid)),
            "vapour-density" => Some(("Maxwell", vapour)),
            _ => None,
        };
        let of_box = matches!(id, "liquid-density" | "vapour-density");
        if of_box != drop {
            findings.add(id, name, unit, reference, found);
        }
    }
    if !drop {
        return;
    }
    let by_laplace =
        theory::surface_tension_from_pressure(pressure.value, radius.value, case.dimension);
    let laplace = Estimate {
        value: by_laplace,
        half_width: (by_laplace / pressure.value * pressure.half_width).abs(),
    };
    let name = "surface tension by Laplace, of the mechanical pressure inside";
    findings.add("sigma-laplace", name, "N/m", Some(tension), laplace);
    let name = "surface tension of a sharp surface of the density inside";
    findings.add("sigma-step", name, "N/m", None, exact(step));
}

/// Times and aspects of a drop that was drawn out, and how fast it calms down.
fn swings(case: &Case, asked: &Deformation, series: &Series, findings: &mut Findings) {
    let column = |name: &str| series.column(&of_first_body(case, name));
    let (Some(time), Some(x), Some(y)) = (
        series.column("time"),
        column("semi-axis x"),
        column("semi-axis y"),
    ) else {
        return;
    };
    let begin = time.partition_point(|&t| t < asked.time * (1.0 - 1e-9));
    let since: Vec<f64> = time[begin..].iter().map(|t| t - asked.time).collect();
    let swing: Vec<f64> = (x[begin..].iter().zip(&y[begin..]))
        .map(|(x, y)| (y / x).ln())
        .collect();
    let mut add = |id: &str, name: &str, unit: &str, value: f64| {
        findings.add(id, name, unit, None, exact(value));
    };
    let zeros: Vec<usize> = (1..swing.len())
        .filter(|&k| swing[k - 1] * swing[k] <= 0.0 && swing[k - 1] != 0.0)
        .collect();
    // The farthest between two zeros is a turning point; the last has one only if it is passed.
    let turns: Vec<usize> = (zeros.windows(2))
        .filter_map(|ends| {
            (ends[0]..ends[1]).max_by(|&a, &b| swing[a].abs().total_cmp(&swing[b].abs()))
        })
        .collect();
    let crossing = |k: usize| {
        let share = swing[k - 1] / (swing[k - 1] - swing[k]);
        since[k - 1] + share * (since[k] - since[k - 1])
    };
    if let Some(&first) = zeros.first() {
        add(
            "circle-time",
            "time of the first circle",
            "s",
            crossing(first),
        );
    }
    let names = [
        ("extreme", "first extreme along x"),
        ("period-1", "end of the first period"),
        ("extreme-2", "second extreme along x"),
        ("period-2", "end of the second period"),
    ];
    for (&k, (id, name)) in turns.iter().zip(names) {
        add(
            &format!("{id}-time"),
            &format!("time of the {name}"),
            "s",
            since[k],
        );
        let aspect = swing[k].abs().exp();
        add(
            &format!("{id}-aspect"),
            &format!("aspect at the {name}"),
            "",
            aspect,
        );
    }
    let period = match turns[..] {
        [.., before, _, last] => Some(since[last] - since[before]),
        [before, last] => Some(2.0 * (since[last] - since[before])),
        _ => None,
    };
    if let (Some(period), Some(state)) = (period, at_rest(case, series)) {
        let name = "period of the last whole swing";
        let theory = Some(("Rayleigh, mechanical surface tension", state.period));
        findings.add("swing-period", name, "s", theory, exact(period));
        let omega = std::f64::consts::TAU / period;
        let sigma = theory::surface_tension_from_frequency(
            2,
            omega,
            state.density,
            state.radius,
            case.dimension,
        );
        let name = "surface tension by that period";
        findings.add("sigma-swing", name, "N/m", None, exact(sigma));
    }
    // Over one whole swing, the first: small ones calm down faster, as particles set.
    let rate = match turns[..] {
        [first, _, last, ..] | [first, last] => {
            (swing[first] / swing[last]).abs().ln() / (since[last] - since[first])
        }
        _ => relaxation(&since, &swing),
    };
    if rate.is_finite() {
        damping(case, rate, at_rest(case, series), findings);
    }
}

/// A drop before it is drawn out.
struct AtRest {
    density: f64,
    radius: f64,
    /// By the forces across its surface, N/m.
    sigma: f64,
    /// Of its mode of two lobes, by Rayleigh and its mechanical surface tension, s.
    period: f64,
}

fn at_rest(case: &Case, series: &Series) -> Option<AtRest> {
    let asked = case.measure.drop_profile.as_ref()?;
    let of = |name: &str| Some(mean(series, name, asked)?.value);
    let (density, radius) = (
        of("density inside")?,
        of("radius by mass and density inside")?,
    );
    let sigma = of("mechanical surface tension")?;
    let omega = theory::angular_frequency(2, sigma, density, radius, case.dimension);
    Some(AtRest {
        density,
        radius,
        sigma,
        period: std::f64::consts::TAU / omega,
    })
}

/// The rate at which a swing without return falls from a half to an eighth of its start, 1/s.
fn relaxation(since: &[f64], swing: &[f64]) -> f64 {
    let start = swing.first().copied().unwrap_or(f64::NAN);
    let reaches = |share: f64| swing.iter().position(|s| *s < share * start);
    match (reaches(0.5), reaches(0.125)) {
        (Some(a), Some(b)) => (swing[a] / swing[b]).ln() / (since[b] - since[a]),
        _ => f64::NAN,
    }
}

/// The rate beside Lamb's of the viscosity, and the viscosity that would have it.
fn damping(case: &Case, rate: f64, state: Option<AtRest>, findings: &mut Findings) {
    let viscosity = case.fluids[0].viscosity;
    let body = &case.bodies[0];
    let radius = theory::equivalent_radius(body.volume, case.dimension);
    let per = theory::lamb_damping_rate(2, 1.0, radius, case.dimension);
    let density = case.fluids[0].density;
    let lamb = Some(("Lamb", per * viscosity / density));
    let name = "damping rate of the swing";
    findings.add("swing-damping", name, "/s", lamb, exact(rate));
    let name = "viscosity that has this rate by Lamb";
    let given = Some(("given", viscosity));
    findings.add(
        "effective-viscosity",
        name,
        "Pa s",
        given,
        exact(rate / per * density),
    );
    if let Some(state) = state {
        let momentum = (state.density * state.sigma * state.radius).sqrt();
        let name = "Reynolds number sqrt(rho sigma R) / mu of that viscosity";
        let nominal = Some(("given", momentum / viscosity));
        let effective = momentum * per / rate / density;
        findings.add("effective-reynolds", name, "", nominal, exact(effective));
    }
}
