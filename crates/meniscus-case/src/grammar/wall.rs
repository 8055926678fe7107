//! Solid walls.

use std::f64::consts::PI;
use std::ops::Range;

use meniscus::Vector;
use meniscus::physics::wall::layout::{Face, Side};
use meniscus::scheme::{Adhesion, Motion, Slip};

use super::body::fluid_of;
use super::fluid::DraftFluid;
use crate::read::{Choice, Fields, Node, Sign};
use crate::units;

/// A wall as read, before its particles are laid.
pub(crate) struct DraftWall {
    pub name: String,
    pub fluid: usize,
    pub surface: Surface,
    pub shape_span: Range<usize>,
    pub slip: Slip,
    pub motion: Motion,
    pub adhesion: Adhesion,
    /// Where the adhesion stands, if the file gives any.
    pub adhesion_span: Option<Range<usize>>,
}

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
}

/// All walls; none where the file does not say how many dimensions it has.
pub(super) fn walls(node: &mut Node<'_>, fluids: &[DraftFluid]) -> Vec<DraftWall> {
    if node.is_table() {
        let help = "write [[wall]] in double brackets, once for each wall";
        node.fail(
            "`wall` must be a list".into(),
            "this is a single table",
            help,
        );
        return Vec::new();
    }
    let mut count = 0;
    let read = |node: &mut Node<'_>| {
        count += 1;
        let dimension = node.context.dimension.get();
        if dimension.is_none() && !node.context.describing {
            node.example = "{ shape = { tank = { ... } } }".into();
            return None;
        }
        Some(match dimension {
            Some(2) => wall(node, count, fluids, Surface::Plane),
            _ => wall(node, count, fluids, Surface::Space),
        })
    };
    node.list(1, read).into_iter().flatten().collect()
}

fn wall<const D: usize>(
    node: &mut Node<'_>,
    number: usize,
    fluids: &[DraftFluid],
    surface: fn(WallShape<D>) -> Surface,
) -> DraftWall {
    node.table(|fields| {
        let default = format!("'wall {number}'");
        let name = fields.or("name", &default, "What reports call it.", |node| {
            node.text()
        });
        let about = "The name of the fluid that lies against it. Default: the only one.";
        let fluid = fluid_of(fields, fluids, about);
        let mut shape_span = 0..0;
        let shape = fields.required("shape", "Its surface.", |node| {
            shape_span = node.span();
            shape::<D>(node)
        });
        let about = "Whether the liquid sticks to it.";
        let slip = fields.or("slip", "'no-slip'", about, |node| {
            let names = [("no-slip", Slip::NoSlip), ("free-slip", Slip::FreeSlip)];
            node.name_of("kind of slip", &names)
        });
        let motion = fields.or("motion", "'rest'", "How it moves.", |node| {
            node.choice("motion", &motions::<D>())
        });
        let (adhesion, adhesion_span) = adhesion(fields);
        DraftWall {
            name,
            fluid,
            surface: surface(shape),
            shape_span,
            slip,
            motion,
            adhesion,
            adhesion_span,
        }
    })
}

/// How a wall attracts the fluid, and where that stands.
fn adhesion(fields: &mut Fields<'_, '_>) -> (Adhesion, Option<Range<usize>>) {
    let mut span = None;
    let about = "beta of Akinci's adhesion, in the units of gamma. Default: none.";
    let beta = fields.optional("adhesion", about, |node| {
        span = Some(node.span());
        node.number(Sign::NotNegative)
    });
    let about = "The contact angle that pairwise forces are to give, instead of `adhesion`.";
    let angle = fields.optional("contact_angle", about, |node| {
        span = Some(node.span());
        let angle = node.quantity(&units::ANGLE, Sign::NotNegative);
        if angle > PI * (1.0 + 1e-9) {
            node.fail(
                format!("`contact_angle` is {:.1} degrees", angle.to_degrees()),
                "more than 180 degrees",
                "0 deg is complete wetting, 180 deg none at all",
            );
        }
        if beta.is_some() && !node.context.describing {
            node.fail(
                "a wall has either `adhesion` or `contact_angle`".into(),
                "this is the second of them",
                "leave one out: the angle gives the coefficient",
            );
        }
        angle.min(PI)
    });
    let adhesion = match (beta, angle) {
        (_, Some(angle)) => Adhesion::ContactAngle(angle),
        (Some(beta), None) => Adhesion::Coefficient(beta),
        (None, None) => Adhesion::None,
    };
    (adhesion, span)
}

