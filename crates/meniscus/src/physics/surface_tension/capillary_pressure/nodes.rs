//! Curvature of the surface, on the nodes of a mesh of spacing dx. With the volume V0 of a particle in cells, B
//! the cubic B-spline of the mesh, S two passes of (1/4, 1/2, 1/4):
//!
//! - C = S sum_j V0 B(x - x_j), and of the walls C_w; c = C / (1 - C_w)       colour, 1 inside
//! - n = grad c / |grad c|, with the gradient of the cubic spline through c
//! - g = 30/0.6^5 ((c - 0.2)(0.8 - c))^2 |grad c| between 0.2 and 0.8, zero else: of integral one through the surface
//! - kappa_0 = S [g s div(-n)] / S [g s]
//! - kappa_1 = kappa_0 + f (kappa_0 - S [g s kappa_0] / S [g s]), less b kappa_1^3 dx^2 / (D - 1)^2
//! - kappa = kappa_1 + l S [g |grad s| (cos(phi) - cos(theta))] / S [g s]
//!
//! where s falls from 1 to 0 through the surface of a wall, and phi is the angle at which n meets it. The divergence
//! is that of unit vectors, not of second derivatives of c: these are mostly such across the surface, of which one
//! hundredth in the wrong direction is all the curvature there is.
//!
//! The line of kappa_1 undoes what spreading, smoothing and differences take: a ripple loses k^2 v / 2 by a variance v
//! of 3.5 dx^2 in all (spline 1/3, passes 1 and 1, gradient, divergence and interpolation 1/3 each, and the extension), and
//! one smoothing more, of 1 dx^2, tells how much that is: f = 3.5. Smoothed, the level sets of a ball lie deeper than its surface, and
//! are more curved: b = 0.5 (exact discs of 7 and 14 dx: 0.49, 0.47).
//!
//! The last line is the derivative of the area of the surface and of the wet wall at their edge, which vanishes where phi
//! is Young's angle. It is not sharpened, or the pull of a contact line that starts far from its angle tears the liquid; since
//! the curvature beside it is, it counts l = 2 times, by drops of 12 dx at 60 and 120 degrees.
//!
//! Beyond the surface kappa goes on as in [`Mesh::fill`].

use rayon::prelude::*;

use super::super::mesh::{Fill, Layered, Mesh};
use super::order;
use crate::vector::Vector;

/// Passes of smoothing of the colour, and of the curvature.
const PASSES: usize = 2;
/// Nodes that a mesh reaches beyond its particles: colour reaches four. Beyond a periodic face there are more of them,
/// whose curvature is smoothed into that of the last.
pub(super) const MARGIN: i64 = 6;
pub(super) const PERIODIC_MARGIN: i64 = 13;
/// Colours between which the surface lies.
const SURFACE: [f64; 2] = [0.2, 0.8];
/// What colour at a node and its spline may differ by.
const LEEWAY: f64 = 0.05;
/// Slope of the colour below which it has no direction, 1/dx.
const LEAST_SLOPE: f64 = 0.02;
/// Colours of a wall between which it ends, about that of its surface.
const WALL: [f64; 2] = [0.3, 0.7];
/// Colour of a wall from which on nothing is divided by what it leaves.
const SOLID: f64 = 0.95;
/// f
const SHARPENING: f64 = 3.5;
/// b
const DEEPER: f64 = 0.5;
/// l
const CONTACT_LINE: f64 = 2.0;
/// Up to which squared curvature, 1/dx^2, that is taken to be so.
const MOST_CURVED: f64 = 0.04;
/// Weight of the surroundings in the extension of the curvature, beside that of the surface, up to 0.3.
const EXTENSION: f64 = 0.1;

/// Fields on the nodes, lengths in distances of nodes.
#[derive(Debug, Default)]
pub(super) struct Nodes<const D: usize> {
    /// c
    pub colour: Vec<f64>,
    /// kappa
    pub curvature: Vec<f64>,
    /// Of liquid and walls together, and smoothed more, where there are walls.
    filled: Vec<f64>,
    deep: Vec<f64>,
    wall: Vec<f64>,
    wetting: Vec<f64>,
    normal: Vec<Vector<f64, D>>,
    /// g s
    weight: Vec<f64>,
    pull: Vec<f64>,
    /// Where there are walls.
    line: Vec<f64>,
    smooth_weight: Vec<f64>,
    spare: Vec<f64>,
    fill: Fill<D>,
}

