//! How what is measured is read.

use super::wetting::{contact_angle, meniscus};
use super::{
    Arc, Crown, Hydrostatics, Jet, Measure, Oscillation, Sensor, StaticPressure, Waist, Window,
};
use crate::read::{Fields, Node, Sign};
use crate::units;

/// `bodies` are the names of the bodies.
pub(in crate::grammar) fn measure(node: &mut Node<'_>, end_time: f64, bodies: &[&str]) -> Measure {
    node.table(|fields| Measure {
        oscillation: fields.optional(
            "oscillation",
            "Fit a damped cosine to the semi-axes, and find the surface tension from its frequency.",
            |node| {
                node.table(|fields| {
                    let about = "Number of lobes of the mode; 2 is the ellipse.";
                    let mode = fields.or("mode", "2", about, |node| node.whole(2..=16) as u32);
                    let Window { from, to } = window(fields, end_time, 0.0);
                    Oscillation { mode, from, to }
                })
            },
        ),
        static_pressure: fields.optional(
            "static_pressure",
            "Average the pressure inside a drop at rest, and find the surface tension from it.",
            |node| {
                node.table(|fields| StaticPressure {
                    window: window(fields, end_time, 0.8),
                    outside: fields.optional(
                        "outside",
                        "A place in the fluid around the drop; its pressure is taken off.",
                        |node| node.vector(&units::LENGTH, Sign::Any),
                    ),
                })
            },
        ),
        roundness: fields.optional(
            "roundness",
            "Average how round the first body is, its size by mass and density, and what is at its centre.",
            |node| node.table(|fields| window(fields, end_time, 0.8)),
        ),
        drop_profile: fields.optional(
            "drop_profile",
            "Average what a round drop of a van der Waals fluid is like from its centre to its surface: density, temperature, stress, and the surface tension that the stress has.",
            |node| node.table(|fields| window(fields, end_time, 0.8)),
        ),
        hydrostatics: fields.optional(
            "hydrostatics",
            "Compare pressure with the weight above, all over a liquid at rest.",
            |node| {
                node.table(|fields| Hydrostatics {
                    level: fields.required("level", "Height of the surface.", |node| {
                        node.quantity(&units::LENGTH, Sign::Any)
                    }),
                    depth: fields.required("depth", "Depth of the liquid.", |node| {
                        node.quantity(&units::LENGTH, Sign::Positive)
                    }),
                    window: window(fields, end_time, 0.8),
                })
            },
        ),
        crown: fields.optional(
            "crown",
            "Follow the crown of a splash, and fit power laws to the radii of its base and its rim.",
            |node| node.table(|fields| crown(fields, end_time, bodies)),
        ),
        contact_angle: fields.optional(
            "contact_angle",
            "Average the angle at which the first body meets a wall, and its size there: a flat one by `point` and `normal`, or a round one by `wall`.",
            |node| contact_angle(node, end_time),
        ),
        meniscus: fields.optional(
            "meniscus",
            "Average how the surface in a tank meets its side walls.",
            |node| node.table(|fields| meniscus(fields, end_time)),
        ),
        extremes: fields
            .optional(
                "extremes",
                "Read off how far the first body reaches along x at most, and when it is back: for large swings.",
                |node| node.table(|_| ()),
            )
            .is_some(),
        waist: fields.optional(
            "waist",
            "Radius of the cut through the first body by a plane: where drops merge, or a thread thins.",
            |node| node.table(waist),
        ),
        breakup: fields.optional(
            "breakup",
            "Pieces of the first body, and whether it is a disc, or a bag that opens forward or backward.",
            |node| {
                node.table(|fields| {
                    fields.required("direction", "The way the body goes.", direction)
                })
            },
        ),
        spreading: fields.optional(
            "spreading",
            "Largest width of the first body across a direction, over the diameter that it has as a ball.",
            |node| {
                node.table(|fields| {
                    let about = "The direction, such as the wall's normal, of any length.";
                    fields.required("normal", about, direction)
                })
            },
        ),
        drops: fields
            .optional(
                "drops",
                "Count the pieces of all liquid that hold a hundredth of it or more.",
                |node| node.table(|_| ()),
            )
            .is_some(),
        jet: fields.optional(
            "jet",
            "A jet from a nozzle: where it breaks, and its drops.",
            |node| node.table(|fields| jet(fields, end_time)),
        ),
        mixing: fields
            .optional(
                "mixing",
                "Count the pairs of particles across the surface of the first body: they grow if it mixes.",
                |node| node.table(|_| ()),
            )
            .is_some(),
        sensors: fields.or("sensors", "[]", "Pressure sensors.", sensors),
        curvature: fields.or(
            "curvature",
            "[]",
            "Places where the curvature of the surface is read, from the nearest particle.",
            sensors,
        ),
        curvature_along: fields.optional(
            "curvature_along",
            "A round part of the surface, along which curvature is compared with 1 / R.",
            |node| node.table(arc),
        ),
    })
}

fn arc(fields: &mut Fields<'_, '_>) -> Arc {
    let angle = |node: &mut Node<'_>| node.quantity(&units::ANGLE, Sign::NotNegative);
    Arc {
        centre: fields.required("centre", "Its centre.", |node| {
            node.vector(&units::LENGTH, Sign::Any)
        }),
        radius: fields.required("radius", "Radius of the outermost particles.", |node| {
            node.quantity(&units::LENGTH, Sign::Positive)
        }),
        from: fields.or(
            "from",
            "'0 deg'",
            "Where it begins, from the x axis.",
            angle,
        ),
        to: fields.or("to", "'180 deg'", "Where it ends.", angle),
    }
}

