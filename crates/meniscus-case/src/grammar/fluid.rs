//! The liquids.

use std::ops::Range;

use meniscus::scheme::Fluid;

use crate::read::{Node, Sign};
use crate::units;

/// A fluid as read; its sound speed is NaN where the file gives none.
pub(crate) struct DraftFluid {
    pub fluid: Fluid,
    /// Where the sound speed stands, if the file gives one.
    pub sound_speed_span: Option<Range<usize>>,
    pub surface_tension_span: Option<Range<usize>>,
}

pub(crate) fn fluid(name: &str, node: &mut Node<'_>) -> DraftFluid {
    node.table(|fields| {
        let mut sound_speed_span = None;
        let mut surface_tension_span = None;
        let given = fields.has("surface_tension");
        let density = fields.required("density", "Density at rest.", |node| {
            node.quantity(&units::DENSITY, Sign::Positive)
        });
        let surface_tension = fields.or(
            "surface_tension",
            "'0 N/m'",
            "Surface tension against the surroundings.",
            |node| {
                surface_tension_span = given.then(|| node.span());
                node.quantity(&units::SURFACE_TENSION, Sign::NotNegative)
            },
        );
        let viscosity = fields.or("viscosity", "'0 Pa s'", "Dynamic viscosity.", |node| {
            node.quantity(&units::VISCOSITY, Sign::NotNegative)
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
        let fluid = Fluid {
            name: name.into(),
            density,
            sound_speed: sound_speed.unwrap_or(f64::NAN),
            stiffness_exponent,
            background_pressure,
            viscosity,
            surface_tension,
        };
        DraftFluid {
            fluid,
            sound_speed_span,
            surface_tension_span,
        }
    })
}
