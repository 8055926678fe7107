//! What is written of a flow: the columns of the time series, and frames.

pub mod arc;
pub mod asked;
pub mod budget;
mod frame;
pub mod hydrostatics;
pub mod jet;
mod pieces;
pub mod van_der_waals;

use meniscus::measure::{
    PrincipalAxes, Sensor, StaticSurfaceTension, angular_momentum, centre_of_mass, kinetic_energy,
    linear_momentum, maximum_speed, range, semi_axes_along_coordinates, semi_axes_by_tips,
    specific_compression_energy, surface_energy,
};
use meniscus::{Particles, Simulation, SurfaceTension, Vector, theory};
use meniscus_case::Case;
use meniscus_output::Column;

pub use frame::frame;

const AXES: [&str; 3] = ["x", "y", "z"];

/// Bodies beyond this number get no columns of their own.
const MOST_BODIES: usize = 8;

/// Decides which columns the series of a case has, and fills them.
pub struct Sampler<'a, const D: usize> {
    case: &'a Case,
    sensors: Vec<Sensor<D>>,
    /// What the columns of each body and sensor are named by.
    body_names: Vec<String>,
    sensor_names: Vec<String>,
    curvature_names: Vec<String>,
    wall_names: Vec<String>,
    /// Bodies whose shape is followed: none where the flow is periodic, since
    /// a body may then lie on both sides of the box.
    bodies: usize,
}

impl<'a, const D: usize> Sampler<'a, D> {
    /// For this case, whose dimension is `D`.
    pub fn new(case: &'a Case) -> Self {
        let sensor = |at: [f64; 3]| Sensor {
            position: Vector::from_3d(at),
            kernel: case.scheme.kernel,
            smoothing_length: case.scheme.smoothing_length,
        };
        let periodic = case.periodic.iter().any(Option::is_some);
        Self {
            case,
            body_names: body_names(case),
            sensor_names: names(
                "sensor",
                case.measure.sensors.iter().map(|s| s.name.as_str()),
            ),
            curvature_names: names(
                "place",
                case.measure.curvature.iter().map(|s| s.name.as_str()),
            ),
            wall_names: wall_names(case),
            sensors: case.measure.sensors.iter().map(|s| sensor(s.at)).collect(),
            bodies: if periodic {
                0
            } else {
                case.bodies.len().min(MOST_BODIES)
            },
        }
    }

    /// Names and units of the columns.
    pub fn columns(&self) -> Vec<Column> {
        // In 2D everything is per metre of the third direction.
        let per = |unit: &str| {
            if D == 2 {
                format!("{unit}/m")
            } else {
                unit.to_owned()
            }
        };
        let mut columns = vec![
            Column::new("time", "s"),
            Column::new("step", ""),
            Column::new("kinetic energy", &per("J")),
            Column::new("compression energy", &per("J")),
            Column::new("surface energy", &per("J")),
            Column::new("shape energy", &per("J")),
        ];
        for axis in &AXES[..D] {
            columns.push(Column::new(&format!("momentum {axis}"), &per("kg m/s")));
        }
        columns.push(Column::new("angular momentum z", &per("kg m^2/s")));
        for axis in &AXES[..D] {
            columns.push(Column::new(&format!("centre of mass {axis}"), "m"));
        }
        columns.extend([
            Column::new("least density", "kg/m^3"),
            Column::new("largest density", "kg/m^3"),
            Column::new("largest speed", "m/s"),
            Column::new("surface-active particles", ""),
        ]);
        for body in 0..self.bodies {
            for kind in ["semi-axis", "tip semi-axis"] {
                for axis in &AXES[..D] {
                    columns.push(Column::new(
                        &self.of_body(body, &format!("{kind} {axis}")),
                        "m",
                    ));
                }
            }
            columns.push(Column::new(&self.of_body(body, "inner pressure"), "Pa"));
            if self.is_pairwise() {
                let name = self.of_body(body, "inner virial pressure");
                columns.push(Column::new(&name, "Pa"));
                if self.case.measure.static_pressure.is_some() {
                    let name = self.of_body(body, "inner mechanical pressure");
                    columns.push(Column::new(&name, "Pa"));
                }
            }
        }
        for name in &self.sensor_names {
            columns.push(Column::new(&format!("pressure at {name}"), "Pa"));
        }
        if self.is_pairwise() {
            for name in &self.sensor_names {
                columns.push(Column::new(&format!("virial pressure at {name}"), "Pa"));
            }
        }
        for axis in &AXES[..D] {
            columns.push(Column::new(&format!("net surface force {axis}"), &per("N")));
        }
        for name in &self.curvature_names {
            columns.push(Column::new(&format!("curvature at {name}"), "1/m"));
        }
        if self.case.measure.curvature_along.is_some() {
            columns.push(Column::new(arc::DEVIATION.0, arc::DEVIATION.1));
        }
        for name in self.wall_names.iter().take(MOST_BODIES) {
            for axis in &AXES[..D] {
                columns.push(Column::new(&format!("{name} force {axis}"), &per("N")));
            }
            for axis in turned_about(D) {
                columns.push(Column::new(&format!("{name} moment {axis}"), &per("N m")));
            }
        }
        columns.extend(budget::columns(self.case, &per("J")));
        columns.extend(van_der_waals::columns(self.case, &per("J")));
        columns.extend(asked::columns(self.case));
        columns.extend(hydrostatics::columns(self.case));
        columns.extend(pieces::columns(self.case));
        columns.extend(jet::columns(self.case));
        columns
    }

