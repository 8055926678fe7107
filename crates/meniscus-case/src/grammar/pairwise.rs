//! Surface tension by forces between pairs of particles.

use meniscus::physics::surface_tension::pairwise::Pairwise;
use meniscus::physics::surface_tension::pairwise::akinci::{
    Akinci, Curvature, Normalisation, Reading,
};
use meniscus::physics::surface_tension::pairwise::cosine::Cosine;
use meniscus::physics::surface_tension::pairwise::gaussian_pair::GaussianPair;
use meniscus::physics::surface_tension::pairwise::kordilla::Kordilla;
use meniscus::physics::surface_tension::pairwise::lennard_jones::LennardJones;

use crate::read::{Node, Sign};
use crate::units;

pub(super) fn akinci(node: &mut Node<'_>) -> Pairwise {
    Pairwise::Akinci(node.table(|fields| Akinci {
        gamma: fields.optional(
            "gamma",
            "The coefficient of cohesion, m^4/(kg s^2). Default: the one of the fluid's surface tension.",
            |node| node.number(Sign::NotNegative),
        ),
        curvature: fields.or(
            "curvature",
            "'none'",
            "The force by differences of normals: none, in the units of cohesion, or as printed.",
            |node| {
                let names = [
                    ("none", Curvature::None),
                    ("consistent", Curvature::Consistent),
                    ("printed", Curvature::Printed),
                ];
                node.name_of("curvature force", &names)
            },
        ),
        normalisation: fields.or(
            "normalisation",
            "'proper'",
            "The constants of the splines in 2D: with the same integral as in 3D, or those of 3D as printed.",
            |node| {
                let names = [
                    ("proper", Normalisation::Proper),
                    ("printed", Normalisation::Printed),
                ];
                node.name_of("normalisation", &names)
            },
        ),
        reading: fields.or(
            "reading",
            "'force'",
            "What the printed F is: a force, or, against its units, an acceleration.",
            |node| {
                let names = [
                    ("force", Reading::Force),
                    ("acceleration", Reading::Acceleration),
                ];
                node.name_of("reading", &names)
            },
        ),
    }))
}

pub(super) fn cosine(node: &mut Node<'_>) -> Pairwise {
    node.table(|_| Pairwise::Cosine(Cosine))
}

pub(super) fn gaussian_pair(node: &mut Node<'_>) -> Pairwise {
    Pairwise::GaussianPair(node.table(|fields| {
        fields.or(
            "form",
            "'plain'",
            "The difference of two Gaussians, or the distance times it.",
            |node| {
                let names = [
                    ("plain", GaussianPair::Plain),
                    ("times-distance", GaussianPair::TimesDistance),
                ];
                node.name_of("form", &names)
            },
        )
    }))
}

pub(super) fn kordilla(node: &mut Node<'_>) -> Pairwise {
    node.table(|_| Pairwise::Kordilla(Kordilla))
}

pub(super) fn lennard_jones(node: &mut Node<'_>) -> Pairwise {
    node.table(|fields| {
        Pairwise::LennardJones(LennardJones {
            rest_distance: fields.or(
                "rest_distance",
                "'1 dx'",
                "The distance at which two particles neither attract nor repel each other.",
                |node| {
                    let distance = node.quantity(&units::LENGTH, Sign::Positive);
                    let spacing = node.context.spacing.get().unwrap_or(f64::NAN);
                    if distance > spacing * 1.5 || distance < spacing * 0.5 {
                        node.fail(
                            format!("`rest_distance` is {:.3} spacings", distance / spacing),
                            "not between 0.5 and 1.5 spacings",
                            "1 dx is usual",
                        );
                    }
                    distance
                },
            ),
        })
    })
}
