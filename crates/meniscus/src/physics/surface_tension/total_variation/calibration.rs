//! What either term of the energy costs on a flat surface.

use super::energy::{Calibrated, terms};
use crate::physics::surface_tension::mesh::spline;

/// Places of the surface between two nodes, and slices of liquid between two nodes.
const PLACES: usize = 16;
const SLICES: usize = 64;

/// k_T and k_G of a half space of liquid that is spread evenly and smoothed in so many passes: along an axis of
/// the mesh all happens in one dimension.
pub(super) fn flat_surface(passes: usize) -> Calibrated {
    // Full on the left, empty on the right.
    let full = passes + 4;
    let count = 3 * full;
    let (mut variation, mut compression) = (0.0, 0.0);
    for place in 0..PLACES {
        let edge = full as f64 + passes as f64 + place as f64 / PLACES as f64;
        let mut colour = vec![0.0; count];
        let slices = (edge * SLICES as f64) as usize;
        for k in 0..slices {
            let x = edge - (k as f64 + 0.5) / SLICES as f64;
            let node = x.floor();
            for (j, value) in spline(x - node).0.iter().enumerate() {
                if let Some(index) = (node as usize + j).checked_sub(1)
                    && let Some(colour) = colour.get_mut(index)
                {
                    *colour += value / SLICES as f64;
                }
            }
        }
        // What the left end lacks.
        colour[..3].fill(1.0);
        for _ in 0..passes {
            let before = colour.clone();
            for i in 1..count - 1 {
                colour[i] = 0.5 * before[i] + 0.25 * (before[i - 1] + before[i + 1]);
            }
        }
        for i in 1..count - 1 {
            let slope = 0.5 * (colour[i + 1] - colour[i - 1]);
            let (first, second) = terms(colour[i], slope.abs());
            variation += first / PLACES as f64;
            compression += second / PLACES as f64;
        }
    }
    Calibrated {
        variation: 1.0 / variation,
        compression: 1.0 / compression,
    }
}
