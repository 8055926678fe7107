//! A mesh under particles: what they spread on it, and what they feel of a field on it.
//!
//! A particle spreads by the cubic B-spline, on four nodes along each axis, and feels the gradient of
//! the same spline. Nodes lie at whole multiples of the spacing, or some part of it beyond, wherever the particles are. Tasks work on
//! layers of nodes across the first axis; what a node adds up, it adds in one order for any number of threads.
//!
//! - `spread`: what particles spread
//! - `interpolate`: what they feel
//! - `stencil`: differences and smoothing
//! - `harmonic`: values where a field has none
//! - `surroundings`: what a model on a mesh acts in

mod harmonic;
mod interpolate;
mod spread;
mod stencil;
mod surroundings;
#[cfg(test)]
mod tests;

pub(super) use harmonic::Harmonic;
pub(super) use spread::Layered;
pub use surroundings::Surroundings;

use crate::vector::Vector;

/// Layers of nodes that one task works on.
const LAYERS_PER_TASK: usize = 8;
/// Nodes from the origin beyond which no point is looked for.
const FARTHEST: f64 = 1e12;

/// Nodes around some points.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mesh<const D: usize> {
    /// Distance of nodes, m.
    pub spacing: f64,
    /// Where nodes lie beyond whole multiples of that, along each axis, of it.
    beyond: f64,
    low: [i64; D],
    size: [usize; D],
    stride: [usize; D],
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
    /// The mesh that reaches `margin` nodes beyond all points, its nodes `beyond` spacings from whole multiples; none without a point, or with one at no place
    /// or out of all bounds, as of a flow that blows up.
    pub fn around(
        points: impl Iterator<Item = Vector<f64, D>>,
        spacing: f64,
        beyond: f64,
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
                let node = (x[d] / spacing - beyond).floor() as i64;
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
            beyond,
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

    /// How many nodes far along an axis a coordinate is.
    fn along(&self, x: f64) -> f64 {
        x / self.spacing - self.beyond
    }

    /// Whether a point's spline lies inside, with a node to spare.
    pub fn holds(&self, x: &Vector<f64, D>) -> bool {
        (0..D).all(|d| {
            let index = self.along(x[d]).floor() as i64 - self.low[d];
            (2..self.size[d] as i64 - 3).contains(&index)
        })
    }

    /// The place of a node.
    pub fn place(&self, mut node: usize) -> Vector<f64, D> {
        let mut x = Vector::ZERO;
        for d in 0..D {
            let index = (node / self.stride[d]) as i64 + self.low[d];
            x[d] = (index as f64 + self.beyond) * self.spacing;
            node %= self.stride[d];
        }
        x
    }

    /// The node nearest to a point inside.
    pub fn nearest(&self, x: &Vector<f64, D>) -> usize {
        let index = |d: usize| (self.along(x[d]).round() as i64 - self.low[d]) as usize;
        (0..D).map(|d| index(d) * self.stride[d]).sum()
    }

    /// The nodes on either side along an axis.
    pub fn beside(&self, node: usize, axis: usize) -> [usize; 2] {
        [node - self.stride[axis], node + self.stride[axis]]
    }

    fn touched(&self, x: &Vector<f64, D>) -> Touched<D> {
        let mut touched = Touched {
            layer: 0,
            first: 0,
            values: [[0.0; 4]; D],
            slopes: [[0.0; 4]; D],
        };
        for d in 0..D {
            let place = self.along(x[d]);
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
}
