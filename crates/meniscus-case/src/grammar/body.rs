//! The bodies of liquid at the start.

use std::ops::Range;

use meniscus::shape::{Arrangement, Shape};

use super::arrangement::arrangement;
use super::fluid::DraftFluid;
use super::motion::angular_velocity;
use super::shape::shape;
use crate::diagnostic::nearest;
use crate::read::{Echo, Fields, Node, Sign};
use crate::units;

/// A body as read, before it is filled.
pub(crate) struct DraftBody {
    pub name: String,
    pub fluid: usize,
    pub geometry: Geometry,
    pub shape_span: Range<usize>,
    pub velocity: [f64; 3],
    pub angular_velocity: [f64; 3],
}

/// What a body is, in the dimensions of its case.
pub(crate) enum Geometry {
    Plane(Shape<2>, Arrangement<2>),
    Space(Shape<3>, Arrangement<3>),
}

impl Geometry {
    /// Random displacement of the particles, in spacings.
    pub fn jitter(&self) -> f64 {
        match self {
            Geometry::Plane(_, arrangement) => arrangement.jitter,
            Geometry::Space(_, arrangement) => arrangement.jitter,
        }
    }
}

/// All bodies; none where the file does not say how many dimensions it has.
pub(super) fn bodies(node: &mut Node<'_>, fluids: &[DraftFluid]) -> Vec<DraftBody> {
    let bodies = sections(
        node,
        "{ shape = { block = { ... } } }",
        |node, number| body(node, number, fluids, Geometry::Plane),
        |node, number| body(node, number, fluids, Geometry::Space),
    );
    let most = usize::from(u16::MAX);
    if bodies.len().max(fluids.len()) > most {
        let help =
            format!("at most {most} bodies and fluids; a union makes one body of many shapes");
        node.fail(
            "too many bodies or fluids".into(),
            "more than a particle can name",
            help,
        );
    }
    bodies
}

/// A list of tables, each numbered from 1, with a reader for each number of dimensions; none where
/// the file does not say how many it has.
pub(super) fn sections<T>(
    node: &mut Node<'_>,
    example: &str,
    mut plane: impl FnMut(&mut Node<'_>, usize) -> T,
    mut space: impl FnMut(&mut Node<'_>, usize) -> T,
) -> Vec<T> {
    if node.is_table() {
        let key = &node.name;
        node.fail(
            format!("`{key}` must be a list"),
            "this is a single table",
            format!("write [[{key}]] in double brackets, once for each {key}"),
        );
        return Vec::new();
    }
    let mut count = 0;
    let read = |node: &mut Node<'_>| {
        count += 1;
        let dimension = node.context.dimension.get();
        if dimension.is_none() && !node.context.describing {
            node.example = example.into();
            return None;
        }
        Some(match dimension {
            Some(2) => plane(node, count),
            _ => space(node, count),
        })
    };
    node.list(1, read).into_iter().flatten().collect()
}

fn body<const D: usize>(
    node: &mut Node<'_>,
    number: usize,
    fluids: &[DraftFluid],
    geometry: fn(Shape<D>, Arrangement<D>) -> Geometry,
) -> DraftBody {
    let context = node.context;
    let spacing = context.spacing.get().unwrap_or(f64::NAN);
    let zeros = |unit: &str| format!("[{}]", vec![format!("'0 {unit}'"); D].join(", "));
    node.table(|fields| {
        let default = format!("'body {number}'");
        let name = fields.or("name", &default, "What reports call it.", |node| node.text());
        let fluid = fluid_of(fields, fluids, "The name of its fluid. Default: the only one.");
        let mut shape_span = 0..0;
        let shape = fields.required("shape", "The region that it fills.", |node| {
            shape_span = node.span();
            shape::<D>(node)
        });
        let default = if D == 3 && !context.describing { "'cubic'" } else { "'square'" };
        let about = "How its particles lie beside one another. Default: \"square\", in 3D \"cubic\".";
        let arrangement = fields.or("arrangement", default, about, |node| arrangement::<D>(node, spacing));
        let velocity = fields.or("velocity", &zeros("m/s"), "Velocity at the start.", |node| {
            node.vector(&units::SPEED, Sign::Any)
        });
        let about = "Solid rotation at the start, about the centre of mass: anticlockwise, or in 3D a vector.";
        let default = if D == 2 { "'0 rad/s'".into() } else { zeros("rad/s") };
        let angular_velocity = fields.or("angular_velocity", &default, about, angular_velocity::<D>);
        DraftBody { name, fluid, geometry: geometry(shape, arrangement), shape_span, velocity, angular_velocity }
    })
}

/// The index of the fluid that a body or wall names.
pub(super) fn fluid_of(fields: &mut Fields<'_, '_>, fluids: &[DraftFluid], about: &str) -> usize {
    match fluids {
        [only] if !fields.has("fluid") => {
            fields.note("fluid", Echo::text(&only.fluid.name));
            0
        }
        // With no fluid at all, that is what the file is told.
        [] => {
            let index = fields.optional("fluid", about, |node| fluid(node, fluids));
            index.unwrap_or(0)
        }
        _ => fields.required("fluid", about, |node| fluid(node, fluids)),
    }
}

/// The index of the fluid that is named.
fn fluid(node: &mut Node<'_>, fluids: &[DraftFluid]) -> usize {
    let name = node.text();
    let names = || fluids.iter().map(|fluid| fluid.fluid.name.as_str());
    if let Some(index) = names().position(|other| other == name) {
        return index;
    }
    // An empty name is a wrong type, which has been said.
    if !name.is_empty() && !fluids.is_empty() {
        let help = match nearest(&name, names()) {
            Some(name) => format!("did you mean \"{name}\"?"),
            None => format!("known fluids: {}", names().collect::<Vec<_>>().join(", ")),
        };
        node.fail(
            format!("undefined fluid \"{name}\""),
            format!("there is no [fluid.{name}]"),
            help,
        );
    }
    0
}
