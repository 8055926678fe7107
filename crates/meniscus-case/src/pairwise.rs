//! What forces between pairs of particles ask of the rest of a case.

use std::ops::Range;

use meniscus::physics::surface_tension::pairwise::Pairwise;
use meniscus::physics::surface_tension::pairwise::estimate::Resolution;
use meniscus::scheme::{Adhesion, Fluid, SurfaceTension};

use crate::diagnostic::{Diagnostic, Severity};
use crate::grammar::Draft;

/// The model of a case, if it is of pairwise forces.
pub(crate) fn model(draft: &Draft) -> Option<Pairwise> {
    match draft.physics.surface_tension {
        Some(SurfaceTension::Pairwise(model)) => Some(model),
        _ => None,
    }
}

/// Whether the strength of the forces is given by gamma, and not by surface tension.
pub(crate) fn has_gamma(draft: &Draft) -> bool {
    model(draft).is_some_and(|model| model.akinci().is_some_and(|akinci| akinci.gamma.is_some()))
}

/// What their cohesion pressure, as far as no background pressure bears it, comes to as a speed, m/s.
pub(crate) fn cohesion_speed(draft: &Draft, fluids: &[Fluid]) -> f64 {
    let Some(model) = model(draft) else {
        return 0.0;
    };
    let resolution = Resolution {
        kernel: draft.kernel,
        smoothing_length: draft.smoothing_length,
        spacing: draft.spacing,
        dimension: draft.dimension,
    };
    let speed = |fluid: &Fluid| {
        let pressure = model.cohesion_pressure(fluid, &resolution) - fluid.background_pressure;
        (pressure.max(0.0) / fluid.density).sqrt()
    };
    fluids.iter().map(speed).fold(0.0, f64::max)
}

/// Walls that attract what can not be attracted, and surface tension beside gamma.
pub(crate) fn check(draft: &Draft, problems: &mut Vec<Diagnostic>) {
    let mut say = |severity, span: &Range<usize>, message: String, label: &str, help: &str| {
        problems.push(Diagnostic {
            severity,
            message,
            label: label.into(),
            help: Some(help.into()),
            span: Some(span.clone()),
        });
    };
    let model = model(draft);
    let cohesive = (draft.fluids.iter()).any(|fluid| fluid.van_der_waals.is_some());
    for wall in &draft.walls {
        let Some(span) = &wall.adhesion_span else {
            continue;
        };
        let name = &wall.name;
        let takes_angle = matches!(
            draft.physics.surface_tension,
            Some(
                SurfaceTension::Balanced(_)
                    | SurfaceTension::CapillaryPressure(_)
                    | SurfaceTension::TotalVariation(_)
            )
        );
        let is_coefficient = matches!(wall.adhesion, Adhesion::Coefficient(_));
        match model {
            None if takes_angle && !is_coefficient => {}
            None if cohesive => say(
                Severity::Error,
                span,
                format!("\"{name}\" can not attract the fluid"),
                "a van der Waals fluid has no walls: their pressure is made for a liquid that is hardly compressed",
                "take a liquid without `van_der_waals` and surface_tension = \"capillary-pressure\" under [physics], or leave the wall out",
            ),
            None if takes_angle => say(
                Severity::Error,
                span,
                format!("\"{name}\" has a coefficient of another model"),
                "`adhesion` is beta of \"akinci\"",
                "give `contact_angle` instead",
            ),
            None => say(
                Severity::Error,
                span,
                format!("\"{name}\" can not attract the fluid"),
                "this model of surface tension knows no walls that attract",
                "give a contact_angle, and surface_tension = \"capillary-pressure\" under [physics]; or pairwise forces, such as \"akinci\"",
            ),
            Some(model) if is_coefficient && model.akinci().is_none() => say(
                Severity::Error,
                span,
                format!("\"{name}\" has a coefficient of another model"),
                "`adhesion` is beta of \"akinci\"",
                "give `contact_angle` instead",
            ),
            Some(_) => {}
        }
    }
    let by_tension = model.is_some() && !has_gamma(draft);
    let stiff = draft
        .fluids
        .iter()
        .filter(|fluid| fluid.van_der_waals.is_none());
    let factors = (stiff.map(|fluid| &fluid.cohesion_factor_span))
        .chain(draft.walls.iter().map(|wall| &wall.adhesion_factor_span));
    for span in factors.flatten().filter(|_| !by_tension) {
        say(
            Severity::Error,
            span,
            "there is nothing that this could be a factor of".into(),
            "only pairwise forces whose strength follows from surface tension have it",
            "leave it out, or choose surface_tension = \"akinci\" under [physics], without `gamma`",
        );
    }
    for wall in &draft.walls {
        if let (Some(span), false) = (
            &wall.adhesion_factor_span,
            matches!(wall.adhesion, Adhesion::ContactAngle(_)),
        ) {
            say(
                Severity::Error,
                span,
                "there is nothing that this could be a factor of".into(),
                "the wall has no contact_angle",
                "give one, or leave this out",
            );
        }
    }
    if has_gamma(draft) {
        for fluid in &draft.fluids {
            if let (true, Some(span)) = (
                fluid.fluid.surface_tension > 0.0,
                &fluid.surface_tension_span,
            ) {
                say(
                    Severity::Warning,
                    span,
                    "this surface tension does nothing but to be compared with".into(),
                    "[physics] surface_tension has `gamma`",
                    "leave `gamma` out, for the one that gives this surface tension",
                );
            }
        }
    }
}
