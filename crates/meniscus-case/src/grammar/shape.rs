//! The regions that bodies fill.

use meniscus::Vector;
use meniscus::shape::{Revolved, Rotation, Shape};

use crate::read::{Choice, Fields, Node, Sign};
use crate::units;

pub(super) fn shape<const D: usize>(node: &mut Node<'_>) -> Shape<D> {
    node.choice(
        "shape",
        &[
            Choice::new(
                "block",
                "A rectangle, in 3D a cuboid, with sides along the axes.",
                block,
            ),
            Choice::new("disc", "A disc.", ball).only_in(2),
            Choice::new("sphere", "A ball.", ball).only_in(3),
            Choice::new("ellipse", "An ellipse.", ellipsoid).only_in(2),
            Choice::new("ellipsoid", "An ellipsoid.", ellipsoid).only_in(3),
            Choice::new("polygon", "A polygon.", polygon).only_in(2),
            Choice::new(
                "cylinder",
                "A cylinder with flat ends; in 2D a rectangle at any angle.",
                cylinder,
            ),
            Choice::new("revolved", "A polygon turned about an axis.", |node| {
                node.table(|fields| Shape::Revolved(profile(fields)))
            })
            .only_in(3),
            Choice::new(
                "half_space",
                "All on one side of a line, in 3D of a plane: to cut others with.",
                half_space,
            ),
            Choice::new("union", "What is in any of a list of shapes.", |node| {
                Shape::Union(node.list(1, shape))
            }),
            Choice::new(
                "intersection",
                "What is in all of a list of shapes.",
                |node| Shape::Intersection(node.list(1, shape)),
            ),
            Choice::new(
                "difference",
                "What is in the first of a list of shapes and in none of the others.",
                difference,
            ),
        ],
    )
}

fn block<const D: usize>(node: &mut Node<'_>) -> Shape<D> {
    let span = node.span();
    let context = node.context;
    node.table(|fields| {
        let low = point(fields, "low", "The corner with the lowest coordinates.");
        let high = point(fields, "high", "The corner with the highest coordinates.");
        if (0..D).any(|d| low[d] >= high[d]) {
            context.error(
                span,
                "`low` is not below `high`".into(),
                "this block has no inside".into(),
                Some("each coordinate of `low` must be below that of `high`".into()),
            );
        }
        Shape::Block { low, high }
    })
}

fn ball<const D: usize>(node: &mut Node<'_>) -> Shape<D> {
    node.table(|fields| {
        let radius = radius(fields);
        let centre = centre(fields, "The centre.");
        Shape::Ball { centre, radius }
    })
}

fn ellipsoid<const D: usize>(node: &mut Node<'_>) -> Shape<D> {
    node.table(|fields| {
        let semi_axes = fields.required(
            "semi_axes",
            "Half the length along x, y (and z), before it is turned.",
            |node| Vector::from_3d(node.vector(&units::LENGTH, Sign::Positive)),
        );
        let centre = centre(fields, "The centre.");
        let rotation = rotation(fields, "How it is turned about its centre.");
        Shape::Ellipsoid {
            centre,
            semi_axes,
            rotation,
        }
    })
}

fn polygon<const D: usize>(node: &mut Node<'_>) -> Shape<D> {
    node.table(|fields| Shape::Polygon(corners(fields)))
}

pub(super) fn corners(fields: &mut Fields<'_, '_>) -> Vec<Vector<f64, 2>> {
    let about = "The corners in order; the last is joined to the first.";
    fields.required("corners", about, |node| {
        node.list(3, |node| {
            Vector::from_3d(node.vector(&units::LENGTH, Sign::Any))
        })
    })
}

/// A polygon beside an axis.
pub(super) fn profile(fields: &mut Fields<'_, '_>) -> Revolved {
    let about = "The corners in order, the last joined to the first: each by how far it is along the \
                 axis, and its distance from the axis.";
    let corners = fields.required("corners", about, |node| node.list(3, beside_the_axis));
    let about = "The direction of the axis, of any length.";
    let axis = fields.required("axis", about, |node| {
        let axis = node.vector(&units::NUMBER, Sign::Any);
        if axis == [0.0; 3] {
            node.fail(
                "this axis has no direction".into(),
                "all components are zero",
                "for example axis = [1, 0, 0]",
            );
        }
        Vector(axis)
    });
    let about = "The point of the axis that its corners are counted from.";
    let point = fields.or("point", "['0 m', '0 m', '0 m']", about, |node| {
        Vector(node.vector(&units::LENGTH, Sign::Any))
    });
    Revolved {
        corners,
        point,
        axis,
    }
}

