//! Semi-axes, energies, work and loads on walls over time, with theory beside them.

use meniscus::scheme::BodyForce;
use meniscus_case::Case;
use meniscus_output::Series;
use meniscus_report::{Axis, Curve, Figure, LinePlot};

use crate::expected;
use crate::findings::{Findings, budget::lost};
use crate::sample::budget::BUDGET;

/// Points that show a fitted curve.
const FITTED_POINTS: usize = 60;

/// Semi-axes of the only body.
pub fn axes(case: &Case, series: &Series, measured: &Findings) -> Option<Figure> {
    let time = series.column("time")?;
    let names = &["x", "y", "z"][..case.dimension];
    let mut plot = LinePlot::new(Axis::new("Time", "s"), Axis::new("Semi-axis", "m"));
    for name in names {
        let axis = series.column(&format!("semi-axis {name}"))?;
        plot = plot.with(Curve::line(name, time, axis));
    }
    let body = match case.dimension {
        2 => "ellipse",
        _ => "ellipsoid",
    };
    let mut caption = format!("Semi-axes of the {body} with the second moments of the particles.");
    let start = *series.column("semi-axis x")?.first()?;
    let (asked, fit) = (case.measure.oscillation.as_ref(), measured.fit.as_ref());
    let theory = expected::oscillation(case).filter(|_| asked.is_some_and(|a| a.mode == 2));
    if let Some((theory, viscous)) = theory.and_then(|t| t.viscous.map(|v| (t, v))) {
        let swing = |t: &f64| {
            let decay = (-viscous.damping_rate * t).exp();
            theory.radius + (start - theory.radius) * decay * (viscous.angular_frequency * t).cos()
        };
        let curve: Vec<f64> = time.iter().map(swing).collect();
        plot = plot.with(Curve::dashed("x, linear viscous theory", time, &curve));
        caption.push_str(
            " Theory: with the surface tension put in, and the viscosity that the \
             artificial viscosity stands for.",
        );
    }
    if let (Some(asked), Some(fit)) = (asked, fit) {
        let fitted = |t: &&f64| **t >= asked.from && **t <= asked.to;
        let window: Vec<f64> = time.iter().filter(fitted).copied().collect();
        let every = 1 + window.len() / FITTED_POINTS;
        let thinned: Vec<f64> = window.into_iter().step_by(every).collect();
        let heights: Vec<f64> = thinned.iter().map(|&t| fit.at(t)).collect();
        plot = plot.with(Curve::points("x, damped cosine fitted", &thinned, &heights));
    }
    Some(plot.figure("semi-axes", &caption))
}

/// Where the energy is.
pub fn energies(case: &Case, series: &Series) -> Option<Figure> {
    let time = series.column("time")?;
    let kinetic = series.column("kinetic energy")?;
    let compression = series.column("compression energy")?;
    let shape = series.column("shape energy")?;
    let unit = if case.dimension == 2 { "J/m" } else { "J" };
    let mut plot = LinePlot::new(Axis::new("Time", "s"), Axis::new("Energy", unit))
        .with(Curve::line("kinetic", time, kinetic))
        .with(Curve::line("compression", time, compression));
    let mut caption = "Energies.".to_owned();
    if shape.iter().all(|energy| energy.is_finite()) {
        let sum: Vec<f64> = kinetic.iter().zip(shape).map(|(a, b)| a + b).collect();
        plot = plot
            .with(Curve::line("shape", time, shape))
            .with(Curve::line("kinetic + shape", time, &sum));
        caption = "Energies. That of the shape is surface tension times the surface that the \
                   ellipse or ellipsoid of the same second moments has beyond the circle or \
                   sphere of its size."
            .into();
        let theory = expected::oscillation(case).and_then(|theory| theory.viscous);
        if let (Some(theory), Some(start)) = (theory, sum.first()) {
            let decay = |t: &f64| start * (-2.0 * theory.damping_rate * t).exp();
            let curve: Vec<f64> = time.iter().map(decay).collect();
            plot = plot.with(Curve::dashed("linear viscous theory", time, &curve));
        }
    }
    Some(plot.figure("energies", &caption))
}

/// What weight and walls put into the liquid, and what it kept.
pub fn budget(case: &Case, series: &Series) -> Option<Figure> {
    let time = series.column("time")?;
    let lost = lost(series)?;
    let unit = if case.dimension == 2 { "J/m" } else { "J" };
    let mut plot = LinePlot::new(Axis::new("Time", "s"), Axis::new("Energy", unit));
    for name in BUDGET[1..]
        .iter()
        .chain(&["kinetic energy", "compression energy"])
    {
        plot = plot.with(Curve::line(name, time, series.column(name)?));
    }
    let caption = "Work done on the liquid and its energies. What is missing of the work is heat, \
                   and energy of the surface.";
    Some(
        plot.with(Curve::dashed("missing", time, &lost))
            .figure("energy-budget", caption),
    )
}

/// Forces on the walls.
pub fn loads(case: &Case, series: &Series) -> Option<Figure> {
    let time = series.column("time")?;
    let unit = if case.dimension == 2 { "N/m" } else { "N" };
    let mut plot = LinePlot::new(Axis::new("Time", "s"), Axis::new("Force on walls", unit));
    let mut drawn = 0;
    for wall in &case.walls {
        for axis in &["x", "y", "z"][..case.dimension] {
            let name = format!("{} force {axis}", wall.name);
            if let Some(force) = series.column(&name) {
                plot = plot.with(Curve::line(&format!("{} {axis}", wall.name), time, force));
                drawn += 1;
            }
        }
    }
    let mass: f64 = case.bodies.iter().map(|body| body.mass).sum();
    let mut caption = "Forces that the liquid exerts on walls.".to_owned();
    if let Some(BodyForce::Constant(g)) = &case.scheme.body_force
        && let [first, .., last] = time
    {
        for (axis, g) in ["x", "y", "z"].iter().zip(g).filter(|(_, g)| **g != 0.0) {
            let name = format!("weight {axis}");
            plot = plot.with(Curve::dashed(&name, &[*first, *last], &[mass * g; 2]));
        }
        caption = "Forces that the liquid exerts on walls, and its weight.".into();
    }
    (drawn > 0).then(|| plot.figure("loads", &caption))
}
