//! A fluid whose cohesion is its surface tension.

use std::ops::Range;

use meniscus::scheme::{Conduction, Substance, VanDerWaals};

use crate::read::{Choice, Fields, Node, Sign};
use crate::units;

/// A van der Waals fluid as read.
#[derive(Clone, Debug)]
pub(crate) struct DraftVanDerWaals {
    /// What it is; where its strength follows from surface tension, that of a cohesion a = 1 Pa m^6/kg^2.
    pub model: VanDerWaals,
    pub by_tension: bool,
    pub span: Range<usize>,
}

/// How its equation of state is given.
#[derive(Clone, Copy)]
enum Stated {
    Substance(Substance),
    Liquid {
        reduced_temperature: f64,
        degrees_of_freedom: f64,
    },
}

/// Reads a fluid whose particles have this density at the start, kg/m^3.
pub(super) fn van_der_waals(node: &mut Node<'_>, density: f64) -> DraftVanDerWaals {
    let mut stated = Stated::Substance(NOTHING);
    let model = read(node, &mut stated);
    let temperature = model.temperature;
    let by_tension = matches!(stated, Stated::Liquid { .. });
    let substance = match stated {
        Stated::Substance(substance) => substance,
        Stated::Liquid {
            reduced_temperature: reduced,
            degrees_of_freedom,
        } => Substance::of_liquid(1.0, density, temperature, reduced, degrees_of_freedom)
            .unwrap_or(NOTHING),
    };
    DraftVanDerWaals {
        model: VanDerWaals { substance, ..model },
        by_tension,
        span: node.span(),
    }
}

/// What a file that is wrong states.
const NOTHING: Substance = Substance {
    gas_constant: f64::NAN,
    cohesion: f64::NAN,
    excluded_volume: f64::NAN,
    degrees_of_freedom: f64::NAN,
};

fn read(node: &mut Node<'_>, stated: &mut Stated) -> VanDerWaals {
    node.table(|fields| VanDerWaals {
        substance: {
            *stated = fields.required("substance", "Its equation of state.", |node| {
                node.choice("substance", SUBSTANCE)
            });
            NOTHING
        },
        temperature: fields.required("temperature", "Temperature at the start.", |node| {
            node.quantity(&units::TEMPERATURE, Sign::Positive)
        }),
        conductivity: fields.or("conductivity", "'0 W/m/K'", "Heat conductivity.", |node| {
            node.quantity(&units::CONDUCTIVITY, Sign::NotNegative)
        }),
        conduction: fields.or(
            "conduction",
            "'brookshaw'",
            "How heat is conducted: between pairs, or by the divergence of a gradient.",
            |node| {
                let names = [
                    ("brookshaw", Conduction::Brookshaw),
                    ("double-sum", Conduction::DoubleSum),
                ];
                node.name_of("form of conduction", &names)
            },
        ),
        bulk_viscosity: fields.or("bulk_viscosity", "'0 Pa s'", "Bulk viscosity.", |node| {
            node.quantity(&units::VISCOSITY, Sign::NotNegative)
        }),
        cohesion_range: fields.or(
            "cohesion_range",
            "2",
            "Range of cohesion over the smoothing length, from 1 to 4.",
            |node| {
                let range = node.number(Sign::Positive);
                if !(1.0..=4.0).contains(&range) {
                    node.fail(
                        format!("`cohesion_range` is {range}"),
                        "not from 1 to 4",
                        "2 keeps a surface smooth",
                    );
                }
                range
            },
        ),
        cohesion_adapts: fields.or(
            "cohesion_smoothing",
            "'fixed'",
            "\"adaptive\" has that range follow smoothing lengths that adapt; energy then needs their grad-h terms.",
            |node| node.name_of("range of cohesion", &[("fixed", false), ("adaptive", true)]),
        ),
    })
}

/// Temperatures over the critical one at which a liquid is told from its vapour by a film in a void, and is not
/// nearly incompressible.
const REDUCED_TEMPERATURES: std::ops::RangeInclusive<f64> = 0.2..=0.6;

const SUBSTANCE: &[Choice<Stated>] = &[
    Choice::new(
        "constants",
        "By the constants of p = rho R T / (1 - b rho) - a rho^2.",
        |node| {
            node.table(|fields| {
                Stated::Substance(Substance {
                    gas_constant: fields.required(
                        "gas_constant",
                        "R: Boltzmann's constant over the mass of a molecule.",
                        |node| node.quantity(&units::SPECIFIC_HEAT, Sign::Positive),
                    ),
                    cohesion: fields.required("cohesion", "a", |node| {
                        node.quantity(&units::COHESION, Sign::NotNegative)
                    }),
                    excluded_volume: fields.required("excluded_volume", "b", |node| {
                        node.quantity(&units::SPECIFIC_VOLUME, Sign::Positive)
                    }),
                    degrees_of_freedom: degrees_of_freedom(fields, "3"),
                })
            })
        },
    ),
    Choice::new(
        "critical_point",
        "By the point where liquid and vapour become one.",
        |node| {
            node.table(|fields| {
                let temperature = fields.required("temperature", "Where it is.", |node| {
                    node.quantity(&units::TEMPERATURE, Sign::Positive)
                });
                let pressure = fields.required("pressure", "Where it is.", |node| {
                    node.quantity(&units::PRESSURE, Sign::Positive)
                });
                let molar_mass = fields.required("molar_mass", "Mass of a mole.", |node| {
                    node.quantity(&units::MOLAR_MASS, Sign::Positive)
                });
                let degrees_of_freedom = degrees_of_freedom(fields, "3");
                Stated::Substance(Substance::of_critical_point(
                    temperature,
                    pressure,
                    molar_mass,
                    degrees_of_freedom,
                ))
            })
        },
    ),
    Choice::new(
        "liquid",
        "By the density and the surface tension that the liquid has at the temperature of the start, beside its vapour.",
        |node| {
            node.table(|fields| Stated::Liquid {
                reduced_temperature: fields.required(
                    "reduced_temperature",
                    "The temperature over that of the critical point, from 0.2 to 0.6.",
                    |node| {
                        let reduced = node.number(Sign::Positive);
                        if !REDUCED_TEMPERATURES.contains(&reduced) {
                            node.fail(
                                format!("`reduced_temperature` is {reduced}"),
                                "not from 0.2 to 0.6",
                                "0.3 makes a liquid that is hardly compressed, with next to no vapour",
                            );
                        }
                        node.example = "0.3".into();
                        reduced
                    },
                ),
                degrees_of_freedom: degrees_of_freedom(fields, "1e6"),
            })
        },
    ),
];

fn degrees_of_freedom(fields: &mut Fields<'_, '_>, default: &'static str) -> f64 {
    let about =
        "xi of a molecule: it has the heat xi/2 R T. With a million temperature hardly changes.";
    fields.or("degrees_of_freedom", default, about, |node| {
        node.number(Sign::Positive)
    })
}
