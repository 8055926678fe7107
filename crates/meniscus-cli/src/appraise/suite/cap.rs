//! A drop that stands on a wall at 90 degrees, and should stand at another angle.

use super::{Effort, Start};
use crate::appraise::model::Model;
use crate::appraise::trial::{Beside, Flow, Reading, Trial};

/// Without weight, La = 120. Models without contact angles do not sit it.
pub fn trials(model: Model, effort: Effort) -> Vec<Trial> {
    if !model.wets {
        return Vec::new();
    }
    let mut trials = Vec::new();
    for &(dimension, resolution) in effort.of(&[(2, 12), (2, 20), (3, 8)], 1) {
        for angle in [30_u32, 60, 120, 150] {
            for slip in ["no-slip", "free-slip"] {
                let first = effort.starts()[0];
                let starts: &[Start] = match (dimension, slip) {
                    (2, "no-slip") => effort.one_seed(),
                    _ => &[first],
                };
                for &start in starts {
                    trials.push(Trial {
                        test: "cap",
                        model,
                        dimension,
                        resolution,
                        variant: format!("{angle} degrees, {slip}"),
                        start,
                        flow: flow(dimension, angle, slip),
                        readings: readings(),
                    });
                }
            }
        }
    }
    trials
}

/// Half a disc or ball on a wall that is to hold it at another angle.
pub fn flow(dimension: usize, angle: u32, slip: &str) -> Flow {
    let (point, normal, shape) = match dimension {
        2 => ("[0, 0]", "[0, 1]", "disc"),
        _ => ("[0, 0, 0]", "[0, 0, 1]", "sphere"),
    };
    let down = normal.replace('1', "-1");
    // A spacing or more beyond the base of the cap that is to be, 2.1 at 30 degrees.
    let width = match angle {
        ..45 => 6,
        45..90 => 4,
        _ => 3,
    };
    Flow {
        viscosity: (2.0_f64 / 120.0).sqrt(),
        end_time: if dimension == 2 { 20.0 } else { 12.0 },
        beside: Beside::Floor,
        bodies: vec![(
            format!(
                "{{ intersection = [{{ {shape} = {{ radius = 1 }} }}, \
                 {{ half_space = {{ point = {point}, normal = {down} }} }}] }}"
            ),
            String::new(),
        )],
        rest: format!(
            "[[wall]]\nshape = {{ plane = {{ point = {point}, normal = {normal}, width = {width} }} }}\n\
             slip = \"{slip}\"\ncontact_angle = \"{angle} deg\"\n\n\
             [measure]\ncontact_angle = {{ point = {point}, normal = {normal}, expected = \"{angle} deg\" }}\n"
        ),
        ..Flow::default()
    }
}

/// Beside what Young and Laplace say.
pub fn readings() -> Vec<Reading> {
    vec![
        Reading {
            quantity: "contact angle",
            unit: "deg",
            bar: Some(3.0),
            read: |run| {
                let found = run.finding("contact-angle")?;
                Some(found.computed - found.reference.as_ref()?.1)
            },
        },
        Reading {
            quantity: "wetted radius",
            unit: "%",
            bar: Some(2.0),
            read: |run| run.percent_above("wetted-radius-circle"),
        },
        Reading {
            quantity: "wetted radius at its foot",
            unit: "%",
            bar: Some(2.0),
            read: |run| run.percent_above("wetted-radius"),
        },
        Reading {
            quantity: "gap, in spacings",
            unit: "",
            bar: None,
            read: |run| Some(run.finding("largest-gap")?.computed / run.case.spacing),
        },
    ]
}
