//! Energies, temperatures, and the inside of a drop of a van der Waals fluid.

use meniscus::measure::StressProfile;
use meniscus::physics::van_der_waals::Flow;
use meniscus::{Particle, Particles, Vector};
use meniscus_case::Case;
use meniscus_output::{Frame, FrameReader, OutputError, Series};
use meniscus_report::{Axis, Curve, Figure, LinePlot};

use crate::progress::seconds;
use crate::sample::van_der_waals::{ENERGIES, TEMPERATURES};

/// What changed of each energy, and temperatures.
pub fn curves(case: &Case, series: &Series) -> Vec<Figure> {
    let Some(time) = series.column("time") else {
        return Vec::new();
    };
    let unit = if case.dimension == 2 { "J/m" } else { "J" };
    let mut energies = LinePlot::new(
        Axis::new("Time", "s"),
        Axis::new("Energy since the start", unit),
    );
    let mut drawn = 0;
    for name in ["kinetic energy"].iter().chain(&ENERGIES) {
        let Some([first, rest @ ..]) = series.column(name) else {
            continue;
        };
        let change: Vec<f64> = std::iter::once(first)
            .chain(rest)
            .map(|e| e - first)
            .collect();
        energies = energies.with(Curve::line(name, time, &change));
        drawn += usize::from(ENERGIES.contains(name));
    }
    if drawn == 0 {
        return Vec::new();
    }
    let caption = "What motion, heat and cohesion gained; their sum stays, where no drag acts \
                   and nothing is drawn out.";
    let mut temperatures = LinePlot::new(Axis::new("Time", "s"), Axis::new("Temperature", "K"));
    for name in TEMPERATURES {
        if let Some(column) = series.column(name) {
            temperatures = temperatures.with(Curve::line(name, time, column));
        }
    }
    vec![
        energies.figure("internal-energies", caption),
        temperatures.figure("temperatures", "Temperature of the particles."),
    ]
}

/// Density, temperature and stress against the distance from the centre, in the last frame.
pub fn profiles(case: &Case, reader: &FrameReader) -> Result<Vec<Figure>, OutputError> {
    let (Some(_), Some(last)) = (
        &case.measure.drop_profile,
        reader.times().len().checked_sub(1),
    ) else {
        return Ok(Vec::new());
    };
    let frame = reader.read(last)?;
    Ok(match case.dimension {
        2 => drop::<2>(case, &frame),
        _ => drop::<3>(case, &frame),
    })
}

fn drop<const D: usize>(case: &Case, frame: &Frame) -> Vec<Figure> {
    let Some(model) = case.scheme.van_der_waals else {
        return Vec::new();
    };
    let mass: f64 = case.bodies.iter().map(|body| body.mass).sum();
    let start = frame.positions.iter().map(|x| Particle {
        position: Vector::<f64, D>::from_3d(*x),
        velocity: Vector::ZERO,
        mass: mass / frame.positions.len() as f64,
        fluid: 0,
        body: 0,
    });
    let mut p = Particles::new(&start.collect::<Vec<_>>());
    let field = |name: &str| {
        let found = frame.fields.iter().find(|field| field.name == name);
        found.map(|field| field.values.clone())
    };
    let (Some(density), Some(temperature)) = (field("density"), field("temperature")) else {
        return Vec::new();
    };
    let h = case.scheme.smoothing_length;
    p.smoothing_length = field("smoothing length").unwrap_or_else(|| vec![h; p.len()]);
    p.density = density;
    p.temperature = temperature;
    let mut centre = Vector::<f64, D>::ZERO;
    for x in &p.position {
        centre += *x * (1.0 / p.len() as f64);
    }
    let radii: Vec<f64> = p.position.iter().map(|x| (*x - centre).norm()).collect();
    let outermost = radii.iter().copied().fold(0.0, f64::max);
    let at = format!(
        "Against the distance from the centre, at t = {}.",
        seconds(frame.time)
    );
    let radius = || Axis::new("Distance from the centre", "m");
    let points = |name: &str, label: &str, unit: &str, values: &[f64]| {
        LinePlot::new(radius(), Axis::new(label, unit))
            .with(Curve::points("particles", &radii, values))
            .figure(name, &at)
    };
    let flow = Flow::<D>::new(model, case.fluids[0].viscosity);
    let range = flow.range(&p, case.scheme.kernel, h);
    let width = 0.5 * case.spacing;
    let shells = ((outermost + range) / width) as usize;
    let apart = |i: usize, j: usize| (p.position[i] - p.position[j]).norm();
    let force = |i, j| flow.force_at_rest(&p, case.scheme.kernel, h, [i, j], apart(i, j));
    let stress = StressProfile::measure(&p.position, centre, range, width, shells, force);
    let middle: Vec<f64> = (0..shells).map(|k| (k as f64 + 0.5) * width).collect();
    // The innermost shells hold too few particles to average over.
    let from = 3.min(shells);
    let stresses = LinePlot::new(radius(), Axis::new("Pressure", "Pa"))
        .with(Curve::line(
            "along the radius",
            &middle[from..],
            &stress.normal[from..],
        ))
        .with(Curve::line(
            "across it",
            &middle[from..],
            &stress.tangential[from..],
        ));
    let caption =
        format!("Pressure by the forces between particles at rest (Irving and Kirkwood). {at}");
    vec![
        points("density-profile", "Density", "kg/m^3", &p.density),
        points("temperature-profile", "Temperature", "K", &p.temperature),
        stresses.figure("stress-profile", &caption),
    ]
}