/// s, and minus its slope, of a wall's colour.
fn share(wall: f64) -> (f64, f64) {
    let width = WALL[1] - WALL[0];
    let u = ((wall - WALL[0]) / width).clamp(0.0, 1.0);
    (1.0 - u * u * (3.0 - 2.0 * u), 6.0 * u * (1.0 - u) / width)
}

fn ratio(sum: f64, weight: f64) -> f64 {
    if weight > 1e-9 { sum / weight } else { 0.0 }
}

impl<const D: usize> Nodes<D> {
    /// Finds colour and curvature.
    pub fn find(&mut self, mesh: &Mesh<D>, liquid: &mut Layered<D>, walls: &mut Layered<D>) {
        let walled = !walls.is_empty();
        let of_walls = if walled { mesh.len() } else { 0 };
        for (column, length) in [
            (&mut self.colour, mesh.len()),
            (&mut self.weight, mesh.len()),
            (&mut self.pull, mesh.len()),
            (&mut self.line, of_walls),
            (&mut self.filled, of_walls),
            (&mut self.deep, of_walls),
            (&mut self.wall, of_walls),
            (&mut self.wetting, of_walls),
        ] {
            column.clear();
            column.resize(length, 0.0);
        }
        let spare = &mut self.spare;
        mesh.spread(liquid, [&mut self.colour, &mut []]);
        mesh.smooth(&mut self.colour, spare, PASSES);
        if walled {
            mesh.spread(walls, [&mut self.wall, &mut self.wetting]);
            mesh.smooth(&mut self.wall, spare, PASSES);
            mesh.smooth(&mut self.wetting, spare, PASSES);
            let both = self.colour.iter().zip(&self.wall);
            for (filled, (colour, wall)) in self.filled.iter_mut().zip(both) {
                *filled = colour + wall;
            }
            self.deep.copy_from_slice(&self.filled);
            mesh.smooth(&mut self.deep, spare, order::PASSES);
            for (colour, wall) in self.colour.iter_mut().zip(&self.wall) {
                *colour /= 1.0 - wall.min(SOLID);
            }
        }
        self.find_normals(mesh);
        self.weigh(mesh);
        self.average(mesh);
    }

    /// The colour of liquid and walls together, as it is and smoothed more; none without walls.
    pub fn filled(&self) -> Option<[&[f64]; 2]> {
        (!self.filled.is_empty()).then_some([&self.filled, &self.deep])
    }

    /// n, at the surface and one node around.
    fn find_normals(&mut self, mesh: &Mesh<D>) {
        let (colour, stencil) = (&self.colour, mesh.gradient_stencil());
        let (nodes, inner) = (mesh.nodes_per_task(), mesh.inner());
        let near = |c: f64| c > SURFACE[0] - LEEWAY && c < SURFACE[1] + LEEWAY;
        let direction = |i: usize| {
            let beside = (0..D).any(|axis| {
                mesh.beside(i, axis)
                    .map(|j| colour[j])
                    .into_iter()
                    .any(near)
            });
            if !(beside || near(colour[i])) {
                return Vector::ZERO;
            }
            let mut gradient = Vector::ZERO;
            for (away, weight) in &stencil {
                gradient += *weight * colour[i.wrapping_add_signed(*away)];
            }
            gradient
        };
        self.normal.resize(mesh.len(), Vector::ZERO);
        (self.normal.par_chunks_mut(nodes).enumerate()).for_each(|(task, normal)| {
            for (k, normal) in normal.iter_mut().enumerate() {
                let i = task * nodes + k;
                *normal = if inner.contains(&i) {
                    direction(i)
                } else {
                    Vector::ZERO
                };
            }
        });
    }

