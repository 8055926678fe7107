//! The surfaces of walls.

use meniscus::Vector;
use meniscus::physics::wall::layout::{Face, Side};
use meniscus::shape::{Mesh, MeshError, Revolved};

use super::shape::{centre, corners, point, profile, radius};
use crate::read::{Choice, Echo, Fields, Node, Sign};
use crate::units;

/// The surface of a wall, in the dimensions of its case.
pub(crate) enum Surface {
    Plane(WallShape<2>),
    Space(WallShape<3>),
}

/// The surface of a wall.
pub(crate) enum WallShape<const D: usize> {
    Tank {
        low: Vector<f64, D>,
        high: Vector<f64, D>,
        open: Vec<Face>,
    },
    Plane {
        point: Vector<f64, D>,
        normal: Vector<f64, D>,
        width: Option<f64>,
    },
    Ball {
        centre: Vector<f64, D>,
        radius: f64,
        side: Side,
    },
    Polygon {
        corners: Vec<Vector<f64, 2>>,
        side: Side,
    },
    Revolved {
        profile: Revolved,
        side: Side,
    },
    /// None where the file could not be read, which has been said.
    Mesh {
        mesh: Option<Mesh>,
        side: Side,
    },
}

pub(super) fn shape<const D: usize>(node: &mut Node<'_>) -> WallShape<D> {
    node.choice(
        "wall shape",
        &[
            Choice::new(
                "tank",
                "A box around the liquid, with sides along the axes.",
                tank,
            ),
            Choice::new("plane", "A flat wall.", plane),
            Choice::new("disc", "A disc, or all around it.", ball).only_in(2),
            Choice::new("sphere", "A ball, or all around it.", ball).only_in(3),
            Choice::new("polygon", "A polygon, or all around it.", polygon).only_in(2),
            Choice::new(
                "revolved",
                "A polygon turned about an axis, or all around it.",
                revolved,
            )
            .only_in(3),
            Choice::new("mesh", "A surface of triangles, from an STL file.", mesh).only_in(3),
        ],
    )
}

fn tank<const D: usize>(node: &mut Node<'_>) -> WallShape<D> {
    let span = node.span();
    let context = node.context;
    let faces: Vec<(&'static str, Face)> = [
        ("left", (0, false)),
        ("right", (0, true)),
        ("bottom", (D - 1, false)),
        ("top", (D - 1, true)),
        ("front", (1, false)),
        ("back", (1, true)),
    ]
    .into_iter()
    .take(2 * D)
    .collect();
    node.table(|fields| {
        let about = "The inner corner with the lowest coordinates.";
        let low: Vector<f64, D> = point(fields, "low", about);
        let about = "The inner corner with the highest coordinates.";
        let high: Vector<f64, D> = point(fields, "high", about);
        if (0..D).any(|d| low[d] >= high[d]) {
            context.error(
                span,
                "`low` is not below `high`".into(),
                "this tank has no inside".into(),
                Some("each coordinate of `low` must be below that of `high`".into()),
            );
        }
        let about = "Faces without a wall: left and right along x, in 3D front and back along y, \
                     bottom and top along the last axis.";
        let open = fields.or("open", "[]", about, |node| {
            node.list(0, |node| node.name_of("face", &faces))
        });
        WallShape::Tank { low, high, open }
    })
}

fn plane<const D: usize>(node: &mut Node<'_>) -> WallShape<D> {
    node.table(|fields| {
        let point = point(fields, "point", "The middle of its surface.");
        let about = "The direction from the wall to the liquid, of any length.";
        let normal = fields.required("normal", about, |node| {
            let normal = node.vector(&units::NUMBER, Sign::Any);
            node.refuse_zero(&normal);
            Vector::from_3d(normal)
        });
        let about = "How far it reaches about the point, in 3D a square. Default: the whole \
                     periodic box.";
        let width = fields.optional("width", about, |node| {
            node.quantity(&units::LENGTH, Sign::Positive)
        });
        WallShape::Plane {
            point,
            normal,
            width,
        }
    })
}

fn ball<const D: usize>(node: &mut Node<'_>) -> WallShape<D> {
    node.table(|fields| {
        let radius = radius(fields);
        let centre = centre(fields, "The centre.");
        let side = liquid_side(fields);
        WallShape::Ball {
            centre,
            radius,
            side,
        }
    })
}

fn polygon<const D: usize>(node: &mut Node<'_>) -> WallShape<D> {
    node.table(|fields| {
        let corners = corners(fields);
        let side = liquid_side(fields);
        WallShape::Polygon { corners, side }
    })
}

fn revolved<const D: usize>(node: &mut Node<'_>) -> WallShape<D> {
    node.table(|fields| {
        let profile = profile(fields);
        let side = liquid_side(fields);
        WallShape::Revolved { profile, side }
    })
}

fn mesh<const D: usize>(node: &mut Node<'_>) -> WallShape<D> {
    node.table(|fields| {
        let about = "The unit of length in the file.";
        let unit = fields.or("unit", "'1 m'", about, |node| {
            node.quantity(&units::LENGTH, Sign::Positive)
        });
        let about =
            "The STL file, ASCII or binary; a relative name starts from the folder of the case.";
        let mesh = fields.required("file", about, |node| stl(node, unit));
        let about = "Where the liquid is: \"outside\", where the triangles face, or \"inside\".";
        let side = fields.or("liquid", "'outside'", about, side);
        WallShape::Mesh { mesh, side }
    })
}

fn stl(node: &mut Node<'_>, unit: f64) -> Option<Mesh> {
    let name = node.text();
    if name.is_empty() {
        return None;
    }
    let path = node.context.folder.join(&name);
    // So that the case as resolved means the same file wherever it is kept.
    if let Ok(path) = std::path::absolute(&path) {
        node.echo = Echo::text(&path.to_string_lossy());
    }
    let bytes = match std::fs::read(&path) {
        Ok(bytes) => bytes,
        Err(error) => {
            node.fail(
                format!("cannot read {}: {error}", path.display()),
                "this file",
                "give the name of an STL file; a relative one starts from the folder of the case",
            );
            return None;
        }
    };
    let help = match Mesh::from_stl(&bytes, unit) {
        Ok(mesh) => return Some(mesh),
        Err(error) => (
            match error {
                MeshError::NotStl(_) | MeshError::NotFinite(_) => {
                    "export the surface anew, as STL, ASCII or binary"
                }
                MeshError::Empty => "a wall needs at least one triangle",
                MeshError::Degenerate(_) => "take it out of the mesh, and join its corners",
                MeshError::Flipped(..) => {
                    "the corners of all triangles must go round anticlockwise, seen from outside"
                }
            },
            error,
        ),
    };
    node.fail(format!("{name}: {}", help.1), "this file", help.0);
    None
}

/// The side of a round wall or a polygon.
pub(super) fn liquid_side(fields: &mut Fields<'_, '_>) -> Side {
    let about = "Where the liquid is: \"outside\" an obstacle, or \"inside\" a vessel.";
    fields.or("liquid", "'outside'", about, side)
}

/// The side of the wall, which the liquid is not on.
fn side(node: &mut Node<'_>) -> Side {
    let names = [("outside", Side::Inside), ("inside", Side::Outside)];
    node.name_of("side", &names)
}
