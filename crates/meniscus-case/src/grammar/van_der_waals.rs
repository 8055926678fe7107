//! A fluid whose cohesion is its surface tension.

use meniscus::scheme::{Conduction, Substance, VanDerWaals};

use crate::read::{Choice, Node, Sign};
use crate::units;

pub(super) fn van_der_waals(node: &mut Node<'_>) -> VanDerWaals {
    node.table(|fields| VanDerWaals {
        substance: fields.required("substance", "Its equation of state.", |node| {
            node.choice("substance", SUBSTANCE)
        }),
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

const SUBSTANCE: &[Choice<Substance>] = &[
    Choice::new(
        "constants",
        "By the constants of p = rho R T / (1 - b rho) - a rho^2.",
        |node| {
            node.table(|fields| Substance {
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
                degrees_of_freedom: degrees_of_freedom(fields),
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
                let degrees_of_freedom = degrees_of_freedom(fields);
                Substance::of_critical_point(temperature, pressure, molar_mass, degrees_of_freedom)
            })
        },
    ),
];

fn degrees_of_freedom(fields: &mut crate::read::Fields<'_, '_>) -> f64 {
    let about = "xi of a molecule: it has the heat xi/2 R T.";
    fields.or("degrees_of_freedom", "3", about, |node| {
        node.number(Sign::Positive)
    })
}
