//! Which way the surface faces, at nodes.
//!
//! Before a wall the colour c = C / (1 - C_w) is a mean over that part of the spread that lies before the wall. A surface
//! that meets the wall under an angle is so bent upright: with the spread a normal distribution of variance v that is cut off
//! at the wall, a straight surface x(z) has the mean m(z), and m'(z) / x'(z) is the variance of the cut distribution over v,
//!
//! r = 1 - h (h + y),   h = exp(-y^2 / 2) / (sqrt(2 pi) (1 - C_w)),   with y such that C_w is the distribution's part beyond it
//!
//! (0.84, 0.59 and 0.36 where C_w = 0.04, 0.19 and 0.5). So the part of grad c towards the wall is divided by r. Further in
//! c is a small difference of what particles of the first two rows spread; between C_w = 0.15 and 0.35 nodes go over to
//! the direction of those before them, row after row.
//!
//! Level sets stay bent. What is to be summed along the wall's normal takes their own rise there (`rise`), and what changes along the
//! true surface does so over another length (`divergence`).

use rayon::prelude::*;

use super::super::mesh::Mesh;
use super::facing::{Facing, TRACE, fading, unit};
use crate::vector::Vector;

/// Colours of a wall between which nodes go over to the direction of those before them.
const OWN: [f64; 2] = [0.15, 0.35];
/// Rows behind these that still get one.
const ROWS: usize = 3;
/// Largest colour of a wall whose r is used.
const LAST: f64 = 0.25;
/// Colour of a wall from which on it is beside the surface in full.
const BESIDE: f64 = 0.02;
/// Least sine of the angle at which a surface meets a wall, where something is divided by it.
const LEAST_RISE: f64 = 0.1;

/// The directions.
#[derive(Debug, Default)]
pub(super) struct Normals<const D: usize> {
    /// Of the length of grad c, at the surface and one node around, zero else.
    normal: Vec<Vector<f64, D>>,
    /// Which way grad c itself faces, where walls are near; else zero.
    apparent: Vec<Vector<f64, D>>,
    /// 0 far from walls, 1 beside them.
    beside: Vec<f64>,
    /// Directions on their way behind a wall, as long as they are known.
    lifted: Vec<Vector<f64, D>>,
    before: Vec<Vector<f64, D>>,
}

/// r, by a polynomial within 0.008.
fn upright(wall: f64) -> f64 {
    let root = wall.sqrt();
    1.0 - root * (0.4801 + root * (2.3022 + root * (-3.6808 + root * 1.7882)))
}

/// The share of a node's own direction.
fn own(wall: f64) -> f64 {
    fading(wall, OWN)
}

/// Of the angle at which a surface meets a wall.
pub(super) fn sine(cosine: f64) -> f64 {
    (1.0 - cosine * cosine).max(0.0).sqrt().max(LEAST_RISE)
}

impl<const D: usize> Normals<D> {
    /// Finds them where the colour or that of a node beside is within `bounds`. `wall` is empty without walls.
    pub fn find(
        &mut self,
        mesh: &Mesh<D>,
        colour: &[f64],
        wall: &[f64],
        facing: &Facing<D>,
        bounds: [f64; 2],
    ) {
        let stencil = mesh.gradient_stencil();
        let (nodes, inner) = (mesh.nodes_per_task(), mesh.inner());
        let near = |c: f64| c > bounds[0] && c < bounds[1];
        let direction = |i: usize| {
            let beside =
                (0..D).any(|axis| (mesh.beside(i, axis).map(|j| colour[j]).into_iter()).any(near));
            if !(beside || near(colour[i])) {
                return (Vector::ZERO, Vector::ZERO);
            }
            let mut gradient = Vector::ZERO;
            for (away, weight) in &stencil {
                gradient += *weight * colour[i.wrapping_add_signed(*away)];
            }
            let Some(&wall_colour) = wall.get(i).filter(|&&wall| wall > TRACE) else {
                return (gradient, Vector::ZERO);
            };
            let length = gradient.norm();
            let towards = facing.into(i);
            let part = gradient.dot(&towards);
            if length == 0.0 {
                return (gradient, Vector::ZERO);
            }
            let more = 1.0 / upright(wall_colour.min(LAST)) - 1.0;
            let true_way = gradient + towards * (more * part);
            (unit(true_way) * length, unit(gradient))
        };
        self.normal.resize(mesh.len(), Vector::ZERO);
        self.apparent.resize(mesh.len(), Vector::ZERO);
        let parts = (self.normal.par_chunks_mut(nodes)).zip(self.apparent.par_chunks_mut(nodes));
        parts.enumerate().for_each(|(task, (normal, apparent))| {
            for (k, (normal, apparent)) in normal.iter_mut().zip(apparent).enumerate() {
                let i = task * nodes + k;
                (*normal, *apparent) = match inner.contains(&i) {
                    true => direction(i),
                    false => (Vector::ZERO, Vector::ZERO),
                };
            }
        });
        self.beside.clear();
        (self.beside).extend(wall.iter().map(|wall| (wall / BESIDE).min(1.0)));
        if !wall.is_empty() {
            self.lift(mesh, wall);
        }
    }

