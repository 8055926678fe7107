//! A square becomes a disc, a cube a sphere, and comes to rest.

use std::f64::consts::PI;

use super::Effort;
use super::at_rest::drift;
use crate::appraise::model::Model;
use crate::appraise::trial::{Evidence, Flow, Reading, Trial};

/// Kinetic energy over that of the surface, of a disc all of which moves at the bar of parasitic speeds,
/// 1e-3 sqrt(sigma / (rho D)): U^2 R / 4; of a sphere it is two thirds of that.
const REST: f64 = 1e-6 / 8.0;

/// La = 1200.
pub fn trials(model: Model, effort: Effort) -> Vec<Trial> {
    let mut trials = Vec::new();
    for &(dimension, resolution) in effort.of(&[(2, 10), (3, 7), (2, 20), (3, 10)], 2) {
        let starts = match (dimension, resolution) {
            (2, 10) | (3, 7) => effort.starts(),
            _ => Effort::Quick.starts(),
        };
        for &start in starts {
            // Half the side of the square or cube as large as the disc or sphere.
            let half = match dimension {
                2 => 0.5 * PI.sqrt(),
                _ => 0.5 * (4.0 * PI / 3.0_f64).cbrt(),
            };
            let corner = |x: f64| format!("{:?}", vec![x; dimension]);
            let shape = format!(
                "{{ block = {{ low = {}, high = {} }} }}",
                corner(-half),
                corner(half)
            );
            trials.push(Trial {
                test: "square to round",
                model,
                dimension,
                resolution,
                variant: String::new(),
                start,
                flow: Flow {
                    viscosity: (2.0_f64 / 1200.0).sqrt(),
                    end_time: 30.0,
                    bodies: vec![(shape, String::new())],
                    rest: "[measure]\nroundness = {}\n".into(),
                    ..Flow::default()
                },
                readings: vec![
                    Reading {
                        quantity: "kinetic energy left, of the surface's",
                        unit: "",
                        bar: Some(REST),
                        read: |run| {
                            Some(run.series.column("kinetic energy")?.last()? / surface(run))
                        },
                    },
                    Reading {
                        quantity: "deviation of the radius, in spacings",
                        unit: "",
                        bar: None,
                        read: |run| Some(run.finding("circularity")?.computed / run.case.spacing),
                    },
                    drift(),
                ],
            });
        }
    }
    trials
}

/// Energy of the surface of a disc or sphere of radius and surface tension one.
fn surface(run: &Evidence<'_>) -> f64 {
    if run.case.dimension == 2 {
        2.0 * PI
    } else {
        4.0 * PI
    }
}
