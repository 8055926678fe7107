//! The sites of rings and shells about a centre, and of rings about an axis, in spacings.

use std::f64::consts::{PI, TAU};

use super::perpendicular::perpendiculars;
use crate::vector::Vector;

/// A site at the centre, and this many rings, in 3D shells, about it.
pub(super) fn visit_rings<const D: usize>(rings: i64, visit: &mut impl FnMut([f64; 3])) {
    visit([0.0; 3]);
    for k in 1..=rings {
        let radius = k as f64;
        if D == 2 {
            for i in 0..6 * k {
                let (sin, cos) = (PI * i as f64 / (3.0 * radius)).sin_cos();
                visit([radius * cos, radius * sin, 0.0]);
            }
        } else {
            // The spiral of equal areas: heights evenly spread, turned by the
            // golden angle from one to the next (Swinbank and Purser 2006).
            let golden_angle = PI * (3.0 - 5.0_f64.sqrt());
            let count = (4.0 * PI * radius * radius).round();
            for i in 0..count as i64 {
                let height = 1.0 - (2.0 * i as f64 + 1.0) / count;
                let across = (1.0 - height * height).sqrt();
                let (sin, cos) = (golden_angle * i as f64).sin_cos();
                visit([
                    radius * across * cos,
                    radius * across * sin,
                    radius * height,
                ]);
            }
        }
    }
}

/// Discs along an axis from the origin, up to `reach` away along it and across.
pub(super) fn visit_discs<const D: usize>(
    axis: Vector<f64, D>,
    reach: i64,
    visit: &mut impl FnMut([f64; 3]),
) {
    let axis = axis * (1.0 / axis.norm());
    let [across, aside] = perpendiculars(&axis).map(|side| side.to_3d());
    let axis = axis.to_3d();
    for i in -reach..=reach {
        let along = i as f64 + 0.5;
        for k in 0..=reach {
            let radius = k as f64 + 0.5;
            // In 2D, where a disc is a row, both its ends.
            let count = if D == 2 { 2.0 } else { (TAU * radius).round() };
            for j in 0..count as i64 {
                let (sin, cos) = (TAU * j as f64 / count).sin_cos();
                visit(std::array::from_fn(|d| {
                    along * axis[d] + radius * (cos * across[d] + sin * aside[d])
                }));
            }
        }
    }
}
