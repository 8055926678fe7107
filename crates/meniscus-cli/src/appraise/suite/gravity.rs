//! Surface tension against weight: a puddle, and liquid between two plates. 2D.
//!
//! Heights are those of the liquid's mass, over its width: no particle is taken for the surface.

use meniscus::theory;
use meniscus_output::Frame;

use super::{Effort, Start};
use crate::appraise::model::Model;
use crate::appraise::trial::{Beside, Evidence, Flow, Reading, Trial};

/// Gravity of the puddle: a capillary length of a half.
const PUDDLE_GRAVITY: f64 = 4.0;
/// Half of the width over which the puddle is flat.
const FLAT: f64 = 2.0;

/// Half of the gap between the plates, in which g = 1 lifts liquid by 2 cos(theta).
const HALF_GAP: f64 = 0.5;
/// Thickness of each face of a plate: it hides what is behind it.
const FACE: f64 = 0.5;
/// Half of the periodic box.
const HALF_BOX: f64 = 3.5;
/// Level at the start: the liquid that sinks in between stays clear of the plates' lower edges, at 0.8.
const LEVEL: f64 = 2.4;

/// Models without contact angles do not sit them.
pub fn trials(model: Model, effort: Effort) -> Vec<Trial> {
    if !model.wets {
        return Vec::new();
    }
    let mut trials = Vec::new();
    for &resolution in effort.of(&[10, 20], 1) {
        let starts: &[Start] = match effort {
            Effort::Quick => &[Start::Lattice],
            Effort::Full => &[Start::Lattice, Start::Jittered(1)],
        };
        let runs = [60_u32, 120]
            .into_iter()
            .flat_map(|angle| starts.iter().map(move |&s| (angle, s)));
        for (angle, start) in runs {
            let trial = |test, flow, read| Trial {
                test,
                model,
                dimension: 2,
                resolution,
                variant: format!("{angle} degrees"),
                start,
                flow,
                readings: vec![Reading {
                    quantity: "height",
                    unit: "%",
                    bar: Some(3.0),
                    read,
                }],
            };
            trials.push(trial("puddle", puddle(angle), puddle_height));
            trials.push(trial("rise between plates", plates(angle), rise));
        }
    }
    trials
}

/// A puddle sixteen capillary lengths wide.
fn puddle(angle: u32) -> Flow {
    let height = theory::puddle_height(f64::from(angle).to_radians(), 0.5);
    Flow {
        viscosity: 0.1,
        end_time: 20.0,
        beside: Beside::Walls,
        bodies: vec![(
            format!("{{ block = {{ low = [-4, 0], high = [4, {height}] }} }}"),
            String::new(),
        )],
        physics: format!("body_force = [0, -{PUDDLE_GRAVITY}]\n"),
        rest: format!(
            "[[wall]]\nshape = {{ plane = {{ point = [0, 0], normal = [0, 1], width = 14 }} }}\n\
             contact_angle = \"{angle} deg\"\n\n\
             [measure]\ncontact_angle = {{ point = [0, 0], normal = [0, 1], expected = \"{angle} deg\" }}\n"
        ),
        ..Flow::default()
    }
}

/// Two plates that hang into a periodic pool. Their outer faces, at 90 degrees, leave it flat.
fn plates(angle: u32) -> Flow {
    let plate = |from: f64, angle: u32| {
        let to = from + FACE;
        format!(
            "[[wall]]\nshape = {{ polygon = {{ corners = [[{from}, 0.8], [{to}, 0.8], [{to}, 4.5], [{from}, 4.5]] }} }}\n\
             contact_angle = \"{angle} deg\"\n\n"
        )
    };
    let block = |low: [f64; 2], high: [f64; 2]| {
        (
            format!("{{ block = {{ low = {low:?}, high = {high:?} }} }}"),
            String::new(),
        )
    };
    let outside = HALF_GAP + 2.0 * FACE;
    Flow {
        viscosity: 0.1,
        end_time: 30.0,
        beside: Beside::Walls,
        bodies: vec![
            block([-HALF_BOX, 0.0], [HALF_BOX, 0.8]),
            block([-HALF_BOX, 0.8], [-outside, LEVEL]),
            block([-HALF_GAP, 0.8], [HALF_GAP, LEVEL]),
            block([outside, 0.8], [HALF_BOX, LEVEL]),
        ],
        physics: "body_force = [0, -1]\n".into(),
        rest: [
            format!("[periodic]\nx = [-{HALF_BOX}, {HALF_BOX}]\n\n"),
            "[[wall]]\nshape = { plane = { point = [0, 0], normal = [0, 1] } }\n\n".to_owned(),
            plate(-HALF_GAP - FACE, angle),
            plate(HALF_GAP, angle),
            plate(-HALF_GAP - 2.0 * FACE, 90),
            plate(HALF_GAP + FACE, 90),
        ]
        .concat(),
        ..Flow::default()
    }
}

fn puddle_height(run: &Evidence<'_>) -> Option<f64> {
    let angle = run.case.measure.contact_angle.as_ref()?.expected?;
    let frame = last(run)?;
    let found = level(run, &frame, -FLAT, FLAT)?;
    Some(100.0 * (found / theory::puddle_height(angle, 0.5) - 1.0))
}

fn rise(run: &Evidence<'_>) -> Option<f64> {
    let angle = run
        .case
        .scheme
        .walls
        .iter()
        .find_map(|wall| match wall.adhesion {
            meniscus::scheme::Adhesion::ContactAngle(angle) => Some(angle),
            _ => None,
        })?;
    let frame = last(run)?;
    let inside = level(run, &frame, -HALF_GAP, HALF_GAP)?;
    let outside = HALF_GAP + 2.0 * FACE;
    // The pool goes on through the periodic faces.
    let sides = [(-HALF_BOX, -outside), (outside, HALF_BOX)];
    let [one, other] = sides.map(|(from, to)| level(run, &frame, from, to));
    let far = 0.5 * (one? + other?);
    let right = theory::jurin_rise(angle, 1.0, 2.0 * HALF_GAP, 2);
    Some(100.0 * ((inside - far) / right - 1.0))
}

fn last(run: &Evidence<'_>) -> Option<Frame> {
    let frames = run.frames()?;
    frames.read(frames.times().len().checked_sub(1)?).ok()
}

/// Height above y = 0 that the liquid between two x would have as a block of its rest density.
fn level(run: &Evidence<'_>, frame: &Frame, from: f64, to: f64) -> Option<f64> {
    let wall = frame.fields.iter().find(|field| field.name == "wall")?;
    let inside = (frame.positions.iter().zip(&wall.values))
        .filter(|(x, wall)| **wall == 0.0 && (from..to).contains(&x[0]));
    Some(inside.count() as f64 * run.case.spacing.powi(2) / (to - from))
}
