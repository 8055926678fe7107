//! What particles spread on a mesh.

use std::ops::{AddAssign, Mul};

use rayon::prelude::*;

use super::{LAYERS_PER_TASK, Mesh};
use crate::vector::Vector;

/// Points sorted by the layer of their first node, with what each spreads.
#[derive(Debug, Default)]
pub(in crate::physics::surface_tension) struct Layered<const D: usize> {
    /// Points, and amounts in up to two fields.
    points: Vec<(Vector<f64, D>, [f64; 2])>,
    sorted: Vec<(Vector<f64, D>, [f64; 2])>,
    /// Where the points of each layer start.
    starts: Vec<usize>,
}

impl<const D: usize> Mesh<D> {
    /// Adds the splines of all points to one field, or two.
    pub fn spread(&self, points: &mut Layered<D>, fields: [&mut [f64]; 2]) {
        points.sort(self);
        let points = &*points;
        let [first, second] = fields;
        let nodes = self.nodes_per_task();
        // An empty second field has no part for any task.
        let seconds = second.par_chunks_mut(nodes);
        let has_second = seconds.len() > 0;
        let work = |task: usize, field: &mut [f64], which: usize| {
            let layers = task * LAYERS_PER_TASK..(task + 1) * LAYERS_PER_TASK;
            for (x, amounts) in points.near(&layers) {
                self.spread_one(field, layers.start, x, amounts[which]);
            }
        };
        (first.par_chunks_mut(nodes).enumerate()).for_each(|(task, field)| work(task, field, 0));
        if has_second {
            seconds
                .enumerate()
                .for_each(|(task, field)| work(task, field, 1));
        }
    }

    /// Adds one point's spline to a field.
    pub fn spread_at<T>(&self, field: &mut [T], x: &Vector<f64, D>, amount: T)
    where
        T: Copy + AddAssign + Mul<f64, Output = T>,
    {
        let at = self.touched(x);
        for k in 0..4_usize.pow(D as u32 - 1) {
            let (start, weight) = self.row(&at, k, |d| &at.values[d]);
            for (node, value) in field[start..start + 4].iter_mut().zip(at.values[D - 1]) {
                *node += amount * (weight * value);
            }
        }
    }

    /// Adds that part of one spline that falls on the layers of `field`, which start at `from`.
    fn spread_one(&self, field: &mut [f64], from: usize, x: &Vector<f64, D>, amount: f64) {
        let at = self.touched(x);
        let until = from + field.len() / self.stride[0];
        for k in 0..4_usize.pow(D as u32 - 1) {
            let layer = at.layer + k % 4;
            if (from..until).contains(&layer) {
                let (start, weight) = self.row(&at, k, |d| &at.values[d]);
                let start = start - from * self.stride[0];
                for (node, value) in field[start..start + 4].iter_mut().zip(at.values[D - 1]) {
                    *node += amount * weight * value;
                }
            }
        }
    }
}

impl<const D: usize> Layered<D> {
    /// Forgets all points.
    pub fn clear(&mut self) {
        self.points.clear();
    }

    /// Adds a point that spreads so much in either field.
    pub fn push(&mut self, x: Vector<f64, D>, amounts: [f64; 2]) {
        self.points.push((x, amounts));
    }

    /// Whether there is no point.
    pub fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    fn sort(&mut self, mesh: &Mesh<D>) {
        let layer =
            |x: &Vector<f64, D>| (mesh.along(x[0]).floor() as i64 - 1 - mesh.low[0]) as usize;
        self.starts.clear();
        self.starts.resize(mesh.size[0] + 1, 0);
        for (x, _) in &self.points {
            self.starts[layer(x) + 1] += 1;
        }
        for k in 1..self.starts.len() {
            self.starts[k] += self.starts[k - 1];
        }
        self.sorted.clear();
        self.sorted
            .resize(self.points.len(), (Vector::ZERO, [0.0; 2]));
        for point in &self.points {
            let next = &mut self.starts[layer(&point.0)];
            self.sorted[*next] = *point;
            *next += 1;
        }
        // Each start is now that of the next layer.
        self.starts.rotate_right(1);
        self.starts[0] = 0;
    }

    /// Those whose four layers touch these.
    fn near(&self, layers: &std::ops::Range<usize>) -> &[(Vector<f64, D>, [f64; 2])] {
        let last = self.starts.len() - 1;
        let start = self.starts[layers.start.saturating_sub(3).min(last)];
        let end = self.starts[layers.end.min(last)];
        &self.sorted[start..end]
    }
}
