//! A mesh under particles: what they spread on it, and the gradient that they feel of a field on it.
//!
//! A particle spreads by the cubic B-spline, on four nodes along each axis, and feels the gradient of
//! the same spline. Nodes lie at whole multiples of the spacing, wherever the particles are. Tasks work on
//! layers of nodes across the first axis; what a node adds up, it adds in one order for any number of threads.

use rayon::prelude::*;

use crate::vector::Vector;

/// Layers of nodes that one task works on.
const LAYERS_PER_TASK: usize = 8;
/// Particles that one task works on at least.
const PARTICLES_PER_TASK: usize = 512;

/// Nodes from the origin beyond which no point is looked for.
const FARTHEST: f64 = 1e12;

/// Nodes around some points.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mesh<const D: usize> {
    /// Distance of nodes, m.
    pub spacing: f64,
    low: [i64; D],
    size: [usize; D],
    stride: [usize; D],
}

/// Points sorted by the layer of their first node, with what each spreads.
#[derive(Debug, Default)]
pub(super) struct Layered<const D: usize> {
    /// Points, and amounts in up to two fields.
    points: Vec<(Vector<f64, D>, [f64; 2])>,
    sorted: Vec<(Vector<f64, D>, [f64; 2])>,
    /// Where the points of each layer start.
    starts: Vec<usize>,
}

/// Values of the cubic B-spline at the four nodes around a place t in [0, 1) between the two in the
/// middle, and its slopes there.
pub(super) fn spline(t: f64) -> ([f64; 4], [f64; 4]) {
    let u = 1.0 - t;
    let value = [
        u * u * u / 6.0,
        (t * t * (3.0 * t - 6.0) + 4.0) / 6.0,
        (u * u * (3.0 * u - 6.0) + 4.0) / 6.0,
        t * t * t / 6.0,
    ];
    let slope = [
        -0.5 * u * u,
        t * (1.5 * t - 2.0),
        -u * (1.5 * u - 2.0),
        0.5 * t * t,
    ];
    (value, slope)
}

/// Where a point lies: layer and node of its first four nodes, values and slopes along each axis.
struct Touched<const D: usize> {
    layer: usize,
    first: usize,
    values: [[f64; 4]; D],
    slopes: [[f64; 4]; D],
}

impl<const D: usize> Mesh<D> {
    /// The mesh that reaches `margin` nodes beyond all points; none without a point, or with one at no place
    /// or out of all bounds, as of a flow that blows up.
    pub fn around(
        points: impl Iterator<Item = Vector<f64, D>>,
        spacing: f64,
        margin: i64,
    ) -> Option<Self> {
        let mut low = [i64::MAX; D];
        let mut high = [i64::MIN; D];
        for x in points {
            // A NaN is not less.
            if !x.0.iter().all(|x| x.abs() < FARTHEST * spacing) {
                return None;
            }
            for d in 0..D {
                let node = (x[d] / spacing).floor() as i64;
                low[d] = low[d].min(node);
                high[d] = high[d].max(node);
            }
        }
        if low[0] > high[0] {
            return None;
        }
        let size: [usize; D] =
            std::array::from_fn(|d| (high[d] - low[d] + 1 + 2 * margin) as usize);
        let mut stride = [1; D];
        for d in (1..D).rev() {
            stride[d - 1] = stride[d] * size[d];
        }
        Some(Self {
            spacing,
            low: low.map(|low| low - margin),
            size,
            stride,
        })
    }

    /// Number of nodes.
    pub fn len(&self) -> usize {
        self.size.iter().product()
    }

    /// Nodes that one task works on.
    pub fn nodes_per_task(&self) -> usize {
        LAYERS_PER_TASK * self.stride[0]
    }

    /// Whether a point's spline lies inside, with a node to spare.
    pub fn holds(&self, x: &Vector<f64, D>) -> bool {
        (0..D).all(|d| {
            let index = (x[d] / self.spacing).floor() as i64 - self.low[d];
            (2..self.size[d] as i64 - 3).contains(&index)
        })
    }

    fn touched(&self, x: &Vector<f64, D>) -> Touched<D> {
        let mut touched = Touched {
            layer: 0,
            first: 0,
            values: [[0.0; 4]; D],
            slopes: [[0.0; 4]; D],
        };
        for d in 0..D {
            let place = x[d] / self.spacing;
            let node = place.floor();
            let index = (node as i64 - 1 - self.low[d]) as usize;
            if d == 0 {
                touched.layer = index;
            }
            touched.first += index * self.stride[d];
            (touched.values[d], touched.slopes[d]) = spline(place - node);
        }
        touched
    }

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

