//! Drops at rest: Laplace's pressure, and currents that should not be.

use super::{Effort, ball};
use crate::appraise::model::Model;
use crate::appraise::trial::{Evidence, Flow, Reading, Trial};

/// Pressure inside a drop that a drag brings to rest. R / dx, and the bar in per cent.
const FLAT: [(u32, f64); 3] = [(7, 1.0), (10, 0.5), (20, 0.3)];
const SOLID: [(u32, f64); 3] = [(7, 1.5), (10, 1.0), (20, 0.5)];

/// Laplace's pressure. The drag is about the frequency of the drop.
pub fn laplace(model: Model, effort: Effort) -> Vec<Trial> {
    let mut trials = Vec::new();
    for (dimension, all) in [(2, FLAT), (3, SOLID)] {
        for &(resolution, bar) in effort.of(&all, 2) {
            // A sphere of 20 spacings costs as much as all else.
            let starts = match (dimension, resolution) {
                (3, 20) => &effort.starts()[..1],
                _ => effort.starts(),
            };
            for &start in starts {
                trials.push(Trial {
                    test: "laplace",
                    model,
                    dimension,
                    resolution,
                    variant: String::new(),
                    start,
                    flow: Flow {
                        viscosity: 0.1,
                        end_time: 10.0,
                        bodies: vec![(ball(dimension, 0.0), String::new())],
                        physics: "damping = 2\n".into(),
                        rest: "[measure]\nstatic_pressure = {}\n".into(),
                        ..Flow::default()
                    },
                    readings: vec![
                        Reading {
                            quantity: "pressure",
                            unit: "%",
                            bar: Some(bar),
                            read: pressure,
                        },
                        drift(),
                    ],
                });
            }
        }
    }
    trials
}

/// With forces of pairs the pressure that Laplace means is that of all of them.
fn pressure(run: &Evidence<'_>) -> Option<f64> {
    run.percent_above("inner-mechanical-pressure")
        .or_else(|| run.percent_above("inner-pressure"))
}

/// How fast the centre of mass of a free flow moves, over sqrt(sigma / (rho R)).
pub fn drift() -> Reading {
    Reading {
        quantity: "drift of momentum",
        unit: "",
        bar: Some(1e-12),
        read: |run| run.finding("momentum-drift").map(|found| found.computed),
    }
}

/// Twenty capillary times sqrt(rho D^3 / sigma).
const LONG: f64 = 20.0 * 2.828_427;

/// Largest speed over sqrt(sigma / (rho D)), averaged over the last quarter of twenty capillary times.
pub fn parasitic(model: Model, effort: Effort) -> Vec<Trial> {
    let mut trials = Vec::new();
    let all = [(2, 10), (2, 20), (3, 7)];
    for &(dimension, resolution) in effort.of(&all, 1) {
        for laplace_number in [1200.0_f64, 12000.0, 120.0] {
            let coarse = resolution == 10;
            // Those that have a bar.
            if !coarse && laplace_number < 1000.0 {
                continue;
            }
            let starts = match coarse {
                true => effort.starts(),
                false => Effort::Quick.starts(),
            };
            for &start in starts {
                trials.push(Trial {
                    test: "parasitic currents",
                    model,
                    dimension,
                    resolution,
                    variant: format!("La {laplace_number}"),
                    start,
                    flow: Flow {
                        viscosity: (2.0 / laplace_number).sqrt(),
                        end_time: LONG,
                        bodies: vec![(ball(dimension, 0.0), String::new())],
                        rest: format!(
                            "[measure]\nstatic_pressure = {{ from = {}, to = {LONG} }}\n",
                            0.75 * LONG
                        ),
                        ..Flow::default()
                    },
                    readings: vec![
                        Reading {
                            quantity: "speed",
                            unit: "",
                            bar: (laplace_number > 1000.0).then_some(1e-3),
                            read: |run| run.finding("parasitic").map(|found| found.computed),
                        },
                        Reading {
                            quantity: "speed over that a quarter of the time before",
                            unit: "",
                            bar: Some(1.0),
                            read: |run| {
                                let of = |id: &str| run.finding(id).map(|found| found.computed);
                                Some(of("parasitic")? / of("parasitic-before")?)
                            },
                        },
                        drift(),
                    ],
                });
            }
        }
    }
    trials
}
