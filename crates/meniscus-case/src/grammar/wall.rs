//! Solid walls.

use std::f64::consts::PI;
use std::ops::Range;

use meniscus::scheme::{Adhesion, Bearing, Motion, Slip};

use super::body::{fluid_of, sections};
use super::fluid::DraftFluid;
use super::motion::motions;
use super::wall_shape::{Surface, WallShape, shape};
use crate::read::{Fields, Node, Sign};
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
    pub adhesion_factor: f64,
    /// Where that stands, if the file gives it.
    pub adhesion_factor_span: Option<Range<usize>>,
    pub bearing: Bearing,
}

/// All walls; none where the file does not say how many dimensions it has.
pub(super) fn walls(node: &mut Node<'_>, fluids: &[DraftFluid]) -> Vec<DraftWall> {
    let example = "{ shape = { tank = { ... } } }";
    sections(
        node,
        example,
        |node, number| wall(node, number, fluids, Surface::Plane),
        |node, number| wall(node, number, fluids, Surface::Space),
    )
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
        let mut adhesion_factor_span = None;
        let about = "Strength of that attraction over that of a sharp surface of the `contact_angle`. \
                     Default: as `meniscus calibrate` measures it on a film.";
        let adhesion_factor = fields.optional("adhesion_factor", about, |node| {
            adhesion_factor_span = Some(node.span());
            node.number(Sign::Positive)
        });
        let about = "Which forces of pairs its pressure balances.";
        let bearing = fields.or("bears", "'pairs'", about, |node| {
            let names = [
                ("pairs", Bearing::Pairs),
                ("adhesion", Bearing::Adhesion),
                ("nothing", Bearing::Nothing),
            ];
            node.name_of("bearing", &names)
        });
        DraftWall {
            name,
            fluid,
            surface: surface(shape),
            shape_span,
            slip,
            motion,
            adhesion,
            adhesion_span,
            adhesion_factor: adhesion_factor.unwrap_or(1.0),
            adhesion_factor_span,
            bearing,
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
    let about = "The contact angle that surface tension is to give, instead of `adhesion`.";
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