    /// The start of the `k`-th row of four nodes, and the product of weights on all axes but the last.
    fn row<'a>(
        &self,
        at: &Touched<D>,
        k: usize,
        weights: impl Fn(usize) -> &'a [f64; 4],
    ) -> (usize, f64) {
        let (mut rest, mut start, mut weight) = (k, at.first, 1.0);
        for d in 0..D - 1 {
            start += rest % 4 * self.stride[d];
            weight *= weights(d)[rest % 4];
            rest /= 4;
        }
        (start, weight)
    }

    /// The gradient, per metre, of the field that the splines make of values at the nodes, at each point.
    pub fn gradients(&self, of: &[f64], points: &[Vector<f64, D>], to: &mut Vec<Vector<f64, D>>) {
        to.resize(points.len(), Vector::ZERO);
        (to.par_iter_mut(), points)
            .into_par_iter()
            .with_min_len(PARTICLES_PER_TASK)
            .for_each(|(gradient, x)| *gradient = self.gradient(of, x));
    }

    fn gradient(&self, of: &[f64], x: &Vector<f64, D>) -> Vector<f64, D> {
        let at = self.touched(x);
        let mut gradient = [0.0; D];
        for (axis, sum) in gradient.iter_mut().enumerate() {
            let of_axis = |d: usize| {
                if d == axis {
                    &at.slopes[d]
                } else {
                    &at.values[d]
                }
            };
            let last = of_axis(D - 1);
            for k in 0..4_usize.pow(D as u32 - 1) {
                let (start, weight) = self.row(&at, k, of_axis);
                let nodes = of[start..start + 4].iter().zip(last);
                *sum += weight * nodes.map(|(value, weight)| value * weight).sum::<f64>();
            }
        }
        Vector(gradient) * (1.0 / self.spacing)
    }

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

    /// The nodes that have neighbours on all sides in memory.
    pub fn inner(&self) -> std::ops::Range<usize> {
        self.stride[0]..self.len() - self.stride[0]
    }

    /// Passes of 1/4, 1/2, 1/4 along each axis: each adds half a squared spacing to the variance
    /// of what was spread. It must not reach the edge.
    pub fn smooth(&self, values: &mut Vec<f64>, spare: &mut Vec<f64>, passes: usize) {
        spare.resize(values.len(), 0.0);
        let (nodes, inner) = (self.nodes_per_task(), self.inner());
        for axis in 0..D {
            let s = self.stride[axis];
            for _ in 0..passes {
                let from = &*values;
                (spare.par_chunks_mut(nodes).enumerate()).for_each(|(task, to)| {
                    let first = task * nodes;
                    let (low, high) = (inner.start.max(first), inner.end.min(first + to.len()));
                    for i in low..high {
                        to[i - first] = 0.5 * from[i] + 0.25 * (from[i - s] + from[i + s]);
                    }
                });
                std::mem::swap(values, spare);
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
            |x: &Vector<f64, D>| ((x[0] / mesh.spacing).floor() as i64 - 1 - mesh.low[0]) as usize;
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_at_no_place_have_no_mesh() {
        for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300] {
            let points = [Vector([0.0, 1.0]), Vector([x, 0.0])];
            assert!(Mesh::around(points.into_iter(), 1.0, 5).is_none());
        }
    }

    /// A few points spread what they have, and feel the gradient of the same splines.
    #[test]
    fn splines_keep_what_is_spread_and_reproduce_linear_fields() {
        let mut points = Layered::<3>::default();
        let place = |k: usize| {
            Vector([0.7, 1.3, 2.1].map(|c: f64| (c * (k as f64 + 0.4)).fract() * 40.0 - 7.0))
        };
        for k in 0..50 {
            points.push(place(k), [1.0, 2.0]);
        }
        let mesh = Mesh::around((0..50).map(place), 1.5, 12).unwrap();
        let mut fields = [vec![0.0; mesh.len()], vec![0.0; mesh.len()]];
        let [a, b] = &mut fields;
        mesh.spread(&mut points, [a, b]);
        let mut spare = Vec::new();
        mesh.smooth(a, &mut spare, 5);
        assert!((a.iter().sum::<f64>() - 50.0).abs() < 1e-12);
        assert!((b.iter().sum::<f64>() - 100.0).abs() < 1e-12);

        let slope = Vector([0.3, -1.0, 2.0]);
        let linear: Vec<f64> = (0..mesh.len())
            .map(|node| {
                let mut rest = node;
                (0..3)
                    .map(|d| {
                        let index = rest / mesh.stride[d];
                        rest %= mesh.stride[d];
                        slope[d] * (index as i64 + mesh.low[d]) as f64 * 1.5
                    })
                    .sum()
            })
            .collect();
        let mut found = Vec::new();
        mesh.gradients(&linear, &[place(3), place(8)], &mut found);
        for gradient in found {
            assert!((gradient - slope).norm() < 1e-11, "{gradient:?}");
        }
    }
}