    /// Whether pairs have a virial.
    fn is_pairwise(&self) -> bool {
        let model = &self.case.scheme.surface_tension;
        matches!(model, Some(SurfaceTension::Pairwise(_)))
    }

    fn of_body(&self, body: usize, quantity: &str) -> String {
        of_body(&self.body_names, body, quantity)
    }

    /// One row of the series; NaN where a quantity does not exist.
    pub fn row(&self, simulation: &Simulation<D>) -> Vec<f64> {
        let all = simulation.particles();
        let liquid;
        let p = if self.case.walls.is_empty() {
            all
        } else {
            liquid = all.of_bodies(|body| !simulation.is_wall(body));
            &liquid
        };
        // Pairwise forces alone have one.
        let virial = &simulation.surface().virial_pressure;
        let is_liquid = |&i: &usize| !simulation.is_wall(all.body[i]);
        let rows = (0..virial.len()).filter(is_liquid);
        let virial: Vec<f64> = rows.map(|i| virial[i]).collect();
        let centre = centre_of_mass(&p.position, &p.mass).unwrap_or(Vector([f64::NAN; D]));
        let mut row = vec![
            simulation.time(),
            simulation.steps() as f64,
            kinetic_energy(&p.velocity, &p.mass),
            if simulation.van_der_waals().is_some() {
                // Part of its internal energy.
                f64::NAN
            } else {
                (0..p.len())
                    .map(|i| {
                        let fluid = &simulation.fluids()[p.fluid[i] as usize];
                        p.mass[i] * specific_compression_energy(p.density[i], fluid)
                    })
                    .sum()
            },
        ];
        row.extend(self.surface_energy(p));
        row.extend(linear_momentum(&p.velocity, &p.mass).0);
        row.push(angular_momentum(&p.position, &p.velocity, &p.mass, centre)[2]);
        row.extend(centre.0);
        let (least, largest) = range(&p.density).unwrap_or((f64::NAN, f64::NAN));
        row.extend([
            least,
            largest,
            maximum_speed(&p.velocity),
            simulation.surface().active() as f64,
        ]);
        for body in 0..self.bodies {
            let rows = BodyColumns::of(p, body);
            let missing = [f64::NAN; D];
            row.extend(semi_axes_along_coordinates(&rows.position, &rows.mass).unwrap_or(missing));
            row.extend(semi_axes_by_tips(&rows.position, self.case.spacing).unwrap_or(missing));
            let volume = self.case.bodies[body].volume;
            let inner = |field: &[f64]| {
                let inner =
                    StaticSurfaceTension::measure(&rows.position, &rows.mass, field, volume);
                inner.map_or(f64::NAN, |inner| inner.inner_pressure)
            };
            row.push(inner(&rows.pressure));
            if self.is_pairwise() {
                let of_body = (0..p.len()).filter(|&i| usize::from(p.body[i]) == body);
                let virial: Vec<f64> = of_body.filter_map(|i| virial.get(i).copied()).collect();
                row.push(inner(&virial));
                if self.case.measure.static_pressure.is_some() {
                    // Where no particle has a neighbour missing.
                    let scheme = &self.case.scheme;
                    let reach = scheme.kernel.support() * scheme.smoothing_length;
                    let radius = theory::equivalent_radius(volume, D);
                    let radius = (radius - reach).min(0.5 * radius);
                    let centre = centre_of_mass(&rows.position, &rows.mass);
                    let pressure = centre.and_then(|x| simulation.mechanical_pressure(x, radius));
                    row.push(pressure.unwrap_or(f64::NAN));
                }
            }
        }
        for sensor in &self.sensors {
            let reading = sensor.read(&p.position, &p.mass, &p.density, &p.pressure);
            row.push(reading.map_or(f64::NAN, |reading| reading.value));
        }
        let surface = simulation.surface();
        if self.is_pairwise() {
            for sensor in &self.sensors {
                let reading = sensor.read(&p.position, &p.mass, &p.density, &virial);
                row.push(reading.map_or(f64::NAN, |reading| reading.value));
            }
        }
        row.extend(surface.net_force.0);
        for place in &self.case.measure.curvature {
            let at = Vector::<f64, D>::from_3d(place.at);
            let distance = |i: &usize| (all.position[*i] - at).norm();
            let liquid = (0..all.len()).filter(|&i| !simulation.is_wall(all.body[i]));
            let nearest = liquid.min_by(|a, b| distance(a).total_cmp(&distance(b)));
            let found = nearest.and_then(|i| surface.curvature.get(i));
            row.push(found.copied().unwrap_or(f64::NAN));
        }
        if let Some(asked) = &self.case.measure.curvature_along {
            let rows = (0..all.len().min(surface.curvature.len()))
                .filter(|&i| !simulation.is_wall(all.body[i]))
                .map(|i| (all.position[i].to_3d(), surface.curvature[i]));
            let along = arc::along(asked, self.case.spacing, rows);
            row.push(arc::deviation(asked, D, &along));
        }
        for load in simulation.wall_loads().iter().take(MOST_BODIES) {
            row.extend(&load.force[..D]);
            row.extend(&load.moment[3 - turned_about(D).len()..]);
        }
        row.extend(budget::row(self.case, simulation, p));
        row.extend(van_der_waals::row(self.case, simulation));
        row.extend(asked::row(self.case, p));
        row.extend(hydrostatics::row(self.case, simulation));
        row.extend(pieces::row(self.case, p));
        row.extend(jet::row(self.case, p));
        row
    }

