//! Drops that meet, a thread that breaks, a splash, many drops at once.

use super::at_rest::drift;
use super::{Effort, Start, ball};
use crate::appraise::model::Model;
use crate::appraise::trial::{Beside, Evidence, Flow, Reading, Trial};

/// What has no number of its own to meet: that it ends, keeps its momentum, and leaves what it should.
pub fn trials(model: Model, effort: Effort) -> Vec<Trial> {
    let mut trials = Vec::new();
    let starts = [Start::Lattice, Start::Jittered(1)];
    let mut add = |test, dimension, resolution, start, flow, readings| {
        trials.push(Trial {
            test,
            model,
            dimension,
            resolution,
            variant: String::new(),
            start,
            flow,
            readings,
        });
    };
    for &(dimension, resolution) in effort.of(&[(2, 10), (3, 7), (2, 20), (3, 10)], 2) {
        for start in starts {
            add(
                "two drops merge",
                dimension,
                resolution,
                start,
                merging(dimension, resolution),
                vec![drift(), largest_change()],
            );
            let of_one = Reading {
                quantity: "largest drift of one drop",
                unit: "",
                bar: Some(1e-12),
                read: drift_of_bodies,
            };
            add(
                "five drops apart",
                dimension,
                resolution,
                start,
                apart(dimension),
                vec![drift(), of_one],
            );
        }
    }
    for &resolution in effort.of(&[5, 8], 1) {
        for start in starts {
            let readings = vec![largest_change(), neck()];
            let flow = thread(resolution);
            add("thread breaks", 3, resolution, start, flow, readings);
        }
    }
    for &resolution in effort.of(&[10, 20], 1) {
        for start in starts {
            let readings = vec![largest_change()];
            add("splash", 2, resolution, start, splash(), readings);
        }
    }
    trials
}

/// The least radius of the neck in all the run; none is right.
fn neck() -> Reading {
    Reading {
        quantity: "radius of the neck",
        unit: "",
        bar: Some(0.0),
        read: |run| {
            let (time, radius) = (run.series.column("time")?, run.series.column("waist")?);
            // To its end, or what is left says nothing.
            (*time.last()? >= 0.999 * run.case.end_time).then_some(())?;
            // Where there is nothing there is no radius.
            let broken = radius.iter().any(|radius| radius.is_nan());
            let least = radius.iter().copied().fold(f64::INFINITY, f64::min);
            Some(if broken { 0.0 } else { least })
        },
    }
}

/// A weakly compressible flow changes its density by about 1 %.
fn largest_change() -> Reading {
    Reading {
        quantity: "largest change of density",
        unit: "%",
        bar: None,
        read: |run| run.finding("density-change").map(|found| found.computed),
    }
}

/// Two drops that just touch. La = 1200.
fn merging(dimension: usize, resolution: u32) -> Flow {
    let half = 1.0 + 0.25 / f64::from(resolution);
    Flow {
        viscosity: (2.0_f64 / 1200.0).sqrt(),
        end_time: 10.0,
        bodies: vec![
            (ball(dimension, -half), String::new()),
            (ball(dimension, half), String::new()),
        ],
        ..Flow::default()
    }
}

/// Drops in a row, stretched so that they swing, each with a size and a speed of its own.
fn apart(dimension: usize) -> Flow {
    let bodies = (0..5).map(|k| {
        let (x, r) = (4.0 * f64::from(k), 1.0 - 0.1 * f64::from(k));
        let (long, flat, round) = (1.2 * r, 0.8 * r, 0.9 * r);
        let (shape, velocity) = match dimension {
            2 => (
                format!("{{ ellipse = {{ semi_axes = [{long}, {flat}], centre = [{x}, 0] }} }}"),
                format!("[0, {}]", 0.1 * f64::from(k)),
            ),
            _ => (
                format!(
                    "{{ ellipsoid = {{ semi_axes = [{long}, {round}, {round}], centre = [{x}, 0, 0] }} }}"
                ),
                format!("[0, {}, 0]", 0.1 * f64::from(k)),
            ),
        };
        (shape, format!("velocity = {velocity}\n"))
    });
    Flow {
        viscosity: (2.0_f64 / 1200.0).sqrt(),
        end_time: 5.0,
        bodies: bodies.collect(),
        ..Flow::default()
    }
}

/// The largest change of the mean velocity of any body.
fn drift_of_bodies(run: &Evidence<'_>) -> Option<f64> {
    let frames = run.frames()?;
    let last = frames.times().len().checked_sub(1)?;
    let means = |index: usize| -> Option<Vec<[f64; 3]>> {
        let frame = frames.read(index).ok()?;
        let of = |name: &str| frame.fields.iter().find(|field| field.name == name);
        let (velocity, body) = (of("velocity")?, of("body")?);
        let mut sums = vec![[0.0; 4]; run.case.bodies.len()];
        for (v, body) in velocity.values.chunks_exact(3).zip(&body.values) {
            let sum = sums.get_mut(*body as usize)?;
            (0..3).for_each(|d| sum[d] += v[d]);
            sum[3] += 1.0;
        }
        Some(
            sums.iter()
                .map(|s| [0, 1, 2].map(|d| s[d] / s[3]))
                .collect(),
        )
    };
    let (before, after) = (means(0)?, means(last)?);
    let change =
        |(a, b): (&[f64; 3], &[f64; 3])| (0..3).map(|d| (a[d] - b[d]).powi(2)).sum::<f64>().sqrt();
    Some(before.iter().zip(&after).map(change).fold(0.0, f64::max))
}

/// A thread, endless along x, with the wave that grows fastest: k R = 0.7. Half of it is thinner.
fn thread(resolution: u32) -> Flow {
    let length = std::f64::consts::TAU / 0.7;
    // Whole numbers of spacings, or the seam has a gap.
    let spacings = f64::from(resolution);
    let half = (0.5 * length * spacings).round() / spacings;
    let part = |start: f64, end: f64, radius: f64| {
        (
            format!(
                "{{ cylinder = {{ start = [{start}, 0, 0], end = [{end}, 0, 0], radius = {radius} }} }}"
            ),
            String::new(),
        )
    };
    Flow {
        viscosity: 0.05,
        end_time: 25.0,
        // The neck is measured of the first.
        bodies: vec![part(half, 2.0 * half, 0.95), part(0.0, half, 1.05)],
        rest: format!(
            "[periodic]\nx = [0, {}]\n\n[measure]\nwaist = {{ at = [{}, 0, 0], normal = [1, 0, 0] }}\n",
            2.0 * half,
            1.5 * half
        ),
        ..Flow::default()
    }
}

/// A drop falls into a pool at We = 100.
fn splash() -> Flow {
    let fall = (100.0_f64 / 2.0).sqrt();
    Flow {
        viscosity: 0.02,
        end_time: 1.5,
        beside: Beside::Walls,
        bodies: vec![
            (
                "{ block = { low = [-5, -2], high = [5, 0] } }".into(),
                String::new(),
            ),
            (
                ball(2, 0.0).replace(", 0] }", ", 1.1] }"),
                format!("velocity = [0, {}]\n", -fall),
            ),
        ],
        rest: "[[wall]]\nshape = { tank = { low = [-5, -2], high = [5, 6], open = [\"top\"] } }\n"
            .into(),
        ..Flow::default()
    }
}
