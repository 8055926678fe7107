//! How particles lie beside one another.

use meniscus::Vector;
use meniscus::shape::{Arrangement, Pattern};

use super::shape::rotation;
use crate::read::{Choice, Node, Sign};
use crate::units;

pub(super) fn arrangement<const D: usize>(node: &mut Node<'_>, spacing: f64) -> Arrangement<D> {
    let mut arrangement = node.choice(
        "arrangement",
        &[
            Choice::new("square", "A square lattice.", cubic).only_in(2),
            Choice::new(
                "triangular",
                "A triangular lattice, rows along x.",
                close_packed,
            )
            .only_in(2),
            Choice::new(
                "rings",
                "Rings one spacing apart; ring k holds 6 k particles.",
                concentric,
            )
            .only_in(2),
            Choice::new("cubic", "A cubic lattice.", cubic).only_in(3),
            Choice::new(
                "hexagonal",
                "Hexagonal close packing, layers along z.",
                close_packed,
            )
            .only_in(3),
            Choice::new(
                "discs",
                "Discs of rings, all one spacing apart, along the axis of a cylinder or of what is revolved; otherwise along x.",
                stacked,
            )
            .only_in(3),
            Choice::new("shells", "Spherical shells one spacing apart.", concentric).only_in(3),
        ],
    );
    arrangement.spacing = spacing;
    arrangement
}

fn cubic<const D: usize>(node: &mut Node<'_>) -> Arrangement<D> {
    pattern(node, Pattern::Cubic)
}

fn close_packed<const D: usize>(node: &mut Node<'_>) -> Arrangement<D> {
    pattern(node, Pattern::ClosePacked)
}

fn concentric<const D: usize>(node: &mut Node<'_>) -> Arrangement<D> {
    pattern(node, Pattern::Concentric)
}

fn stacked<const D: usize>(node: &mut Node<'_>) -> Arrangement<D> {
    pattern(node, Pattern::Stacked)
}

fn pattern<const D: usize>(node: &mut Node<'_>, pattern: Pattern) -> Arrangement<D> {
    node.table(|fields| {
        let rotation = rotation(fields, "How the pattern is turned about its origin.");
        let about = "Where a particle of a lattice, or the centre of rings, lies. Default: the centre of a round shape; for others the lattice starts half a period inside the low corner.";
        let origin = fields.optional("origin", about, |node| Vector::from_3d(node.vector(&units::LENGTH, Sign::Any)));
        let about = "Each coordinate moves at random by up to this many spacings.";
        let jitter = fields.or("jitter", "0.0", about, |node| {
            let jitter = node.number(Sign::NotNegative);
            if jitter > 0.5 {
                node.fail(format!("`jitter` is {jitter}"), "more than half a spacing", "0.05 to 0.1 is usual");
            }
            jitter
        });
        let about = "Which random displacements.";
        let seed = fields.or("seed", "1", about, |node| node.whole(0..=i64::MAX as u64));
        // The spacing is the case's, and set there.
        Arrangement { rotation, origin, jitter, seed, ..Arrangement::new(pattern, f64::NAN) }
    })
}
