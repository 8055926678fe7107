//! Columns that a case asks for under `[measure]`, each followed through the run.

use meniscus::measure::{
    Base, Crown, DropOnWall, Outline, Plane, Sensor, TankSurface, centre_of_mass,
};
use meniscus::{Particles, Vector, theory};
use meniscus_case::{Case, ContactAngle};
use meniscus_output::Column;

/// Columns of `roundness`, of the first body.
pub const ROUNDNESS: [(&str, &str); 6] = [
    ("circularity", "m"),
    ("outline radius", "m"),
    ("enclosing radius", "m"),
    ("equivalent radius", "m"),
    ("centre pressure", "Pa"),
    ("centre density", "kg/m^3"),
];

/// Columns of `crown`.
pub const CROWN: [(&str, &str); 3] = [
    ("crown base radius", "m"),
    ("crown rim radius", "m"),
    ("crown rim height", "m"),
];

/// Columns of `contact_angle`, of the first body.
pub const CONTACT_ANGLE: [(&str, &str); 6] = [
    ("contact angle", "deg"),
    ("contact angle by tangent", "deg"),
    ("wetted radius", "m"),
    ("wetted radius by circle", "m"),
    ("drop height", "m"),
    ("gap below the drop", "m"),
];

/// Columns of `meniscus`; what has two sides, left before right.
pub const MENISCUS: [(&str, &str); 7] = [
    ("liquid level", "m"),
    ("rise at the left wall", "m"),
    ("rise at the right wall", "m"),
    ("contact angle at the left wall", "deg"),
    ("contact angle at the right wall", "deg"),
    ("capillary length at the left wall", "m"),
    ("capillary length at the right wall", "m"),
];

/// Column of `static_pressure` where it asks for the pressure outside.
pub const OUTSIDE: (&str, &str) = ("outside pressure", "Pa");

/// Names and units of the columns.
pub fn columns(case: &Case) -> Vec<Column> {
    let mut columns = Vec::new();
    let mut add = |asked: bool, names: &[(&str, &str)]| {
        if asked {
            columns.extend(names.iter().map(|(name, unit)| Column::new(name, unit)));
        }
    };
    add(case.measure.roundness.is_some(), &ROUNDNESS);
    add(case.measure.crown.is_some(), &CROWN);
    add(case.measure.contact_angle.is_some(), &CONTACT_ANGLE);
    add(case.measure.meniscus.is_some(), &MENISCUS);
    let outside = (case.measure.static_pressure.as_ref()).and_then(|asked| asked.outside);
    add(outside.is_some(), &[OUTSIDE]);
    columns
}

/// Their values for the liquid, NaN where one does not exist.
pub fn row<const D: usize>(case: &Case, liquid: &Particles<D>) -> Vec<f64> {
    let mut row = Vec::new();
    if case.measure.roundness.is_some() {
        row.extend(roundness(case, &liquid.of_bodies(|body| body == 0)));
    }
    if let Some(asked) = &case.measure.crown {
        let impact = Vector::from_3d(asked.impact);
        let layer = asked
            .layer
            .map(|layer| liquid.of_bodies(|body| usize::from(body) == layer));
        let layer = &layer.as_ref().unwrap_or(liquid).position;
        let reach = case.scheme.smoothing_length;
        let found = Crown::measure(layer, &liquid.position, impact, reach);
        row.extend(found.map_or([f64::NAN; CROWN.len()], |crown| {
            [crown.base_radius, crown.rim_radius, crown.rim_height]
        }));
    }
    if let Some(asked) = &case.measure.contact_angle {
        row.extend(on_wall(asked, &liquid.of_bodies(|body| body == 0)));
    }
    if let Some(asked) = &case.measure.meniscus {
        let (walls, length) = (asked.walls, asked.capillary_length);
        let found = TankSurface::measure(&liquid.position, spacing(liquid), walls, length);
        row.extend(found.map_or([f64::NAN; MENISCUS.len()], |found| {
            let [left, right] = found.menisci;
            [
                found.level.value,
                left.rise.value,
                right.rise.value,
                left.contact_angle.value.to_degrees(),
                right.contact_angle.value.to_degrees(),
                left.capillary_length.value,
                right.capillary_length.value,
            ]
        }));
    }
    let outside = (case.measure.static_pressure.as_ref()).and_then(|asked| asked.outside);
    if let Some(at) = outside {
        let sensor = Sensor {
            position: Vector::from_3d(at),
            kernel: case.scheme.kernel,
            smoothing_length: case.scheme.smoothing_length,
        };
        let (x, mass) = (&liquid.position, &liquid.mass);
        let reading = sensor.read(x, mass, &liquid.density, &liquid.pressure);
        row.push(reading.map_or(f64::NAN, |reading| reading.value));
    }
    row
}

/// The body as a drop on a wall.
fn on_wall<const D: usize>(
    asked: &ContactAngle,
    body: &Particles<D>,
) -> [f64; CONTACT_ANGLE.len()] {
    let Some(wall) = base(&asked.base) else {
        return [f64::NAN; CONTACT_ANGLE.len()];
    };
    let spacing = spacing(body);
    let drop = DropOnWall::measure(&body.position, &body.mass, spacing, &wall);
    let of_drop = |of: fn(DropOnWall) -> f64| drop.map_or(f64::NAN, of);
    let heights = body.position.iter().map(|&x| wall.height(x));
    [
        of_drop(|drop| drop.circle.value.to_degrees()),
        of_drop(|drop| drop.tangent.value.to_degrees()),
        of_drop(|drop| drop.wetted_radius.value),
        of_drop(|drop| drop.circle_radius),
        of_drop(|drop| drop.height),
        heights.fold(f64::INFINITY, f64::min) - 0.5 * spacing,
    ]
}

fn base<const D: usize>(asked: &meniscus_case::Base) -> Option<Base<D>> {
    match *asked {
        meniscus_case::Base::Plane { point, normal } => {
            Plane::new(Vector::from_3d(point), Vector::from_3d(normal)).map(Base::Plane)
        }
        meniscus_case::Base::Ball {
            centre,
            radius,
            side,
        } => Some(Base::Ball {
            centre: Vector::from_3d(centre),
            radius,
            side,
        }),
    }
}

/// As it is, which compression changes.
fn spacing<const D: usize>(body: &Particles<D>) -> f64 {
    (volume(body) / body.len() as f64).powf(1.0 / D as f64)
}

fn volume<const D: usize>(body: &Particles<D>) -> f64 {
    (0..body.len()).map(|i| body.volume(i)).sum()
}

fn roundness<const D: usize>(case: &Case, body: &Particles<D>) -> [f64; ROUNDNESS.len()] {
    let outline = Outline::measure(&body.position, &body.mass, case.spacing);
    let centre = centre_of_mass(&body.position, &body.mass).map(|position| Sensor {
        position,
        kernel: case.scheme.kernel,
        smoothing_length: case.scheme.smoothing_length,
    });
    let at_centre = |field: &[f64]| {
        let reading =
            centre.and_then(|sensor| sensor.read(&body.position, &body.mass, &body.density, field));
        reading.map_or(f64::NAN, |reading| reading.value)
    };
    let of_outline = |of: fn(Outline) -> f64| outline.map_or(f64::NAN, of);
    [
        of_outline(|outline| outline.deviation),
        of_outline(|outline| outline.mean_radius),
        of_outline(|outline| outline.enclosing_radius),
        theory::equivalent_radius(volume(body), D),
        at_centre(&body.pressure),
        at_centre(&body.density),
    ]
}
