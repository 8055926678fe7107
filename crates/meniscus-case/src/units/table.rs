//! The units, their prefixes, and finding one by its name.

use std::f64::consts::PI;

use super::kind::*;

/// A unit that may stand in a quantity: its value is `factor` times ten to the
/// power `exponent`, in SI.
pub(super) struct Unit {
    pub name: &'static str,
    pub dimension: Dimension,
    pub exponent: i32,
    pub factor: f64,
    prefixed: bool,
}

const fn unit(
    name: &'static str,
    dimension: Dimension,
    exponent: i32,
    factor: f64,
    prefixed: bool,
) -> Unit {
    Unit {
        name,
        dimension,
        exponent,
        factor,
        prefixed,
    }
}

const UNITS: &[Unit] = &[
    unit("m", LENGTH.dimension, 0, 1.0, true),
    unit("g", MASS.dimension, -3, 1.0, true),
    unit("s", TIME.dimension, 0, 1.0, true),
    unit("rad", ANGLE.dimension, 0, 1.0, true),
    unit("N", FORCE.dimension, 0, 1.0, true),
    unit("Pa", PRESSURE.dimension, 0, 1.0, true),
    unit("J", ENERGY.dimension, 0, 1.0, true),
    unit("W", dimension([2, 1, -3]), 0, 1.0, true),
    unit("K", TEMPERATURE.dimension, 0, 1.0, true),
    unit("mol", dimension([0, 0, 0, 0, 0, 1]), 0, 1.0, true),
    unit("Hz", RATE.dimension, 0, 1.0, true),
    unit("P", VISCOSITY.dimension, -1, 1.0, true),
    unit("St", KINEMATIC_VISCOSITY.dimension, -4, 1.0, true),
    unit("bar", PRESSURE.dimension, 5, 1.0, true),
    unit("dyn", FORCE.dimension, -5, 1.0, true),
    unit("L", VOLUME.dimension, -3, 1.0, true),
    unit("l", VOLUME.dimension, -3, 1.0, true),
    unit("min", TIME.dimension, 0, 60.0, false),
    unit("h", TIME.dimension, 0, 3600.0, false),
    unit("deg", ANGLE.dimension, 0, PI / 180.0, false),
    unit("°", ANGLE.dimension, 0, PI / 180.0, false),
    unit("rpm", ANGULAR_VELOCITY.dimension, 0, PI / 30.0, false),
];

const PREFIXES: &[(&str, i32)] = &[
    ("n", -9),
    ("u", -6),
    ("µ", -6),
    ("μ", -6),
    ("m", -3),
    ("c", -2),
    ("d", -1),
    ("h", 2),
    ("k", 3),
    ("M", 6),
    ("G", 9),
];

/// The unit of this name, and the power of ten of its prefix.
pub(super) fn look_up(name: &str) -> Option<(&'static Unit, i32)> {
    if let Some(unit) = UNITS.iter().find(|unit| unit.name == name) {
        return Some((unit, 0));
    }
    PREFIXES.iter().find_map(|(prefix, exponent)| {
        let rest = name.strip_prefix(prefix)?;
        UNITS
            .iter()
            .find(|unit| unit.prefixed && unit.name == rest)
            .map(|unit| (unit, *exponent))
    })
}

/// The unit most like a name that is none.
pub(super) fn nearest_unit(name: &str) -> Option<String> {
    let all = UNITS.iter().flat_map(|unit| {
        let prefixes = if unit.prefixed { PREFIXES } else { &[] };
        std::iter::once(unit.name.to_string()).chain(
            prefixes
                .iter()
                .map(move |(prefix, _)| format!("{prefix}{}", unit.name)),
        )
    });
    // A wrong capital is the likeliest slip, a wrong letter the next.
    all.filter(|unit| strsim::osa_distance(&unit.to_lowercase(), &name.to_lowercase()) <= 1)
        .min_by_key(|unit| {
            (
                strsim::osa_distance(&unit.to_lowercase(), &name.to_lowercase()),
                strsim::osa_distance(unit, name),
            )
        })
}
