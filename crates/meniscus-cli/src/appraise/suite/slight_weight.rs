//! A drop that stands on a wall, and then gets a weight that should hardly be seen.

use meniscus::theory::SessileDrop;
use meniscus_case::Window;

use super::{Effort, Start, cap};
use crate::appraise::model::Model;
use crate::appraise::trial::{Evidence, Flow, Reading, Trial};
use crate::findings::mean;

/// Bond number rho g R^2 / sigma, R that of the drop at 90 degrees.
const BOND: f64 = 0.01;
/// When the weight begins, in 2D and 3D, and how long it takes to be there.
const BEGIN: [f64; 2] = [16.0, 10.0];
const RAMP: f64 = 2.0;
/// The largest fluctuations that count: the bars of caps, in degrees and per cent.
const REST: [f64; 2] = [3.0, 2.0];
/// The part of the time before, and after, over which the drop is looked at: the last. As it creeps in
/// that time, so it may later.
const LAST: f64 = 0.5;

/// La = 120. Models without contact angles do not sit it.
pub fn trials(model: Model, effort: Effort) -> Vec<Trial> {
    if !model.wets {
        return Vec::new();
    }
    let mut trials = Vec::new();
    for &(dimension, resolution, angles) in effort.of(
        &[(2, 12, &[60, 120][..]), (2, 20, &[60, 120]), (3, 8, &[60])],
        1,
    ) {
        for &angle in angles {
            trials.push(Trial {
                test: "cap under slight weight",
                model,
                dimension,
                resolution,
                variant: format!("{angle} degrees"),
                start: Start::Lattice,
                flow: flow(dimension, angle),
                readings: vec![
                    Reading {
                        quantity: "change of the contact angle",
                        unit: "deg",
                        bar: None,
                        read: |run| Some(angle_change(run)?.found),
                    },
                    Reading {
                        quantity: "change of the contact angle, over what weight and noise allow",
                        unit: "",
                        bar: Some(1.0),
                        read: |run| Some(angle_change(run)?.over_allowed(REST[0])),
                    },
                    Reading {
                        quantity: "change of the wetted radius",
                        unit: "%",
                        bar: None,
                        read: |run| Some(radius_change(run)?.found),
                    },
                    Reading {
                        quantity: "change of the wetted radius, over what weight and noise allow",
                        unit: "",
                        bar: Some(1.0),
                        read: |run| Some(radius_change(run)?.over_allowed(REST[1])),
                    },
                ],
            });
        }
    }
    trials
}

fn flow(dimension: usize, angle: u32) -> Flow {
    let begin = BEGIN[dimension - 2];
    let mut weight = vec![0.0; dimension];
    let none = format!("{weight:?}");
    weight[dimension - 1] = -BOND;
    Flow {
        end_time: 2.0 * begin + RAMP,
        physics: format!(
            "body_force = {{ table = [{{ time = {begin}, acceleration = {none} }}, \
             {{ time = {}, acceleration = {weight:?} }}] }}\n",
            begin + RAMP
        ),
        ..cap::flow(dimension, angle, "no-slip")
    }
}

/// By how much a number changed as the weight came.
struct Change {
    found: f64,
    /// By theory.
    right: f64,
    /// 95 % of its fluctuations before and after.
    noise: f64,
}

impl Change {
    /// What fluctuates by more than `rest` is not at rest.
    fn over_allowed(&self, rest: f64) -> f64 {
        self.found / (self.right.abs() + self.noise.min(rest))
    }
}

/// In degrees. Weight bends the surface; the circle that passes nearest to it shows another angle, the wall's own being the same.
fn angle_change(run: &Evidence<'_>) -> Option<Change> {
    let [before, after] = exact(run)?;
    let shown = |drop: SessileDrop| drop.circle_angle.to_degrees();
    let (found, noise) = change(run, "contact angle")?;
    Some(Change {
        found: found[1] - found[0],
        right: shown(after) - shown(before),
        noise,
    })
}

/// In per cent.
fn radius_change(run: &Evidence<'_>) -> Option<Change> {
    let [before, after] = exact(run)?;
    let (found, noise) = change(run, "wetted radius by circle")?;
    Some(Change {
        found: 100.0 * (found[1] / found[0] - 1.0),
        right: 100.0 * (after.circle_base_radius / before.circle_base_radius - 1.0),
        noise: 100.0 * noise / found[0],
    })
}

/// Means of a column before and after, and how much it fluctuates about them.
fn change(run: &Evidence<'_>, column: &str) -> Option<([f64; 2], f64)> {
    let begin = BEGIN[run.case.dimension - 2];
    let last = |to: f64| {
        let from = to - LAST * begin;
        mean(run.series, column, &Window { from, to })
    };
    let (before, after) = (last(begin)?, last(run.case.end_time)?);
    let noise = before.half_width.hypot(after.half_width);
    Some(([before.value, after.value], noise))
}

/// The drop without weight and with it. Lengths are in units in which sigma and rho are one.
fn exact(run: &Evidence<'_>) -> Option<[SessileDrop; 2]> {
    let body = run.case.bodies.first()?;
    let angle = run.case.measure.contact_angle.as_ref()?.expected?;
    let drop = |length| SessileDrop::of_volume(body.volume, angle, length, run.case.dimension);
    Some([drop(f64::INFINITY), drop(BOND.sqrt().recip())])
}
