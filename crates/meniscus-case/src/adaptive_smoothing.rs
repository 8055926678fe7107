//! What smoothing lengths that follow density ask of the rest of a case.

use meniscus::scheme::{DensityForm, PressureForm, SurfaceTension};

use crate::diagnostic::{Diagnostic, Severity};
use crate::grammar::Draft;

pub(crate) fn check(draft: &Draft, problems: &mut Vec<Diagnostic>) {
    let physics = &draft.physics;
    let Some(model) = physics.adaptive_smoothing else {
        return;
    };
    let calibrated = !matches!(
        physics.surface_tension,
        None | Some(SurfaceTension::JancikHyhlik(_))
    );
    let complaints = [
        (
            physics.density != DensityForm::Summation,
            "smoothing lengths follow density by summation only",
            "take density = \"summation\"",
        ),
        (
            !draft.walls.is_empty(),
            "smoothing lengths that follow density take no walls",
            "leave the walls out, or adaptive_smoothing",
        ),
        (
            calibrated,
            "this model of surface tension is calibrated for one smoothing length",
            "take \"jancik-hyhlik\" or \"none\", or leave adaptive_smoothing out",
        ),
        (
            model.grad_h && physics.pressure != PressureForm::OverDensitySquared,
            "the grad-h terms belong to one form of the pressure gradient",
            "take pressure = \"over-density-squared\"",
        ),
    ];
    for (_, message, help) in complaints.into_iter().filter(|(wrong, ..)| *wrong) {
        problems.push(Diagnostic {
            severity: Severity::Error,
            message: message.into(),
            label: "asked for here".into(),
            help: Some(help.into()),
            span: Some(physics.adaptive_smoothing_span.clone()),
        });
    }
}
