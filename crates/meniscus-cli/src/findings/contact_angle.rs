//! How a drop stands on a wall.

use meniscus::Vector;
use meniscus::scheme::BodyForce;
use meniscus::theory::{SessileDrop, capillary_length};
use meniscus_case::{Case, ContactAngle};
use meniscus_output::Series;

use super::{Findings, exact, mean, window};
use crate::sample::asked::CONTACT_ANGLE;

/// Identities and names of the means of the first four columns.
const NUMBERS: [(&str, &str); 4] = [
    ("contact-angle", "contact angle by a circle or sphere"),
    ("contact-angle-tangent", "contact angle by the tangent"),
    ("wetted-radius", "radius of the wetted area"),
    ("drop-height", "height of the drop"),
];

/// Means over the time that is asked for, and how far the drop left the wall in all the run.
pub fn measure(case: &Case, series: &Series, findings: &mut Findings) {
    let Some(asked) = &case.measure.contact_angle else {
        return;
    };
    let expected = asked.expected.map(|angle| ("expected", angle.to_degrees()));
    let exact_drop = shape_at_rest(case, asked);
    for ((column, unit), (id, name)) in CONTACT_ANGLE.into_iter().zip(NUMBERS) {
        let of_drop = |size: fn(SessileDrop) -> f64| Some(("Young and Laplace", size(exact_drop?)));
        let reference = match id {
            "wetted-radius" => of_drop(|drop| drop.base_radius),
            "drop-height" => of_drop(|drop| drop.height),
            _ => expected,
        };
        match mean(series, column, &asked.window) {
            Some(found) => findings.add(id, name, unit, reference, found),
            None => findings
                .complaints
                .push(format!("no {name}: the series has none in that time")),
        }
    }
    let (gap, unit) = CONTACT_ANGLE[NUMBERS.len()];
    if let Some((_, gaps)) = window(series, gap, 0.0, case.end_time) {
        let largest = gaps.into_iter().fold(f64::NAN, f64::max);
        let name = "largest gap below the drop";
        findings.add("largest-gap", name, unit, None, exact(largest));
    }
}

/// The first body at rest under the angle to compare with; none where its weight does not push it
/// straight on the wall.
fn shape_at_rest(case: &Case, asked: &ContactAngle) -> Option<SessileDrop> {
    let (angle, body) = (asked.expected?, case.bodies.first()?);
    let fluid = &case.fluids[body.fluid];
    let normal = Vector(asked.normal);
    let length = match &case.scheme.body_force {
        None => f64::INFINITY,
        Some(BodyForce::Constant(g)) => {
            let down = -Vector(*g).dot(&normal) / normal.norm();
            // Up to rounding all of it.
            if down < Vector(*g).norm() * (1.0 - 1e-9) {
                return None;
            }
            capillary_length(fluid.surface_tension, fluid.density, down)
        }
        Some(_) => return None,
    };
    Some(SessileDrop::of_volume(
        body.volume,
        angle,
        length,
        case.dimension,
    ))
}