fn waist(fields: &mut Fields<'_, '_>) -> Waist {
    Waist {
        at: fields.required("at", "A point of the plane.", |node| {
            node.vector(&units::LENGTH, Sign::Any)
        }),
        normal: fields.required("normal", "Its normal, of any length.", direction),
        reaches: fields.optional(
            "reaches",
            "A radius; the time at which it is first reached is told.",
            |node| node.quantity(&units::LENGTH, Sign::Positive),
        ),
        time: fields.optional("time", "A time; the radius then is told.", |node| {
            node.quantity(&units::TIME, Sign::NotNegative)
        }),
    }
}

fn jet(fields: &mut Fields<'_, '_>, end_time: f64) -> Jet {
    Jet {
        at: fields.required("at", "The middle of the nozzle's end.", |node| {
            node.vector(&units::LENGTH, Sign::Any)
        }),
        direction: fields.required("direction", "The way the jet goes.", direction),
        radius: fields.required("radius", "Radius of the nozzle.", |node| {
            node.quantity(&units::LENGTH, Sign::Positive)
        }),
        frequency: fields.required("frequency", "Of the modulation of its speed.", |node| {
            node.quantity(&units::RATE, Sign::Positive)
        }),
        window: window(fields, end_time, 0.5),
    }
}

/// A vector of any length but none.
fn direction(node: &mut Node<'_>) -> [f64; 3] {
    let vector = node.vector(&units::NUMBER, Sign::Any);
    node.refuse_zero(&vector);
    vector
}

/// A part of the run: from a share of the end time to its end.
pub(super) fn window(fields: &mut Fields<'_, '_>, end_time: f64, share: f64) -> Window {
    let begin = end_time * share;
    let from = instant(fields, "from", "When it starts.", end_time, begin, None);
    Window {
        from,
        to: end(fields, end_time, from),
    }
}

/// The end of a part of the run that starts at `from`.
fn end(fields: &mut Fields<'_, '_>, end_time: f64, from: f64) -> f64 {
    let about = "When it ends. Default: end_time.";
    instant(
        fields,
        "to",
        about,
        end_time,
        end_time,
        Some(("from", from)),
    )
}

/// A time within the run, after another where one is given by name.
fn instant(
    fields: &mut Fields<'_, '_>,
    key: &'static str,
    about: &str,
    end_time: f64,
    default: f64,
    after: Option<(&str, f64)>,
) -> f64 {
    let read = |node: &mut Node<'_>| {
        let time = node.quantity(&units::TIME, Sign::NotNegative);
        if time > end_time * (1.0 + 1e-9) {
            node.fail(
                format!("`{key}` is {time} s"),
                "after the end of the run",
                format!("end_time is {end_time} s"),
            );
            return f64::NAN;
        }
        if let Some((name, earlier)) = after.filter(|(_, earlier)| time <= *earlier) {
            node.fail(
                format!("`{key}` is {time} s"),
                format!("not after `{name}`"),
                format!("`{name}` is {earlier} s"),
            );
        }
        time
    };
    // A default that follows from a wrong value would be a second complaint about one mistake.
    if default.is_nan() {
        return fields.optional(key, about, read).unwrap_or(f64::NAN);
    }
    fields.or(key, &format!("'{default} s'"), about, read)
}

fn crown(fields: &mut Fields<'_, '_>, end_time: f64, bodies: &[&str]) -> Crown {
    let about = "The point of the surface at rest that the drop falls on; the last axis points up.";
    let impact = fields.required("impact", about, |node| {
        node.vector(&units::LENGTH, Sign::Any)
    });
    let about = "The name of the body whose cavity is measured. Default: all liquid.";
    let layer = fields.optional("layer", about, |node| {
        let name = node.text();
        let found = bodies.iter().position(|body| *body == name);
        if found.is_none() && !name.is_empty() {
            let help = format!("known bodies: {}", bodies.join(", "));
            node.fail(format!("there is no body \"{name}\""), "no such body", help);
        }
        found
    });
    let about = "When the drop touches it: where the power laws begin.";
    let start = instant(fields, "start", about, end_time, 0.0, None);
    let about = "When the fits start. Default: a tenth of the way from `start` to end_time.";
    let tenth = start + 0.1 * (end_time - start);
    let from = instant(
        fields,
        "from",
        about,
        end_time,
        tenth,
        Some(("start", start)),
    );
    Crown {
        impact,
        layer: layer.flatten(),
        start,
        window: Window {
            from,
            to: end(fields, end_time, from),
        },
    }
}

fn sensors(node: &mut Node<'_>) -> Vec<Sensor> {
    let sensors = node.list(0, sensor);
    for (i, sensor) in sensors.iter().enumerate() {
        if sensors[..i].iter().any(|other| other.name == sensor.name) {
            let message = format!("two sensors are called \"{}\"", sensor.name);
            node.fail(
                message,
                "a name stands twice",
                "give each sensor a name of its own",
            );
        }
    }
    sensors
}

fn sensor(node: &mut Node<'_>) -> Sensor {
    node.table(|fields| Sensor {
        name: fields.required("name", "Its name in the time series.", |node| node.text()),
        at: fields.required("at", "Where it is.", |node| {
            node.vector(&units::LENGTH, Sign::Any)
        }),
    })
}