    /// The surface, its curvature times that, and the contact line.
    fn weigh(&mut self, mesh: &Mesh<D>) {
        let Self {
            colour,
            normal,
            wall,
            wetting,
            weight,
            pull,
            line,
            ..
        } = self;
        let (colour, normal, wall, wetting) = (&*colour, &*normal, &*wall, &*wetting);
        let (nodes, inner) = (mesh.nodes_per_task(), mesh.inner());
        let sharpest = D as f64 - 1.0;
        let unit =
            |gradient: Vector<f64, D>| gradient * (1.0 / gradient.norm().max(f64::MIN_POSITIVE));
        let surface = |i: usize| {
            let c = colour[i];
            let slope = normal[i].norm();
            if !inner.contains(&i) || c <= SURFACE[0] || c >= SURFACE[1] || slope < LEAST_SLOPE {
                return None;
            }
            let bell = ((c - SURFACE[0]) * (SURFACE[1] - c)).powi(2);
            Some(30.0 / (SURFACE[1] - SURFACE[0]).powi(5) * bell * slope)
        };
        let curvature = |i: usize| {
            let mut divergence = 0.0;
            for axis in 0..D {
                let [before, after] = mesh.beside(i, axis);
                divergence += 0.5 * (unit(normal[after])[axis] - unit(normal[before])[axis]);
            }
            (-divergence).clamp(-sharpest, sharpest)
        };
        let parts = weight.par_chunks_mut(nodes).zip(pull.par_chunks_mut(nodes));
        parts.enumerate().for_each(|(task, (weight, pull))| {
            for (k, (weight, pull)) in weight.iter_mut().zip(pull).enumerate() {
                let i = task * nodes + k;
                if let Some(surface) = surface(i) {
                    *weight = surface * wall.get(i).map_or(1.0, |&wall| share(wall).0);
                    *pull = *weight * curvature(i);
                }
            }
        });
        (line.par_chunks_mut(nodes).enumerate()).for_each(|(task, line)| {
            for (k, line) in line.iter_mut().enumerate() {
                let i = task * nodes + k;
                let falls = share(wall[i]).1;
                if let Some(surface) = surface(i).filter(|_| falls > 0.0) {
                    let towards = mesh.difference(wall, i);
                    let met = unit(normal[i]).dot(&unit(towards));
                    *line = surface * falls * towards.norm() * (met - wetting[i] / wall[i]);
                }
            }
        });
    }

    /// kappa, everywhere.
    fn average(&mut self, mesh: &Mesh<D>) {
        let spare = &mut self.spare;
        self.smooth_weight.clone_from(&self.weight);
        mesh.smooth(&mut self.smooth_weight, spare, PASSES);
        mesh.smooth(&mut self.pull, spare, PASSES);
        let weights = self.weight.iter().zip(&self.smooth_weight);
        self.curvature.clear();
        (self.curvature).extend(
            (self.pull.iter().zip(weights.clone())).map(|(sum, (_, weight))| ratio(*sum, *weight)),
        );
        let rough = &mut self.pull;
        for ((rough, curvature), weight) in rough.iter_mut().zip(&self.curvature).zip(&self.weight)
        {
            *rough = weight * curvature;
        }
        mesh.smooth(rough, spare, PASSES);
        let smoothed = self.pull.iter().zip(&self.smooth_weight);
        for (curvature, (sum, weight)) in self.curvature.iter_mut().zip(smoothed) {
            *curvature += SHARPENING * (*curvature - ratio(*sum, *weight));
            let of_each = (*curvature / (D as f64 - 1.0)).powi(2);
            *curvature -= *curvature * DEEPER * of_each.min(MOST_CURVED);
        }
        if !self.line.is_empty() {
            mesh.smooth(&mut self.line, spare, PASSES);
            let lines = self.line.iter().zip(&self.smooth_weight);
            for (curvature, (sum, weight)) in self.curvature.iter_mut().zip(lines) {
                *curvature += CONTACT_LINE * ratio(*sum, *weight);
            }
        }
        mesh.fill(
            &mut self.curvature,
            &self.smooth_weight,
            EXTENSION,
            &mut self.fill,
        );
    }
}
