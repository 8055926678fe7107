//! A small swing of mode 2: frequency and damping beside viscous theory.

use std::f64::consts::TAU;

use super::Effort;
use super::at_rest::drift;
use crate::appraise::model::Model;
use crate::appraise::trial::{Evidence, Flow, Reading, Trial};
use crate::expected;

/// R / dx, and the bar of the frequency in per cent.
const FLAT: [(u32, f64); 3] = [(7, 1.5), (13, 1.0), (26, 0.5)];
const SOLID: [(u32, f64); 2] = [(7, 2.0), (13, 1.0)];

/// Longest semi-axis at the start.
const STRETCH: f64 = 1.05;

/// La = 1000 by the liquid's own viscosity; theory counts the artificial one too.
pub fn trials(model: Model, effort: Effort) -> Vec<Trial> {
    let mut trials = Vec::new();
    let runs = (effort.of(&FLAT, 2).iter().map(|run| (2, run)))
        .chain(effort.of(&SOLID, 1).iter().map(|run| (3, run)));
    for (dimension, &(resolution, bar)) in runs {
        for &start in effort.starts() {
            let across = STRETCH.powf(-1.0 / (dimension as f64 - 1.0));
            let shape = match dimension {
                2 => format!("{{ ellipse = {{ semi_axes = [{STRETCH}, {across}] }} }}"),
                _ => format!("{{ ellipsoid = {{ semi_axes = [{STRETCH}, {across}, {across}] }} }}"),
            };
            // sqrt(6) and sqrt(8) are Rayleigh's frequencies.
            let period = TAU / if dimension == 2 { 6.0_f64 } else { 8.0 }.sqrt();
            trials.push(Trial {
                test: "swing",
                model,
                dimension,
                resolution,
                variant: String::new(),
                start,
                flow: Flow {
                    viscosity: (2.0_f64 / 1000.0).sqrt(),
                    end_time: 4.0 * period,
                    bodies: vec![(shape, String::new())],
                    rest: format!(
                        "[measure]\noscillation = {{ mode = 2, from = {} }}\n",
                        0.25 * period
                    ),
                    ..Flow::default()
                },
                readings: vec![
                    Reading {
                        quantity: "frequency",
                        unit: "%",
                        bar: Some(bar),
                        read: frequency,
                    },
                    Reading {
                        quantity: "damping",
                        unit: "%",
                        bar: Some(20.0),
                        read: |run| run.percent_above("damping-rate"),
                    },
                    Reading {
                        quantity: "energy gained",
                        unit: "%",
                        bar: None,
                        read: gained,
                    },
                    drift(),
                ],
            });
        }
    }
    trials
}

fn frequency(run: &Evidence<'_>) -> Option<f64> {
    let theory = expected::oscillation(run.case)?.viscous?;
    let found = TAU / run.finding("period")?.computed;
    Some(100.0 * (found / theory.angular_frequency - 1.0))
}

/// The most that kinetic energy, compression and surface together rise again after the first period,
/// of the surface's energy of shape at the start: what the forces made from nothing. In means over a
/// quarter of a period: the drop breathes some ten times as fast, and then has less surface energy than
/// an ellipse of its moments.
fn gained(run: &Evidence<'_>) -> Option<f64> {
    let of = |name: &str| run.series.column(name);
    let (kinetic, stored, surface) = (
        of("kinetic energy")?,
        of("compression energy")?,
        of("surface energy")?,
    );
    let start = of("shape energy")?.first()?;
    let total: Vec<f64> = (0..kinetic.len())
        .map(|k| kinetic[k] + stored[k] + surface[k])
        .collect();
    // The run has four periods.
    let quarter = total.len() / 16;
    let mean = |part: &[f64]| part.iter().sum::<f64>() / quarter as f64;
    let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
    for energy in total.chunks_exact(quarter.max(1)).skip(4).map(mean) {
        least = least.min(energy);
        most = most.max(energy - least);
    }
    Some(100.0 * most / start)
}
