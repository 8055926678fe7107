//! The liquids.

use std::ops::Range;

use meniscus::scheme::{Fluid, VanDerWaals};

use super::van_der_waals::van_der_waals;
use crate::read::{Fields, Node, Sign};
use crate::units;

/// A fluid as read; its sound speed is NaN where the file gives none.
pub(crate) struct DraftFluid {
    pub fluid: Fluid,
    /// Where the sound speed stands, if the file gives one.
    pub sound_speed_span: Option<Range<usize>>,
    pub surface_tension_span: Option<Range<usize>>,
    /// Where the strength of pairwise forces stands, if the file gives it.
    pub cohesion_factor_span: Option<Range<usize>>,
    /// What it is, where it is no liquid of nearly constant density, and where that stands.
    pub van_der_waals: Option<(VanDerWaals, Range<usize>)>,
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
            (van_der_waals(node), node.span())
        });
        let plain = Fluid {
            viscosity,
            ..Fluid::new(name, density)
        };
        match van_der_waals {
            Some((model, _)) if !describing => {
                refuse_stiff_keys(fields);
                DraftFluid {
                    fluid: Fluid {
                        sound_speed: sound_speed(&model, density),
                        ..plain
                    },
                    sound_speed_span: None,
                    surface_tension_span: None,
                    cohesion_factor_span: None,
                    van_der_waals,
                }
            }
            _ => stiff(fields, plain),
        }
    })
}

/// Complains of what a van der Waals fluid is not given.
fn refuse_stiff_keys(fields: &mut Fields<'_, '_>) {
    for key in [
        "surface_tension",
        "cohesion_factor",
        "stiffness_exponent",
        "background_pressure",
        "sound_speed",
    ] {
        fields.optional(key, "Of a liquid of nearly constant density.", |node| {
            node.fail(
                format!("a van der Waals fluid takes no `{key}`"),
                "not of this fluid",
                "leave it out: it follows from the equation of state",
            );
        });
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
    let about = "Strength of pairwise forces over that of a sharp surface of this surface tension. \
                 Default: as `meniscus calibrate` measures it on a film.";
    let cohesion_factor = fields.optional("cohesion_factor", about, |node| {
        cohesion_factor_span = Some(node.span());
        node.number(Sign::Positive)
    });
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
