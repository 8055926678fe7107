//! What a van der Waals fluid makes of a case, and asks of it.

use meniscus::scheme::VanDerWaals;
use meniscus::theory;

use crate::case::Case;
use crate::diagnostic::{Diagnostic, Severity};
use crate::grammar::{Draft, DraftVanDerWaals};

/// Gives such a fluid the cohesion of its surface tension, where that is what the file states, and its speed of sound.
pub(crate) fn complete(draft: &mut Draft) {
    for fluid in &mut draft.fluids {
        let Some(own) = &mut fluid.van_der_waals else {
            continue;
        };
        let (model, fluid) = (&mut own.model, &mut fluid.fluid);
        if own.by_tension {
            let of_one = theory::step_surface_tension(
                1.0,
                fluid.density,
                draft.kernel,
                model.cohesion_range * draft.smoothing_length,
                draft.dimension,
            );
            let strength = fluid.cohesion_factor * fluid.surface_tension / of_one;
            model.substance = model.substance.stronger(strength);
        }
        fluid.sound_speed = sound_speed(model, fluid.density);
    }
}

/// At the start; that of its repulsion where it is about to fall apart.
fn sound_speed(model: &VanDerWaals, density: f64) -> f64 {
    let (substance, temperature) = (&model.substance, model.temperature);
    let whole = substance.sound_speed(density, temperature);
    if whole.is_finite() {
        whole
    } else {
        substance.stiff_sound_speed(density, temperature)
    }
}

/// What films cannot tell.
pub(crate) fn check(draft: &Draft, problems: &mut Vec<Diagnostic>) {
    let by_tension = |own: &DraftVanDerWaals| own.by_tension;
    let calibrated =
        (draft.fluids.iter()).any(|fluid| fluid.van_der_waals.as_ref().is_some_and(by_tension));
    let adaptive = draft.physics.adaptive_smoothing;
    if calibrated && adaptive.is_some_and(|adaptive| adaptive.grad_h) {
        problems.push(Diagnostic {
            severity: Severity::Error,
            message: "the cohesion of this liquid cannot be measured with grad-h terms".into(),
            label: "asked for here".into(),
            help: Some(
                "films tell the forces between two particles, and these terms are none: leave `forces` out, or give the constants of the substance".into(),
            ),
            span: Some(draft.physics.adaptive_smoothing_span.clone()),
        });
    }
}

/// Why the library would not take such a fluid in this setting.
pub(crate) fn refused(case: &Case) -> Option<String> {
    let checked = match case.dimension {
        2 => case.setup::<2>().check(),
        _ => case.setup::<3>().check(),
    };
    checked.err().map(|error| error.0)
}
