//! Energies and temperatures of a van der Waals fluid, and what a drop of it is like inside.

use meniscus::measure::{
    Outline, StressProfile, SurfaceLayer, centre_of_mass, kinetic_energy, outer_rings, range,
};
use meniscus::physics::van_der_waals::Flow;
use meniscus::{Particles, Simulation};
use meniscus_case::Case;
use meniscus_output::{Column, Field};

/// Columns of energies, J.
pub const ENERGIES: [&str; 3] = ["thermal energy", "cohesion energy", "total energy"];

/// Columns of temperatures, K.
pub const TEMPERATURES: [&str; 3] = [
    "mean temperature",
    "least temperature",
    "largest temperature",
];

/// Columns of `drop_profile`, filled while it is wanted.
pub const PROFILE: [(&str, &str); 11] = [
    ("density inside", "kg/m^3"),
    ("temperature inside", "K"),
    ("radius of half the density", "m"),
    ("thickness of the surface", "m"),
    ("outer rings", ""),
    ("deviation of the outline", "%"),
    ("radius by mass and density inside", "m"),
    ("mechanical pressure inside", "Pa"),
    ("mechanical surface tension", "N/m"),
    ("liquid density", "kg/m^3"),
    ("vapour density", "kg/m^3"),
];

/// Part of the outermost radius that counts as inside.
const INSIDE: f64 = 0.5;

/// Names and units of the columns.
pub fn columns(case: &Case, energy: &str) -> Vec<Column> {
    if case.scheme.van_der_waals.is_none() {
        return Vec::new();
    }
    let energies = ENERGIES.iter().map(|name| Column::new(name, energy));
    let temperatures = TEMPERATURES.iter().map(|name| Column::new(name, "K"));
    let mut columns: Vec<Column> = energies.chain(temperatures).collect();
    if case.measure.drop_profile.is_some() {
        columns.extend(PROFILE.iter().map(|(name, unit)| Column::new(name, unit)));
    }
    columns
}

/// Their values.
pub fn row<const D: usize>(case: &Case, simulation: &Simulation<D>) -> Vec<f64> {
    let Some(flow) = simulation.van_der_waals() else {
        return Vec::new();
    };
    let p = simulation.particles();
    let sum = |of: &dyn Fn(usize) -> f64| (0..p.len()).map(|i| p.mass[i] * of(i)).sum::<f64>();
    let cohesion = sum(&|i| flow.cohesion_energy(i));
    let internal = sum(&|i| flow.internal_energy(p, i));
    let total = kinetic_energy(&p.velocity, &p.mass) + internal;
    let mass: f64 = p.mass.iter().sum();
    let mean = sum(&|i| p.temperature[i]) / mass;
    let (least, largest) = range(&p.temperature).unwrap_or((f64::NAN, f64::NAN));
    let mut row = vec![internal - cohesion, cohesion, total, mean, least, largest];
    if let Some(asked) = &case.measure.drop_profile {
        let now = simulation.time();
        let wanted = now >= asked.from && now <= asked.to * (1.0 + 1e-3);
        let open = case.periodic.iter().all(Option::is_none);
        let mut values = [f64::NAN; PROFILE.len()];
        let (alone, phases) = values.split_at_mut(PROFILE.len() - 2);
        if let (true, true, Some(found)) = (wanted, open, profile(case, p, flow)) {
            alone.copy_from_slice(&found);
        }
        if let (true, false, Some(found)) = (wanted, open, phases_of(case, p)) {
            phases.copy_from_slice(&found);
        }
        row.extend(values);
    }
    row
}