    /// Surface tension times the surface of each body's ellipse or ellipsoid of
    /// equal moments; and the part above that of the circle or sphere of the
    /// same volume, which only a change of shape sets free.
    fn surface_energy(&self, particles: &Particles<D>) -> [f64; 2] {
        if self.bodies < self.case.bodies.len() {
            return [f64::NAN; 2];
        }
        let mut sums = [0.0; 2];
        for body in 0..self.bodies {
            let rows = BodyColumns::of(particles, body);
            let sigma = self.case.fluids[self.case.bodies[body].fluid].surface_tension;
            let axes = PrincipalAxes::by_moments(&rows.position, &rows.mass)
                .map_or([f64::NAN; D], |axes| axes.semi_axes);
            let round = axes.iter().product::<f64>().powf(1.0 / D as f64);
            let energy = surface_energy(axes, sigma);
            sums[0] += energy;
            sums[1] += energy - surface_energy([round; D], sigma);
        }
        sums
    }
}

/// The axes that a moment may have: in 2D the one out of the plane alone.
fn turned_about(dimension: usize) -> &'static [&'static str] {
    &AXES[if dimension == 2 { 2 } else { 0 }..]
}

/// What the columns of each body are named by.
pub fn body_names(case: &Case) -> Vec<String> {
    names("body", case.bodies.iter().map(|body| body.name.as_str()))
}

/// What the columns of each wall are named by.
pub fn wall_names(case: &Case) -> Vec<String> {
    names("wall", case.walls.iter().map(|wall| wall.name.as_str()))
}

/// The name of a body's column: plain where there is only one body.
pub fn of_body(body_names: &[String], body: usize, quantity: &str) -> String {
    match body_names {
        [] | [_] => quantity.to_owned(),
        _ => format!("{} {quantity}", body_names[body]),
    }
}

/// Names that may stand in the header of a series, each once: where two are
/// the same, or differ only in what a header cannot hold, all go by number.
fn names<'a>(kind: &str, given: impl Iterator<Item = &'a str>) -> Vec<String> {
    let clean = |name: &str| -> String {
        let bad = |c: char| c == ',' || c == '"' || c.is_control();
        name.chars().map(|c| if bad(c) { ' ' } else { c }).collect()
    };
    let names: Vec<String> = given.map(clean).collect();
    if (1..names.len()).any(|i| names[..i].contains(&names[i])) {
        return (1..=names.len()).map(|k| format!("{kind} {k}")).collect();
    }
    names
}

/// Columns of the particles that started in one body.
struct BodyColumns<const D: usize> {
    position: Vec<Vector<f64, D>>,
    mass: Vec<f64>,
    pressure: Vec<f64>,
}

impl<const D: usize> BodyColumns<D> {
    fn of(particles: &Particles<D>, body: usize) -> Self {
        let mut columns = Self {
            position: Vec::new(),
            mass: Vec::new(),
            pressure: Vec::new(),
        };
        for i in 0..particles.len() {
            if particles.body[i] as usize == body {
                columns.position.push(particles.position[i]);
                columns.mass.push(particles.mass[i]);
                columns.pressure.push(particles.pressure[i]);
            }
        }
        columns
    }
}

#[cfg(test)]
mod tests {
    use super::{names, of_body};

    #[test]
    fn columns_have_names_that_a_header_can_hold_each_once() {
        let of = |given: &[&str]| names("body", given.iter().copied());
        assert_eq!(of(&["left, upper", "right"]), ["left  upper", "right"]);
        assert_eq!(
            of(&["drop", "wall", "drop"]),
            ["body 1", "body 2", "body 3"]
        );
        assert_eq!(of(&["a,b", "a\"b"]), ["body 1", "body 2"]);
        assert!(of(&[]).is_empty());
        let pair = of(&["left, upper", "right"]);
        assert_eq!(of_body(&pair, 0, "radius"), "left  upper radius");
        assert_eq!(of_body(&pair[..1], 0, "radius"), "radius");
    }
}
