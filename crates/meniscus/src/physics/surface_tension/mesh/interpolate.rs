//! What particles feel of a field on a mesh.

use rayon::prelude::*;

use super::Mesh;
use crate::vector::Vector;

/// Particles that one task works on at least.
const PARTICLES_PER_TASK: usize = 512;

impl<const D: usize> Mesh<D> {
    /// Value, and gradient per metre, of the field that the splines make of values at the nodes, at each point.
    pub fn feel(&self, of: &[f64], points: &[Vector<f64, D>], to: &mut Vec<(f64, Vector<f64, D>)>) {
        to.resize(points.len(), (0.0, Vector::ZERO));
        (to.par_iter_mut(), points)
            .into_par_iter()
            .with_min_len(PARTICLES_PER_TASK)
            .for_each(|(felt, x)| *felt = self.feel_at(of, x));
    }

    /// The same at one point.
    pub fn feel_at(&self, of: &[f64], x: &Vector<f64, D>) -> (f64, Vector<f64, D>) {
        let at = self.touched(x);
        let (mut value, mut gradient) = (0.0, [0.0; D]);
        for k in 0..4_usize.pow(D as u32 - 1) {
            let (start, weight) = self.row(&at, k, |d| &at.values[d]);
            let nodes = &of[start..start + 4];
            let sum = |weights: &[f64; 4]| -> f64 {
                (nodes.iter().zip(weights))
                    .map(|(node, weight)| node * weight)
                    .sum()
            };
            let along = sum(&at.values[D - 1]);
            value += weight * along;
            gradient[D - 1] += weight * sum(&at.slopes[D - 1]);
            for (axis, gradient) in gradient.iter_mut().enumerate().take(D - 1) {
                let (_, weight) = self.row(&at, k, |d| {
                    if d == axis {
                        &at.slopes[d]
                    } else {
                        &at.values[d]
                    }
                });
                *gradient += weight * along;
            }
        }
        (value, Vector(gradient) * (1.0 / self.spacing))
    }

    /// The value of a field of vectors at one point.
    pub fn feel_vector_at(&self, of: &[Vector<f64, D>], x: &Vector<f64, D>) -> Vector<f64, D> {
        let at = self.touched(x);
        let mut sum = Vector::ZERO;
        for k in 0..4_usize.pow(D as u32 - 1) {
            let (start, weight) = self.row(&at, k, |d| &at.values[d]);
            for (node, value) in of[start..start + 4].iter().zip(at.values[D - 1]) {
                sum += *node * (weight * value);
            }
        }
        sum
    }
}
