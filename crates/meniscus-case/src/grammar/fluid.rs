//! The liquids.

use std::ops::Range;

use meniscus::scheme::Fluid;

use super::van_der_waals::{DraftVanDerWaals, van_der_waals};
use crate::read::{Fields, Node, Sign};
use crate::units;

/// A fluid as read; its sound speed is NaN where the file gives none.
pub(crate) struct DraftFluid {
    pub fluid: Fluid,
    /// Where the sound speed stands, if the file gives one.
    pub sound_speed_span: Option<Range<usize>>,
    pub surface_tension_span: Option<Range<usize>>,
    /// Where the strength of its cohesion stands, if the file gives it.
    pub cohesion_factor_span: Option<Range<usize>>,
    /// What it is, where it is no liquid of nearly constant density.
    pub van_der_waals: Option<DraftVanDerWaals>,
}

pub(crate) fn fluid(name: &str, node: &mut Node<'_>) -> DraftFluid {
    let context = node.context;
    let draft = read(name, node);
    context.fluids.set(context.fluids.get() + 1);
    if draft.fluid.surface_tension > 0.0 {
        context.has_surface_tension.set(true);
    }
    draft
}

fn read(name: &str, node: &mut Node<'_>) -> DraftFluid {
    let describing = node.context.describing;
    node.table(|fields| {
        let density = fields.required("density", "Density at rest.", |node| {
            node.quantity(&units::DENSITY, Sign::Positive)
        });
        let viscosity = fields.or("viscosity", "'0 Pa s'", "Dynamic viscosity.", |node| {
            node.quantity(&units::VISCOSITY, Sign::NotNegative)
        });
        let about = "A van der Waals fluid, whose cohesion is its surface tension. The density \
                     above then is that of its particles at the start alone.";
        let van_der_waals = fields.optional("van_der_waals", about, |node| {
            node.context.van_der_waals.set(!describing);
            van_der_waals(node, density)
        });
        let plain = Fluid {
            viscosity,
            ..Fluid::new(name, density)
        };
        match van_der_waals {
            Some(own) if !describing => cohesive(fields, plain, own),
            _ => stiff(fields, plain),
        }
    })
}

/// A van der Waals fluid; its sound speed is left to whoever knows its strength.
fn cohesive(fields: &mut Fields<'_, '_>, plain: Fluid, own: DraftVanDerWaals) -> DraftFluid {
    refuse_stiff_keys(fields, own.by_tension);
    let mut draft = DraftFluid {
        fluid: Fluid {
            sound_speed: f64::NAN,
            ..plain
        },
        sound_speed_span: None,
        surface_tension_span: None,
        cohesion_factor_span: None,
        van_der_waals: None,
    };
    if own.by_tension {
        let about = "Surface tension of the liquid against its vapour, or against a void.";
        draft.fluid.surface_tension = fields.required("surface_tension", about, |node| {
            draft.surface_tension_span = Some(node.span());
            node.quantity(&units::SURFACE_TENSION, Sign::Positive)
        });
        if let Some(factor) = cohesion_factor(fields, &mut draft.cohesion_factor_span) {
            draft.fluid.cohesion_factor = factor;
        }
    }
    DraftFluid {
        van_der_waals: Some(own),
        ..draft
    }
}

fn cohesion_factor(fields: &mut Fields<'_, '_>, stands: &mut Option<Range<usize>>) -> Option<f64> {
    let about = "Strength of pairwise forces, or of the cohesion of a van der Waals fluid, over that of a \
                 sharp surface of this surface tension. Default: as `meniscus calibrate` measures it on a film.";
    fields.optional("cohesion_factor", about, |node| {
        *stands = Some(node.span());
        node.number(Sign::Positive)
    })
}

/// Complains of what a van der Waals fluid is not given, unless its cohesion follows from surface tension.
fn refuse_stiff_keys(fields: &mut Fields<'_, '_>, by_tension: bool) {
    let of_tension = ["surface_tension", "cohesion_factor"];
    let others = ["stiffness_exponent", "background_pressure", "sound_speed"];
    let help = "leave it out: it follows from the equation of state";
    let instead = "leave it out: it follows from the equation of state; or leave that to it, \
                   substance = { liquid = { reduced_temperature = 0.3 } }";
    let refused = (of_tension.map(|key| (key, instead)).into_iter())
        .filter(|_| !by_tension)
        .chain(others.map(|key| (key, help)));
    for (key, help) in refused {
        fields.optional(key, "Of a liquid of nearly constant density.", |node| {
            node.fail(
                format!("a van der Waals fluid takes no `{key}`"),
                "not of this fluid",
                help,
            );
        });
    }
}

/// A liquid of nearly constant density.
fn stiff(fields: &mut Fields<'_, '_>, plain: Fluid) -> DraftFluid {
    let mut sound_speed_span = None;
    let mut surface_tension_span = None;
    let given = fields.has("surface_tension");
    let surface_tension = fields.or(
        "surface_tension",
        "'0 N/m'",
        "Surface tension against the surroundings.",
        |node| {
            surface_tension_span = given.then(|| node.span());
            node.quantity(&units::SURFACE_TENSION, Sign::NotNegative)
        },
    );
    let mut cohesion_factor_span = None;
    let cohesion_factor = cohesion_factor(fields, &mut cohesion_factor_span);
    let about = "Exponent of the equation of state.";
    let stiffness_exponent = fields.or("stiffness_exponent", "7", about, |node| {
        node.number(Sign::Positive)
    });
    let about = "Pressure added everywhere.";
    let background_pressure = fields.or("background_pressure", "'0 Pa'", about, |node| {
        node.quantity(&units::PRESSURE, Sign::Any)
    });
    let about =
        "Numerical speed of sound. Default: ten times the largest speed that the case shows.";
    let sound_speed = fields.optional("sound_speed", about, |node| {
        sound_speed_span = Some(node.span());
        node.quantity(&units::SPEED, Sign::Positive)
    });
    DraftFluid {
        fluid: Fluid {
            sound_speed: sound_speed.unwrap_or(f64::NAN),
            stiffness_exponent,
            background_pressure,
            surface_tension,
            cohesion_factor: cohesion_factor.unwrap_or(1.0),
            ..plain
        },
        sound_speed_span,
        surface_tension_span,
        cohesion_factor_span,
        van_der_waals: None,
    }
}
