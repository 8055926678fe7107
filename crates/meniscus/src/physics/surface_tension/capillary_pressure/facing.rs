//! Which way walls face, and how they bend, at nodes.
//!
//! Where a surface meets a wall, what nodes know of it lies off the contact line: the colour c = C / (1 - C_w) is a mean over that
//! part of the spread that lies before the wall, whose middle is M before the node. So a node on the level set sees
//! the surface at its true angle phi, but as far as M cot(phi) from there along the wall, where a round wall faces elsewhere. To
//! first order the cosine of the true angle is (1 + M k) cos(phi), with k the wall's curvature in that direction, positive where the
//! wall is round.
//!
//! M is the mean of a normal distribution of the spread's variance v that is cut off at the wall, sqrt(v) h(C_w), with h as in
//! [`normals`](super::normals); behind the wall's surface that on it.

use rayon::prelude::*;

use super::super::mesh::Mesh;
use crate::vector::Vector;

/// Colour of a wall above which it is there.
pub(super) const TRACE: f64 = 1e-6;
/// Colour of a wall up to which its direction is sure: beyond, walls of four particles are thin.
const SURE: f64 = 0.75;
/// Largest curvature of a wall that is a curvature, and no edge, 1/dx.
const ROUNDEST: f64 = 0.2;

/// Unit vectors into the wall.
#[derive(Debug, Default)]
pub(super) struct Facing<const D: usize> {
    into: Vec<Vector<f64, D>>,
}

pub(super) fn unit<const D: usize>(vector: Vector<f64, D>) -> Vector<f64, D> {
    vector * (1.0 / vector.norm().max(f64::MIN_POSITIVE))
}

/// 1 up to the first of two values, such as colours of a wall, 0 from the second on, smooth in between.
pub(super) fn fading(value: f64, [from, to]: [f64; 2]) -> f64 {
    let u = ((value - from) / (to - from)).clamp(0.0, 1.0);
    1.0 - u * u * (3.0 - 2.0 * u)
}

/// M, dx, by a polynomial within 0.008, for a variance in dx^2.
pub(super) fn before(wall: f64, variance: f64) -> f64 {
    let root = wall.clamp(0.0, 0.5).sqrt();
    variance.sqrt() * root * (0.1968 + 1.3037 * root)
}

impl<const D: usize> Facing<D> {
    /// Finds the directions.
    pub fn find(&mut self, mesh: &Mesh<D>, wall: &[f64]) {
        let (nodes, inner) = (mesh.nodes_per_task(), mesh.inner());
        self.into.clear();
        self.into.resize(wall.len(), Vector::ZERO);
        let parts = self.into.par_chunks_mut(nodes).enumerate();
        parts.for_each(|(task, into)| {
            for (k, into) in into.iter_mut().enumerate() {
                let i = task * nodes + k;
                if wall[i] > TRACE && inner.contains(&i) {
                    *into = unit(mesh.difference(wall, i));
                }
            }
        });
    }

    /// The unit vector into the wall that a node has near; zero where there is none.
    pub fn into(&self, node: usize) -> Vector<f64, D> {
        *self.into.get(node).unwrap_or(&Vector::ZERO)
    }

    /// How the wall bends along a unit vector, 1/dx: the mean over the nodes around.
    pub fn bend(&self, mesh: &Mesh<D>, wall: &[f64], node: usize, along: Vector<f64, D>) -> f64 {
        let inner = mesh.inner();
        let (mut sum, mut weights) = (0.0, 0.0);
        for away in mesh.around_node() {
            let j = node.wrapping_add_signed(away);
            let weight = (wall[j] * (SURE - wall[j]).max(0.0)).powi(2);
            if weight == 0.0 || !inner.contains(&j) {
                continue;
            }
            for axis in 0..D {
                let [back, ahead] = mesh.beside(j, axis).map(|k| along.dot(&self.into[k]));
                sum -= weight * along[axis] * 0.5 * (ahead - back);
            }
            weights += weight;
        }
        (sum / weights.max(f64::MIN_POSITIVE)).clamp(-ROUNDEST, ROUNDEST)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_middle_of_what_lies_before_a_wall_is_that_of_a_cut_distribution() {
        // phi(y) / (1 - C_w) with y = 0, 1 and 2, from tables of the normal distribution.
        let table = [
            (0.5, 0.398_942),
            (0.158_655, 0.241_971),
            (0.022_750, 0.053_991),
        ];
        for (beyond, density) in table {
            let mean: f64 = density / (1.0 - beyond);
            assert!((before(beyond, 4.0) - 2.0 * mean).abs() < 0.016);
        }
        assert_eq!(before(0.9, 1.0), before(0.5, 1.0));
    }
}