/// What a drop is like from its centre to its surface.
fn profile<const D: usize>(
    case: &Case,
    p: &Particles<D>,
    flow: &Flow<D>,
) -> Option<[f64; PROFILE.len() - 2]> {
    let scheme = &case.scheme;
    let centre = centre_of_mass(&p.position, &p.mass)?;
    let outline = Outline::measure(&p.position, &p.mass, case.spacing)?;
    let depth = INSIDE * outline.mean_radius;
    let inside: Vec<usize> = (0..p.len())
        .filter(|&i| (p.position[i] - centre).norm() < depth)
        .collect();
    let mean = |of: &[f64]| inside.iter().map(|&i| of[i]).sum::<f64>() / inside.len() as f64;
    let (density, temperature) = (mean(&p.density), mean(&p.temperature));
    let (kernel, h) = (scheme.kernel, scheme.smoothing_length);
    let layer = {
        let own = |i: usize| p.smoothing_length[i];
        SurfaceLayer::measure(&p.position, &p.mass, own, kernel, centre, density)?
    };
    let mass: f64 = p.mass.iter().sum();
    let radius = meniscus::theory::equivalent_radius(mass / density, D);
    let range = flow.range(p, kernel, h);
    let width = 0.5 * case.spacing;
    let shells = ((outline.mean_radius + range) / width) as usize;
    let apart = |i: usize, j: usize| (p.position[i] - p.position[j]).norm();
    let force = |i, j| flow.force_at_rest(p, kernel, h, [i, j], apart(i, j));
    let stress = StressProfile::measure(&p.position, centre, range, width, shells, force);
    Some([
        density,
        temperature,
        layer.radius,
        layer.thickness,
        outer_rings(&p.position, centre, case.spacing) as f64,
        100.0 * outline.deviation / outline.mean_radius,
        radius,
        stress.inner_pressure::<D>(depth),
        stress.surface_tension(depth),
    ])
}

/// Densities of a drop and of the vapour that fills the rest of a periodic box, kg/m^3, by the
/// mass in rings about the drop: in its inner half, and from four spacings outside to the box.
/// What summation gives a lone particle, its own kernel, does not count.
fn phases_of<const D: usize>(case: &Case, p: &Particles<D>) -> Option<[f64; 2]> {
    let mut squares = vec![0.0; p.len()];
    let mut reach = f64::INFINITY;
    for (d, axis) in case.periodic.iter().enumerate().take(D) {
        let length = axis.map(|(low, high)| high - low)?;
        reach = reach.min(0.5 * length);
        // The mean direction on the circle that the axis is, by what is dense.
        let turn = std::f64::consts::TAU / length;
        let (mut sine, mut cosine) = (0.0, 0.0);
        for i in 0..p.len() {
            let weight = p.density[i].powi(2);
            sine += weight * (turn * p.position[i][d]).sin();
            cosine += weight * (turn * p.position[i][d]).cos();
        }
        let centre = sine.atan2(cosine) / turn;
        for (square, x) in squares.iter_mut().zip(&p.position) {
            let offset = x[d] - centre;
            *square += (offset - length * (offset / length).round()).powi(2);
        }
    }
    let radii: Vec<f64> = squares.iter().map(|square| square.sqrt()).collect();
    let between = |from: f64, to: f64| {
        let inside = radii
            .iter()
            .zip(&p.mass)
            .filter(|(r, _)| **r >= from && **r < to);
        let mass: f64 = inside.map(|(_, m)| m).sum();
        let unit = if D == 2 { 1.0 } else { 4.0 / 3.0 } * std::f64::consts::PI;
        mass / (unit * (to.powi(D as i32) - from.powi(D as i32)))
    };
    let width = 2.0 * case.spacing;
    let rings = (reach / width) as usize;
    let of_ring = |k: usize| between(k as f64 * width, (k + 1) as f64 * width);
    let half = 0.5 * (between(0.0, 2.0 * width) + of_ring(rings.checked_sub(1)?));
    let edge = (0..rings).find(|&k| of_ring(k) < half)? as f64 * width;
    let clear = edge + 4.0 * case.spacing;
    (clear + width < reach).then(|| [between(0.0, 0.5 * edge), between(clear, reach)])
}

/// Fields of a frame, whose rows come in this order.
pub fn fields<const D: usize>(simulation: &Simulation<D>, order: &[usize]) -> Vec<Field> {
    let Some(flow) = simulation.van_der_waals() else {
        return Vec::new();
    };
    let p = simulation.particles();
    let scalar = |name: &str, unit: &str, value: &dyn Fn(usize) -> f64| {
        Field::scalar(name, unit, order.iter().map(|&i| value(i)).collect())
    };
    vec![
        scalar("temperature", "K", &|i| p.temperature[i]),
        scalar("internal energy", "J/kg", &|i| flow.internal_energy(p, i)),
    ]
}