    /// Gives nodes at a wall and behind it the direction of those before it.
    fn lift(&mut self, mesh: &Mesh<D>, wall: &[f64]) {
        let (nodes, inner) = (mesh.nodes_per_task(), mesh.inner());
        let around: Vec<isize> = mesh.around_node().collect();
        let normal = &self.normal;
        self.lifted.clear();
        (self.lifted).extend((normal.iter().zip(wall)).map(|(n, &wall)| unit(*n) * own(wall)));
        for _ in 0..ROWS {
            self.before.clone_from(&self.lifted);
            let before = &self.before;
            (self.lifted.par_chunks_mut(nodes).enumerate()).for_each(|(task, lifted)| {
                for (k, lifted) in lifted.iter_mut().enumerate() {
                    let i = task * nodes + k;
                    let own = own(wall[i]);
                    if own == 1.0 || normal[i] == Vector::ZERO || !inner.contains(&i) {
                        continue;
                    }
                    let (mut sum, mut known) = (Vector::ZERO, 0.0);
                    for away in &around {
                        let other = before[i.wrapping_add_signed(*away)];
                        sum += other;
                        known += other.norm();
                    }
                    let way = unit(normal[i]) * own + unit(sum) * (1.0 - own);
                    // Known in full beside a flat row of nodes that are.
                    let known = (known / 3_f64.powi(D as i32 - 1)).min(1.0);
                    *lifted = unit(way) * own.max((1.0 - own) * known);
                }
            });
        }
        for (normal, lifted) in self.normal.iter_mut().zip(&self.lifted) {
            if *lifted != Vector::ZERO {
                *normal = unit(*lifted) * normal.norm();
            }
        }
    }

    /// |grad c|, 1/dx.
    pub fn slope(&self, node: usize) -> f64 {
        self.normal[node].norm()
    }

    /// n; zero where there is none.
    pub fn unit(&self, node: usize) -> Vector<f64, D> {
        unit(self.normal[node])
    }

    /// Which way a level set faces.
    pub fn level(&self, node: usize) -> Vector<f64, D> {
        let bent = self.apparent[node];
        if bent == Vector::ZERO {
            unit(self.normal[node])
        } else {
            bent
        }
    }

    /// div n along the true surface, 1/dx.
    ///
    /// Where level sets are bent, n is not their normal, and its divergence has a part of what changes from one to the next.
    /// So n's change along a level set, rising with the wall's normal, is taken for that along the true surface that rises as
    /// far, and its change across that, along the contact line, for what it is.
    pub fn divergence(&self, mesh: &Mesh<D>, facing: &Facing<D>, node: usize) -> f64 {
        let mut change = [Vector::ZERO; D];
        for (axis, change) in change.iter_mut().enumerate() {
            let [before, after] = mesh.beside(node, axis);
            *change = (self.unit(after) - self.unit(before)) * 0.5;
        }
        let divergence = (0..D).map(|axis| change[axis][axis]).sum();
        let bent = self.apparent[node];
        if bent == Vector::ZERO {
            return divergence;
        }
        let part = |way: Vector<f64, D>| -> f64 {
            (0..D).map(|axis| way[axis] * way.dot(&change[axis])).sum()
        };
        let towards = facing.into(node);
        let n = self.unit(node);
        let cosine = bent.dot(&towards);
        let rising = part(unit(towards - bent * cosine));
        let along = divergence - part(bent) - rising;
        let stretch = sine(n.dot(&towards)) / sine(cosine) / n.dot(&bent).max(LEAST_RISE);
        along + rising * (1.0 + self.beside[node] * (stretch - 1.0))
    }

    /// How far a level set rises along the wall's normal, over its own length: of the surface far from walls,
    /// its length.
    pub fn rise(&self, facing: &Facing<D>, node: usize) -> f64 {
        let bent = self.apparent[node];
        if bent == Vector::ZERO {
            return 1.0;
        }
        let towards = facing.into(node);
        1.0 - self.beside[node] * (1.0 - sine(bent.dot(&towards)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The variance of a normal distribution that is cut off: in the middle, 1 - 2 / pi.
    #[test]
    fn a_distribution_that_is_cut_off_is_narrower() {
        let half = 1.0 - 2.0 / std::f64::consts::PI;
        assert!((upright(0.5) - half).abs() < 0.008);
        // h = phi(y) / (1 - C_w) with y = 1 and 2, from tables of the normal distribution.
        for (y, beyond, density) in [(1.0, 0.158_655, 0.241_971), (2.0, 0.022_750, 0.053_991)] {
            let h: f64 = density / (1.0 - beyond);
            assert!((upright(beyond) - (1.0 - h * (h + y))).abs() < 0.008, "{y}");
        }
        assert!(upright(0.0) == 1.0);
    }
}