/// A point by how far it is along an axis and its distance from it.
fn beside_the_axis(node: &mut Node<'_>) -> Vector<f64, 2> {
    let found = node.list(2, |node| node.quantity(&units::LENGTH, Sign::Any));
    node.schema["maxItems"] = 2.into();
    let [along, away] = found[..] else {
        if found.len() > 2 {
            node.fail(
                format!("this corner has {} coordinates", found.len()),
                "two are needed",
                "first how far it is along the axis, then its distance from it",
            );
        }
        return Vector([f64::NAN; 2]);
    };
    if away < 0.0 {
        node.fail(
            "this corner is beyond the axis".into(),
            "a distance below zero",
            "give one half of the outline; the other is its mirror image",
        );
    }
    Vector([along, away])
}

fn cylinder<const D: usize>(node: &mut Node<'_>) -> Shape<D> {
    node.table(|fields| {
        let start = point(fields, "start", "The middle of one end.");
        let end = point(fields, "end", "The middle of the other end.");
        let radius = radius(fields);
        Shape::Cylinder { start, end, radius }
    })
}

fn half_space<const D: usize>(node: &mut Node<'_>) -> Shape<D> {
    node.table(|fields| {
        let point = point(fields, "point", "A point of the surface.");
        let normal = fields.required("normal", "The outward normal, of any length.", |node| {
            let normal = node.vector(&units::NUMBER, Sign::Any);
            node.refuse_zero(&normal);
            Vector::from_3d(normal)
        });
        Shape::HalfSpace { point, normal }
    })
}

fn difference<const D: usize>(node: &mut Node<'_>) -> Shape<D> {
    let mut shapes = node.list(2, shape).into_iter();
    match shapes.next() {
        Some(first) => Shape::Difference(Box::new(first), shapes.collect()),
        None => Shape::Union(Vec::new()),
    }
}

pub(super) fn point<const D: usize>(
    fields: &mut Fields<'_, '_>,
    key: &'static str,
    about: &str,
) -> Vector<f64, D> {
    fields.required(key, about, |node| {
        Vector::from_3d(node.vector(&units::LENGTH, Sign::Any))
    })
}

/// A point that is the origin if none is given.
pub(super) fn centre<const D: usize>(fields: &mut Fields<'_, '_>, about: &str) -> Vector<f64, D> {
    let origin = format!("[{}]", ["'0 m'"; D].join(", "));
    fields.or("centre", &origin, about, |node| {
        Vector::from_3d(node.vector(&units::LENGTH, Sign::Any))
    })
}

pub(super) fn radius(fields: &mut Fields<'_, '_>) -> f64 {
    fields.required("radius", "The radius.", |node| {
        node.quantity(&units::LENGTH, Sign::Positive)
    })
}

/// An angle, or in 3D an axis and an angle.
pub(super) fn rotation<const D: usize>(fields: &mut Fields<'_, '_>, about: &str) -> Rotation<D> {
    let default = if D == 2 {
        "'0 deg'"
    } else {
        "{ axis = [0, 0, 1], angle = '0 deg' }"
    };
    fields.or("rotation", default, about, |node| {
        let (axis, angle) = node.either(
            D == 2,
            |node| ([0.0, 0.0, 1.0], node.quantity(&units::ANGLE, Sign::Any)),
            |node| {
                node.table(|fields| {
                    let about = "The axis, of any length; turned by the right hand.";
                    let axis = fields
                        .required("axis", about, |node| node.vector(&units::NUMBER, Sign::Any));
                    let angle = fields.required("angle", "The angle.", |node| {
                        node.quantity(&units::ANGLE, Sign::Any)
                    });
                    (axis, angle)
                })
            },
        );
        Rotation::about(Vector(axis), angle)
    })
}