fn shape<const D: usize>(node: &mut Node<'_>) -> WallShape<D> {
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
        let mut corner = |key, about| {
            fields.required(key, about, |node| {
                Vector::from_3d(node.vector(&units::LENGTH, Sign::Any))
            })
        };
        let low: Vector<f64, D> = corner("low", "The inner corner with the lowest coordinates.");
        let high: Vector<f64, D> = corner("high", "The inner corner with the highest coordinates.");
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
        let point = fields.required("point", "The middle of its surface.", |node| {
            Vector::from_3d(node.vector(&units::LENGTH, Sign::Any))
        });
        let about = "The direction from the wall to the liquid, of any length.";
        let normal = fields.required("normal", about, |node| {
            let normal = Vector::from_3d(node.vector(&units::NUMBER, Sign::Any));
            if normal == Vector::ZERO {
                node.fail(
                    "this normal has no direction".into(),
                    "all components are zero",
                    "for example normal = [0, 1]",
                );
            }
            normal
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
        let radius = fields.required("radius", "The radius.", |node| {
            node.quantity(&units::LENGTH, Sign::Positive)
        });
        let origin = format!("[{}]", ["'0 m'"; D].join(", "));
        let centre = fields.or("centre", &origin, "The centre.", |node| {
            Vector::from_3d(node.vector(&units::LENGTH, Sign::Any))
        });
        let side = fields.or("liquid", "'outside'", LIQUID, side);
        WallShape::Ball {
            centre,
            radius,
            side,
        }
    })
}

fn polygon<const D: usize>(node: &mut Node<'_>) -> WallShape<D> {
    node.table(|fields| {
        let about = "The corners in order; the last is joined to the first.";
        let corners = fields.required("corners", about, |node| {
            node.list(3, |node| {
                Vector::from_3d(node.vector(&units::LENGTH, Sign::Any))
            })
        });
        let side = fields.or("liquid", "'outside'", LIQUID, side);
        WallShape::Polygon { corners, side }
    })
}

const LIQUID: &str = "Where the liquid is: \"outside\" an obstacle, or \"inside\" a vessel.";

/// The side of the wall, which the liquid is not on.
fn side(node: &mut Node<'_>) -> Side {
    let names = [("outside", Side::Inside), ("inside", Side::Outside)];
    node.name_of("side", &names)
}

fn motions<const D: usize>() -> [Choice<Motion>; 4] {
    [
        Choice::new("rest", "It stays where it is.", |node| {
            node.table(|_| Motion::Rest)
        }),
        Choice::new("translation", "At a constant velocity.", |node| {
            node.table(|fields| Motion::Translation {
                velocity: fields.required("velocity", "Its velocity.", |node| {
                    node.vector(&units::SPEED, Sign::Any)
                }),
            })
        }),
        Choice::new(
            "oscillation",
            "To and fro: displaced by amplitude (sin(2 pi frequency t + phase) - sin(phase)).",
            |node| {
                node.table(|fields| Motion::Oscillation {
                    amplitude: fields.required("amplitude", "The amplitude.", |node| {
                        node.vector(&units::LENGTH, Sign::Any)
                    }),
                    frequency: fields.required("frequency", "Oscillations per second.", |node| {
                        node.quantity(&units::RATE, Sign::Positive)
                    }),
                    phase: fields.or("phase", "'0 deg'", "Phase at the start.", |node| {
                        node.quantity(&units::ANGLE, Sign::Any)
                    }),
                })
            },
        ),
        Choice::new("rotation", "About an axis, steadily.", |node| {
            node.table(|fields| {
                let about = "Anticlockwise, or in 3D a vector along the axis.";
                let angular_velocity = fields.required("angular_velocity", about, |node| {
                    node.either(
                        D == 2,
                        |node| [0.0, 0.0, node.quantity(&units::ANGULAR_VELOCITY, Sign::Any)],
                        |node| node.vector(&units::ANGULAR_VELOCITY, Sign::Any),
                    )
                });
                let origin = format!("[{}]", ["'0 m'"; D].join(", "));
                let centre = fields.or("centre", &origin, "A point of the axis.", |node| {
                    node.vector(&units::LENGTH, Sign::Any)
                });
                Motion::Rotation {
                    centre,
                    angular_velocity,
                }
            })
        }),
    ]
}
