//! Means over the surface that keep what they mean.
//!
//! Beside a wall a mean S [g s u] / S [g s] takes more of some nodes than of others: where the surface ends, half of
//! what is smoothed falls behind the wall, and the other half is divided by a half. What a contact line pulls would not be
//! what arrives at the liquid. With d such that d S [g s d] = 1, the mean
//!
//! T u = S [w u] / S [w],   w = g s d
//!
//! leaves a constant as it is, and the sum of g s T u over all nodes is that of g s u. d is found by a few steps of
//! d <- sqrt(d / S [g s d]) (Sinkhorn and Knopp 1967, for a symmetric matrix).

use super::super::mesh::Mesh;

/// Steps towards d.
const STEPS: usize = 3;
/// Weight below which there is no surface.
const NOTHING: f64 = 1e-9;

/// Columns on the way.
#[derive(Debug, Default)]
pub(super) struct Even {
    even: Vec<f64>,
}

fn inverse(x: f64) -> f64 {
    if x > NOTHING { 1.0 / x } else { 0.0 }
}

impl Even {
    /// Makes w of g s, and S [w] of S [g s]; multiplies `along` by d: what has the weight g s in it, and what has a weight
    /// of its own.
    pub fn out<const D: usize>(
        &mut self,
        mesh: &Mesh<D>,
        passes: usize,
        weight: &mut [f64],
        smooth: &mut Vec<f64>,
        along: [&mut Vec<f64>; 2],
        spare: &mut Vec<f64>,
    ) {
        let even = &mut self.even;
        even.clear();
        even.extend(smooth.iter().map(|&sum| inverse(sum).sqrt()));
        for step in 1..=STEPS {
            smooth.clear();
            smooth.extend(
                weight
                    .iter()
                    .zip(&*even)
                    .map(|(weight, even)| weight * even),
            );
            mesh.smooth(smooth, spare, passes);
            if step < STEPS {
                for (even, sum) in even.iter_mut().zip(&*smooth) {
                    *even = (*even * inverse(*sum)).sqrt();
                }
            }
        }
        let [weighed, own] = along;
        for (weight, even) in weight.iter_mut().zip(&*even) {
            *weight *= even;
        }
        for (weighed, even) in weighed.iter_mut().zip(&*even) {
            *weighed *= even;
        }
        // Beyond the surface d is what its own equation says.
        for (own, sum) in own.iter_mut().zip(&*smooth) {
            *own *= inverse(*sum);
        }
    }
}
