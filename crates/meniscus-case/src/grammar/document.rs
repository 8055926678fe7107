//! The top of the file.

use meniscus::{Kernel, Precision};

use super::body::{DraftBody, bodies};
use super::deformation::{Deformation, deformation};
use super::fluid::{DraftFluid, fluid};
use super::measure::{Measure, measure};
use super::output::{Output, output};
use super::physics::{Physics, physics};
use super::wall::{DraftWall, walls};
use crate::read::{Fields, Node, Sign};
use crate::units;

/// A case as read, before its bodies are filled.
pub(crate) struct Draft {
    pub title: Option<String>,
    pub description: Option<String>,
    pub dimension: usize,
    pub spacing: f64,
    pub end_time: f64,
    pub kernel: Kernel,
    pub smoothing_length: f64,
    pub precision: Precision,
    pub periodic: [Option<(f64, f64)>; 3],
    pub fluids: Vec<DraftFluid>,
    pub bodies: Vec<DraftBody>,
    pub walls: Vec<DraftWall>,
    pub physics: Physics,
    pub deformation: Option<Deformation>,
    pub output: Output,
    pub measure: Measure,
}

pub(crate) fn document(node: &mut Node<'_>) -> Draft {
    node.table(|fields| {
        let title = fields.optional("title", "A line that names the case in reports.", |node| {
            node.text()
        });
        let description = fields.optional(
            "description",
            "What the case is about, for reports.",
            |node| node.text(),
        );
        let dimension = fields.required("dimension", "Dimensions of space: 2 or 3.", |node| {
            let dimension = node.whole(2..=3) as usize;
            // A wrong one must not make every vector wrong as well.
            let known = node.echo == crate::read::Echo::Leaf(dimension.to_string());
            node.context.dimension.set(known.then_some(dimension));
            dimension
        });
        let spacing = fields.required(
            "spacing",
            "Distance between particles, the unit `dx` below.",
            |node| {
                let spacing = node.quantity(&units::LENGTH, Sign::Positive);
                node.context.spacing.set(Some(spacing));
                spacing
            },
        );
        let end_time = fields.required("end_time", "Simulated time.", |node| {
            node.quantity(&units::TIME, Sign::Positive)
        });
        let kernel = fields.or("kernel", "'wendland-c2'", "Smoothing kernel.", |node| {
            node.name_of("kernel", &Kernel::ALL.map(|kernel| (kernel.name(), kernel)))
        });
        let about = "Smoothing length h, at least one spacing.";
        let smoothing_length = fields.or("smoothing_length", "'2 dx'", about, |node| {
            smoothing_length(node, spacing)
        });
        let about = "In what numbers pairs are worked out: f64 ('double'), or differences of \
                     places exactly and formulas in f32 ('mixed').";
        let precision = fields.or("precision", "'double'", about, |node| {
            let names = [("double", Precision::Double), ("mixed", Precision::Mixed)];
            node.name_of("precision", &names)
        });
        let periodic = periodic(fields);
        let about = "The liquids, each in a section of its own, such as [fluid.water].";
        let fluids = fields.required("fluid", about, |node| node.named(fluid));
        let about = "The bodies of liquid at the start, each in a section [[body]].";
        let bodies = fields.required("body", about, |node| bodies(node, &fluids));
        let about = "Solid walls, each in a section [[wall]].";
        let walls = fields.optional("wall", about, |node| walls(node, &fluids));
        let about = "The equations: all optional.";
        let physics = fields.or("physics", "{}", about, physics);
        let about = "A change of shape on the way, to see a drop swing.";
        let deformation = fields.optional("deformation", about, |node| {
            let bound = periodic.iter().any(Option::is_some) || walls.is_some();
            if bound && !node.context.describing {
                node.fail(
                    "only liquid in a void can be drawn out".into(),
                    "there are walls, or a periodic box",
                    "leave one of them out",
                );
            }
            deformation(node, end_time)
        });
        let about = "How often results are written: all optional.";
        let output = fields.or("output", "{}", about, |node| output(node, end_time));
        let names: Vec<&str> = bodies.iter().map(|body| body.name.as_str()).collect();
        let about = "What is measured beside the usual: all optional.";
        let measure = fields.or("measure", "{}", about, |node| {
            measure(node, end_time, &names)
        });
        Draft {
            title,
            description,
            dimension,
            spacing,
            end_time,
            kernel,
            smoothing_length,
            precision,
            periodic,
            fluids,
            bodies,
            walls: walls.unwrap_or_default(),
            physics,
            deformation,
            output,
            measure,
        }
    })
}

fn smoothing_length(node: &mut Node<'_>, spacing: f64) -> f64 {
    let h = node.quantity(&units::LENGTH, Sign::Positive);
    if h < spacing * (1.0 - 1e-9) {
        node.fail(
            format!("the smoothing length is {:.3} of a spacing", h / spacing),
            "less than one spacing",
            "use at least 1 dx; 1.2 dx to 2 dx is usual",
        );
    }
    if h > spacing * 10.0 {
        node.fail(
            format!("the smoothing length is {:.3} spacings", h / spacing),
            "more than ten spacings",
            "a particle would have thousands of neighbours: 1.2 dx to 2 dx is usual",
        );
    }
    h
}

/// Directions in which the flow repeats itself.
fn periodic(fields: &mut Fields<'_, '_>) -> [Option<(f64, f64)>; 3] {
    let about = "Directions in which the flow repeats itself.";
    let read = |node: &mut Node<'_>| {
        let dimension = node.context.dimension.get();
        node.table(|fields| {
            let about = "The lowest and the highest coordinate of the box.";
            let x = fields.optional("x", about, interval);
            let y = fields.optional("y", about, interval);
            // In 2D there is no such direction.
            let z = if dimension == Some(2) {
                None
            } else {
                fields.optional("z", about, interval)
            };
            [x, y, z]
        })
    };
    fields.optional("periodic", about, read).unwrap_or_default()
}

/// A lowest and a highest coordinate.
pub(super) fn interval(node: &mut Node<'_>) -> (f64, f64) {
    let ends = node.list(2, |node| node.quantity(&units::LENGTH, Sign::Any));
    node.schema["maxItems"] = 2.into();
    let (low, high) = (
        ends.first().copied().unwrap_or(f64::NAN),
        ends.get(1).copied().unwrap_or(f64::NAN),
    );
    if ends.len() > 2 || low >= high {
        node.fail(
            format!("`{}` must be a lowest and a highest coordinate", node.name),
            if ends.len() > 2 {
                "more than two"
            } else {
                "the second is not above the first"
            },
            format!("for example {} = [\"-1 mm\", \"1 mm\"]", node.name),
        );
    } else if high - low < node.context.spacing.get().unwrap_or(f64::NAN) {
        node.fail(
            format!("`{}` is {:.3e} m wide", node.name, high - low),
            "less than one spacing",
            "at least one particle must find room across",
        );
    }
    (low, high)
}
