//! How a drop stands on a wall.

use meniscus::Vector;
use meniscus::physics::wall::layout::Side;
use meniscus::scheme::BodyForce;
use meniscus::theory::{CapOnBall, SessileDrop, capillary_length};
use meniscus_case::{Base, Case, ContactAngle};
use meniscus_output::Series;

use super::{Findings, exact, mean, window};
use crate::sample::asked::CONTACT_ANGLE;

/// Identities and names of the means of the first columns.
const NUMBERS: [(&str, &str); 5] = [
    ("contact-angle", "contact angle by a circle or sphere"),
    ("contact-angle-tangent", "contact angle by the tangent"),
    ("wetted-radius", "radius of the wetted area"),
    ("wetted-radius-circle", "the same, of that circle or sphere"),
    ("drop-height", "height of the drop"),
];

/// Means over the time that is asked for, and how far the drop left the wall in all the run.
pub fn measure(case: &Case, series: &Series, findings: &mut Findings) {
    let Some(asked) = &case.measure.contact_angle else {
        return;
    };
    let expected = asked.expected.map(|angle| ("expected", angle.to_degrees()));
    let exact_drop = shape_at_rest(case, asked);
    let weighs = case.scheme.body_force.is_some() && exact_drop.is_some();
    for ((column, unit), (id, name)) in CONTACT_ANGLE.into_iter().zip(NUMBERS) {
        let theory = |of: fn(&AtRest) -> f64| {
            (exact_drop.as_ref()).map(|drop| ("Young and Laplace", of(drop)))
        };
        let reference = match id {
            // The weight that flattens a drop, its circle shows as well.
            "contact-angle" if weighs => theory(|drop| drop.circle_angle.to_degrees()),
            "wetted-radius" => theory(|drop| drop.base_radius),
            "wetted-radius-circle" => theory(|drop| drop.circle_base_radius),
            "drop-height" => theory(|drop| drop.height),
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

/// What a drop at rest would show: angle in rad, lengths in m.
struct AtRest {
    base_radius: f64,
    height: f64,
    circle_angle: f64,
    circle_base_radius: f64,
}

/// The first body at rest under the angle to compare with. None where its weight does not push it straight on a flat wall.
fn shape_at_rest(case: &Case, asked: &ContactAngle) -> Option<AtRest> {
    let (angle, body) = (asked.expected?, case.bodies.first()?);
    let fluid = &case.fluids[body.fluid];
    let length = match (&case.scheme.body_force, &asked.base) {
        (None, Base::Ball { radius, side, .. }) => {
            let radius = match side {
                Side::Inside => *radius,
                Side::Outside => -radius,
            };
            let lens = CapOnBall::of_volume(body.volume, angle, radius, case.dimension);
            return Some(AtRest {
                base_radius: lens.base_radius,
                height: lens.height,
                circle_angle: angle,
                circle_base_radius: lens.base_radius,
            });
        }
        (None, Base::Plane { .. }) => f64::INFINITY,
        (Some(BodyForce::Constant(g)), Base::Plane { normal, .. }) => {
            let normal = Vector(*normal);
            let down = -Vector(*g).dot(&normal) / normal.norm();
            // Up to rounding all of it.
            if down < Vector(*g).norm() * (1.0 - 1e-9) {
                return None;
            }
            capillary_length(fluid.surface_tension, fluid.density, down)
        }
        _ => return None,
    };
    let drop = SessileDrop::of_volume(body.volume, angle, length, case.dimension);
    Some(AtRest {
        base_radius: drop.base_radius,
        height: drop.height,
        circle_angle: drop.circle_angle,
        circle_base_radius: drop.circle_base_radius,
    })
}
