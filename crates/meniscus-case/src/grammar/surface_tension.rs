//! Models of surface tension; `pairwise` has those of forces between pairs.

use meniscus::physics::surface_tension::balanced::Balanced;
use meniscus::physics::surface_tension::capillary_pressure::CapillaryPressure;
use meniscus::physics::surface_tension::continuum::{Calibration, Continuum, Correction, Form};
use meniscus::physics::surface_tension::curvature::Weighting;
use meniscus::physics::surface_tension::jancik_hyhlik::JancikHyhlik;
use meniscus::physics::surface_tension::total_variation::TotalVariation;
use meniscus::scheme::SurfaceTension;

use super::pairwise;
use crate::read::{Choice, Node, Sign};

pub(super) const SURFACE_TENSION: &[Choice<Option<SurfaceTension>>] = &[
    Choice::new(
        "balanced",
        "In balance with the pressure gradient, for one fluid with a free surface.",
        |node| node.table(|_| Some(SurfaceTension::Balanced(Balanced))),
    ),
    Choice::new(
        "capillary-pressure",
        "The pressure that the surface asks for, found on a mesh, for one fluid with a free surface and at walls.",
        |node| node.table(|_| Some(SurfaceTension::CapillaryPressure(CapillaryPressure))),
    ),
    Choice::new(
        "jancik-hyhlik",
        "Continuum surface force on a free surface, of Jancik and Hyhlik.",
        |node| Some(SurfaceTension::JancikHyhlik(jancik_hyhlik(node))),
    ),
    Choice::new(
        "continuum",
        "Continuum surface force on a free surface or between two fluids, of Morris, corrected by Qiang, Chen and Gao.",
        |node| Some(SurfaceTension::Continuum(continuum(node))),
    ),
    Choice::new(
        "akinci",
        "Forces between pairs of particles: cohesion, curvature and adhesion of Akinci, Akinci and Teschner.",
        |node| Some(SurfaceTension::Pairwise(pairwise::akinci(node))),
    ),
    Choice::new(
        "cosine",
        "Forces between pairs of particles: a cosine, of Tartakovsky and Meakin.",
        |node| Some(SurfaceTension::Pairwise(pairwise::cosine(node))),
    ),
    Choice::new(
        "gaussian-pair",
        "Forces between pairs of particles: two Gaussians, of Tartakovsky and Panchenko.",
        |node| Some(SurfaceTension::Pairwise(pairwise::gaussian_pair(node))),
    ),
    Choice::new(
        "kordilla",
        "Forces between pairs of particles: two splines, of Kordilla, Tartakovsky and Geyer.",
        |node| Some(SurfaceTension::Pairwise(pairwise::kordilla(node))),
    ),
    Choice::new(
        "lennard-jones",
        "Forces between pairs of particles: of the Lennard-Jones potential.",
        |node| Some(SurfaceTension::Pairwise(pairwise::lennard_jones(node))),
    ),
    Choice::new(
        "total-variation",
        "The derivative of an energy, the total variation of a smoothed colour, on a mesh.",
        |node| node.table(|_| Some(SurfaceTension::TotalVariation(TotalVariation))),
    ),
    Choice::new("none", "No surface tension.", |node| node.table(|_| None)),
];

fn jancik_hyhlik(node: &mut Node<'_>) -> JancikHyhlik {
    node.table(|fields| JancikHyhlik {
        slope: fields.or("slope", "2.0", "a of their eq. 8.", |node| {
            node.number(Sign::Positive)
        }),
        power: fields.or("power", "4", "b of their eq. 8.", |node| {
            node.whole(1..=16) as u32
        }),
        threshold: fields.or(
            "threshold",
            "0.1",
            "Normals shorter than this over h count as none; the paper has 0.01, which disorder upsets.",
            |node| node.number(Sign::NotNegative),
        ),
    })
}

fn continuum(node: &mut Node<'_>) -> Continuum {
    let corrections = [("cspm", Correction::Cspm), ("morris", Correction::Morris)];
    node.table(|fields| Continuum {
        normal: fields.or("normal", "'cspm'", "How normals are found.", |node| {
            node.name_of("correction", &corrections)
        }),
        curvature: fields.or("curvature", "'cspm'", "How curvature is found.", |node| {
            node.name_of("correction", &corrections)
        }),
        curvature_smoothing: fields.or(
            "curvature_smoothing",
            "1.5",
            "Smoothing length of curvature over h, from 0.5 to 4.",
            |node| {
                let ratio = node.number(Sign::Positive);
                if !(0.5..=4.0).contains(&ratio) {
                    node.fail(
                        format!("`curvature_smoothing` is {ratio}"),
                        "not between 0.5 and 4",
                        "1 to 2 is usual",
                    );
                }
                ratio
            },
        ),
        threshold: fields.or(
            "threshold",
            "0.01",
            "Normals shorter than this over h count as none; by \"normal-length\" it is taken off all.",
            |node| node.number(Sign::NotNegative),
        ),
        weighting: fields.or(
            "weighting",
            "'normal-length'",
            "What the others weigh in the curvature of their neighbours.",
            |node| {
                let names = [
                    ("normal-length", Weighting::NormalLength),
                    ("volume", Weighting::Volume),
                ];
                node.name_of("weighting", &names)
            },
        ),
        calibration: fields.or(
            "calibration",
            "'flat-layer'",
            "What the force is multiplied by: what makes it add up to sigma on a flat layer, or the paper's 2 (between two fluids 1).",
            |node| {
                let names = [
                    ("flat-layer", Calibration::FlatLayer),
                    ("printed", Calibration::Printed),
                ];
                node.name_of("calibration", &names)
            },
        ),
        form: fields.or(
            "form",
            "'balanced'",
            "How curvature and normals become a force.",
            |node| {
                let names = [
                    ("balanced", Form::Balanced),
                    ("force", Form::Force),
                    ("stress", Form::Stress),
                ];
                node.name_of("form", &names)
            },
        ),
    })
}
