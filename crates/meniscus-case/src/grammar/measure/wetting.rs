//! How what is measured of liquid at walls is read: a drop on one, the surface between two.

use super::read::window;
use super::{Base, ContactAngle, TankSurface};
use crate::grammar::document::interval;
use crate::grammar::shape::{centre, radius};
use crate::grammar::wall_shape::liquid_side;
use crate::read::{Choice, Fields, Node, Sign};
use crate::units;

pub(super) fn contact_angle(node: &mut Node<'_>, end_time: f64) -> ContactAngle {
    let round = node.holds("wall");
    node.either(
        round,
        |node| {
            node.table(|fields| {
                let about = "The round wall.";
                let base = fields.required("wall", about, |node| node.choice("round wall", ROUND));
                on_base(fields, base, end_time)
            })
        },
        |node| {
            node.table(|fields| {
                let base = plane(fields);
                on_base(fields, base, end_time)
            })
        },
    )
}

/// What is asked of a drop on this wall.
fn on_base(fields: &mut Fields<'_, '_>, base: Base, end_time: f64) -> ContactAngle {
    ContactAngle {
        base,
        expected: expected(fields),
        window: window(fields, end_time, 0.8),
    }
}

/// Named as the shapes of walls are.
const ROUND: &[Choice<Base>] = &[
    Choice::new("disc", "A disc, or all around it.", ball::<2>).only_in(2),
    Choice::new("sphere", "A ball, or all around it.", ball::<3>).only_in(3),
];

fn ball<const D: usize>(node: &mut Node<'_>) -> Base {
    node.table(|fields| {
        let radius = radius(fields);
        let centre = centre::<D>(fields, "The centre.").to_3d();
        Base::Ball {
            centre,
            radius,
            side: liquid_side(fields),
        }
    })
}

fn plane(fields: &mut Fields<'_, '_>) -> Base {
    let point = fields.required("point", "A point of the wall's surface.", |node| {
        node.vector(&units::LENGTH, Sign::Any)
    });
    let about = "Direction from the wall to the liquid, of any length.";
    let normal = fields.required("normal", about, |node| {
        let normal = node.vector(&units::NUMBER, Sign::Any);
        if normal == [0.0; 3] {
            node.fail(
                "`normal` has no direction".into(),
                "all components are zero",
                "for a floor write [0, 1], in 3D [0, 0, 1]",
            );
        }
        normal
    });
    Base::Plane { point, normal }
}

/// A contact angle to compare with.
fn expected(fields: &mut Fields<'_, '_>) -> Option<f64> {
    let about = "The angle to compare with, through the liquid.";
    fields.optional("expected", about, |node| {
        let angle = node.quantity(&units::ANGLE, Sign::NotNegative);
        if angle > std::f64::consts::PI {
            node.fail(
                format!("`expected` is {:.1} degrees", angle.to_degrees()),
                "more than 180 degrees",
                "0 degrees is a liquid that spreads, 180 one that rolls off",
            );
        }
        angle
    })
}

pub(super) fn meniscus(fields: &mut Fields<'_, '_>, end_time: f64) -> TankSurface {
    let about = "Where the left and the right wall are along x.";
    let walls = fields.required("walls", about, interval);
    let about = "sqrt(sigma / (rho g)). Default: what the shape shows.";
    let capillary_length = fields.optional("capillary_length", about, |node| {
        node.quantity(&units::LENGTH, Sign::Positive)
    });
    TankSurface {
        walls: [walls.0, walls.1],
        expected: expected(fields),
        capillary_length,
        window: window(fields, end_time, 0.8),
    }
}
