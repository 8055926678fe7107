//! The same on a round wall: on a ball, and in a round vessel.

use super::cap::readings;
use super::{Effort, Start};
use crate::appraise::model::Model;
use crate::appraise::trial::{Beside, Flow, Trial};

/// Without weight, La = 120, as on the flat wall. Models without contact angles do not sit it.
pub fn trials(model: Model, effort: Effort) -> Vec<Trial> {
    if !model.wets {
        return Vec::new();
    }
    let mut trials = Vec::new();
    for &(dimension, resolution) in effort.of(&[(2, 12), (2, 20), (3, 8)], 1) {
        for angle in [30_u32, 60, 120, 150] {
            let mut add = |wall, start, flow| {
                trials.push(Trial {
                    test: "cap on a round wall",
                    model,
                    dimension,
                    resolution,
                    variant: format!("{angle} degrees, {wall}"),
                    start,
                    flow,
                    readings: readings(),
                });
            };
            let starts = match dimension {
                2 => effort.one_seed(),
                _ => &[Start::Lattice][..],
            };
            for &start in starts {
                add("ball", start, on_ball(dimension, resolution, angle));
            }
            if effort == Effort::Full && dimension == 2 {
                add("vessel", Start::Lattice, in_vessel(resolution, angle));
            }
        }
    }
    trials
}

/// A radius of the wall near to this one for which rings about its centre begin half a spacing off it.
fn between_rings(radius: f64, resolution: u32) -> f64 {
    let spacings = f64::from(resolution);
    ((radius * spacings).round() + 0.5) / spacings
}

/// What lies on a ball half as large again as the drop, under 90 degrees: both centres and the contact
/// line are the corners of a right triangle.
fn on_ball(dimension: usize, resolution: u32, angle: u32) -> Flow {
    let wall = between_rings(1.5, resolution);
    let off = wall.hypot(1.0);
    let (ball, centre) = match dimension {
        2 => ("disc", format!("[0, {off}]")),
        _ => ("sphere", format!("[0, 0, {off}]")),
    };
    // Those of a lattice that is no ring may lie anywhere, but not at the wall.
    let cut = wall + 0.25 / f64::from(resolution);
    let shape = format!(
        "{{ difference = [{{ {ball} = {{ radius = 1, centre = {centre} }} }}, {{ {ball} = {{ radius = {cut} }} }}] }}"
    );
    flow(
        shape,
        &format!("{ball} = {{ radius = {wall} }}"),
        angle,
        if dimension == 2 { 20.0 } else { 12.0 },
    )
}

/// What lies at the bottom of a vessel, three quarters larger than the drop, under 90 degrees. 2D.
fn in_vessel(resolution: u32, angle: u32) -> Flow {
    let wall = between_rings(1.75, resolution);
    let off = wall.hypot(1.0);
    let shape = format!(
        "{{ intersection = [{{ disc = {{ radius = 1, centre = [0, -{off}] }} }}, {{ disc = {{ radius = {wall} }} }}] }}"
    );
    let wall = format!("disc = {{ radius = {wall}, liquid = \"inside\" }}");
    flow(shape, &wall, angle, 20.0)
}

fn flow(shape: String, wall: &str, angle: u32, end_time: f64) -> Flow {
    Flow {
        viscosity: (2.0_f64 / 120.0).sqrt(),
        end_time,
        beside: Beside::Ball,
        bodies: vec![(shape, String::new())],
        rest: format!(
            "[[wall]]\nshape = {{ {wall} }}\ncontact_angle = \"{angle} deg\"\n\n\
             [measure]\ncontact_angle = {{ wall = {{ {wall} }}, expected = \"{angle} deg\" }}\n"
        ),
        ..Flow::default()
    }
}
