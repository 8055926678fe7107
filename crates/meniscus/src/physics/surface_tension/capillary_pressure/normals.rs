//! Which way the surface faces, at nodes.
//!
//! Before a wall the colour c = C / (1 - C_w) is a mean over that part of the spread that lies before the wall. A surface
//! that meets the wall under an angle is so bent upright: with the spread a normal distribution of variance v that is cut off
//! at the wall, a straight surface x(z) has the mean m(z), and m'(z) / x'(z) is the variance of the cut distribution over v,
//!
//! r = 1 - h (h + y),   h = exp(-y^2 / 2) / (sqrt(2 pi) (1 - C_w)),   with y such that C_w is the distribution's part beyond it
//!
//! (0.84, 0.59 and 0.36 where C_w = 0.04, 0.19 and 0.5). So the part of grad c towards the wall is divided by r. From C_w = 1/4 on,
//! where c is a small difference of what particles of the first two rows spread, nodes take the direction of those before them.
//!
//! Level sets stay bent. What is to be summed along the wall's normal takes their own rise there (`rise`), and what changes along the
//! true surface does so over a longer way (`stretch`).

use rayon::prelude::*;

use super::super::mesh::Mesh;
use crate::vector::Vector;

/// Colour of a wall above which it is there.
const TRACE: f64 = 1e-6;
/// Colours of a wall from which on nodes take the direction of those before them, those of the first row and of the second.
const LIFTED: [f64; 3] = [0.25, 0.65, 0.95];
/// Colour of a wall from which on it is beside the surface in full.
const BESIDE: f64 = 0.02;
/// Least sine of the angle at which a surface meets a wall, where something is divided by it.
const LEAST_RISE: f64 = 0.1;

/// The directions.
#[derive(Debug, Default)]
pub(super) struct Normals<const D: usize> {
    /// Of the length of grad c, at the surface and one node around, zero else.
    normal: Vec<Vector<f64, D>>,
    /// Cosine of the angle of grad c itself to the wall's normal.
    apparent: Vec<f64>,
    /// 0 far from walls, 1 beside them.
    beside: Vec<f64>,
    before: Vec<Vector<f64, D>>,
}

/// r, by a polynomial within 0.008.
fn upright(wall: f64) -> f64 {
    let root = wall.sqrt();
    1.0 - root * (0.4801 + root * (2.3022 + root * (-3.6808 + root * 1.7882)))
}

fn unit<const D: usize>(vector: Vector<f64, D>) -> Vector<f64, D> {
    vector * (1.0 / vector.norm().max(f64::MIN_POSITIVE))
}

fn sine(cosine: f64) -> f64 {
    (1.0 - cosine * cosine).max(0.0).sqrt().max(LEAST_RISE)
}

impl<const D: usize> Normals<D> {
    /// Finds them where the colour or that of a node beside is within `bounds`. `wall` is empty without walls.
    pub fn find(&mut self, mesh: &Mesh<D>, colour: &[f64], wall: &[f64], bounds: [f64; 2]) {
        let stencil = mesh.gradient_stencil();
        let (nodes, inner) = (mesh.nodes_per_task(), mesh.inner());
        let near = |c: f64| c > bounds[0] && c < bounds[1];
        let direction = |i: usize| {
            let beside =
                (0..D).any(|axis| (mesh.beside(i, axis).map(|j| colour[j]).into_iter()).any(near));
            if !(beside || near(colour[i])) {
                return (Vector::ZERO, 0.0);
            }
            let mut gradient = Vector::ZERO;
            for (away, weight) in &stencil {
                gradient += *weight * colour[i.wrapping_add_signed(*away)];
            }
            let Some(&wall_colour) = wall.get(i).filter(|&&wall| wall > TRACE) else {
                return (gradient, 0.0);
            };
            let length = gradient.norm();
            let towards = unit(mesh.difference(wall, i));
            let part = gradient.dot(&towards);
            if length == 0.0 {
                return (gradient, 0.0);
            }
            let more = 1.0 / upright(wall_colour.min(LIFTED[0])) - 1.0;
            let true_way = gradient + towards * (more * part);
            (unit(true_way) * length, part / length)
        };
        self.normal.resize(mesh.len(), Vector::ZERO);
        self.apparent.resize(mesh.len(), 0.0);
        let parts = (self.normal.par_chunks_mut(nodes)).zip(self.apparent.par_chunks_mut(nodes));
        parts.enumerate().for_each(|(task, (normal, apparent))| {
            for (k, (normal, apparent)) in normal.iter_mut().zip(apparent).enumerate() {
                let i = task * nodes + k;
                (*normal, *apparent) = match inner.contains(&i) {
                    true => direction(i),
                    false => (Vector::ZERO, 0.0),
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
        let around = mesh.around_node();
        for row in LIFTED.windows(2) {
            self.before.clone_from(&self.normal);
            let before = &self.before;
            (self.normal.par_chunks_mut(nodes).enumerate()).for_each(|(task, normal)| {
                for (k, normal) in normal.iter_mut().enumerate() {
                    let i = task * nodes + k;
                    let length = normal.norm();
                    let behind = wall[i] > row[0] && wall[i] <= row[1];
                    if length == 0.0 || !behind || !inner.contains(&i) {
                        continue;
                    }
                    let others = around.iter().map(|away| i.wrapping_add_signed(*away));
                    let mut sum = Vector::ZERO;
                    for j in others.filter(|&j| wall[j] <= row[0]) {
                        sum += before[j];
                    }
                    if sum.norm() > 0.0 {
                        *normal = unit(sum) * length;
                    }
                }
            });
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

    /// div n, 1/dx.
    pub fn divergence(&self, mesh: &Mesh<D>, node: usize) -> f64 {
        let along = |axis: usize| {
            let [before, after] = mesh.beside(node, axis);
            0.5 * (self.unit(after)[axis] - self.unit(before)[axis])
        };
        (0..D).map(along).sum()
    }

    /// How far a level set rises along the wall's normal, over its own length: of the surface far from walls,
    /// its length.
    pub fn rise(&self, node: usize) -> f64 {
        let beside = self.beside.get(node).unwrap_or(&0.0);
        1.0 - beside * (1.0 - sine(self.apparent[node]))
    }

    /// The length of a level set over that of the true surface that rises as far.
    pub fn stretch(&self, mesh: &Mesh<D>, wall: &[f64], node: usize) -> f64 {
        match self.beside.get(node) {
            Some(&beside) if wall[node] > TRACE => {
                let towards = unit(mesh.difference(wall, node));
                let true_rise = sine(self.unit(node).dot(&towards));
                1.0 + beside * (true_rise / sine(self.apparent[node]) - 1.0)
            }
            _ => 1.0,
        }
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
