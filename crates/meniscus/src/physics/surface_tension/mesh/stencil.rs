//! Differences of a field on a mesh, and its smoothing.

use std::ops::{Add, Mul};

use rayon::prelude::*;

use super::Mesh;
use crate::vector::Vector;

impl<const D: usize> Mesh<D> {
    /// Half the difference of the nodes on either side, along each axis.
    pub fn difference(&self, of: &[f64], node: usize) -> Vector<f64, D> {
        Vector(std::array::from_fn(|d| {
            let s = self.stride[d];
            0.5 * (of[node + s] - of[node - s])
        }))
    }

    /// Half the sum of the differences of each component along its axis.
    pub fn divergence(&self, of: &[Vector<f64, D>], node: usize) -> f64 {
        (0..D)
            .map(|d| {
                let s = self.stride[d];
                0.5 * (of[node + s][d] - of[node - s][d])
            })
            .sum()
    }

    /// The nodes that have neighbours on all sides in memory, at corners too.
    pub fn inner(&self) -> std::ops::Range<usize> {
        let farthest: usize = self.stride.iter().sum();
        farthest..self.len() - farthest
    }

    /// Passes of 1/4, 1/2, 1/4 along each axis: each adds half a squared spacing to the variance
    /// of what was spread. It must not reach the edge, where values stay.
    pub fn smooth<T>(&self, values: &mut Vec<T>, spare: &mut Vec<T>, passes: usize)
    where
        T: Copy + Default + Send + Sync + Add<Output = T> + Mul<f64, Output = T>,
    {
        spare.resize(values.len(), T::default());
        let (nodes, inner) = (self.nodes_per_task(), self.inner());
        for axis in 0..D {
            let s = self.stride[axis];
            for _ in 0..passes {
                let from = &*values;
                (spare.par_chunks_mut(nodes).enumerate()).for_each(|(task, to)| {
                    let first = task * nodes;
                    to.copy_from_slice(&from[first..first + to.len()]);
                    let (low, high) = (inner.start.max(first), inner.end.min(first + to.len()));
                    if low >= high {
                        return;
                    }
                    let (to, of) = (&mut to[low - first..high - first], &from[low..high]);
                    let (before, after) = (&from[low - s..high - s], &from[low + s..high + s]);
                    for (((to, of), before), after) in to.iter_mut().zip(of).zip(before).zip(after)
                    {
                        *to = *of * 0.5 + (*before + *after) * 0.25;
                    }
                });
                std::mem::swap(values, spare);
            }
        }
    }

    /// The node and all around it, by their distance in memory.
    pub fn around_node(&self) -> impl Iterator<Item = isize> {
        (0..3_usize.pow(D as u32)).map(|k| {
            (0..D)
                .map(|d| (k / 3_usize.pow(d as u32) % 3) as isize - 1)
                .zip(self.stride)
                .map(|(away, stride)| away * stride as isize)
                .sum()
        })
    }

    /// Weights of the nodes around one, by their distance in memory, that give the gradient at a node of the
    /// field that cubic splines make of values at the nodes.
    pub fn gradient_stencil(&self) -> Vec<(isize, Vector<f64, D>)> {
        const VALUES: [f64; 3] = [1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0];
        const SLOPES: [f64; 3] = [-0.5, 0.0, 0.5];
        let around = (0..3_usize.pow(D as u32)).map(|k| {
            let at: [usize; D] = std::array::from_fn(|d| k / 3_usize.pow(d as u32) % 3);
            let mut away = 0;
            let mut weight = [1.0; D];
            for d in 0..D {
                away += (at[d] as isize - 1) * self.stride[d] as isize;
                for (axis, weight) in weight.iter_mut().enumerate() {
                    *weight *= if d == axis {
                        SLOPES[at[d]]
                    } else {
                        VALUES[at[d]]
                    };
                }
            }
            (away, Vector(weight))
        });
        around
            .filter(|(_, weight)| *weight != Vector::ZERO)
            .collect()
    }
}
