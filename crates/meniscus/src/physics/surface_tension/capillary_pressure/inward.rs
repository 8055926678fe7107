//! kappa through the surface, inside and outside.
//!
//! - On the surface, c = 1/2, it is what is found there.
//! - Inside it is harmonic: what pressure is in a liquid that swings a little. So p - q has next to nothing left to do, and a drop at rest
//!   has one q all over. What else there is inside drives currents: lumps of 0.5 % below the surface, from disorder that the colour saw, kept drops of
//!   La = 12000 turning at 0.003 sqrt(sigma / (rho D)).
//! - Outside it is what is inside with its sign turned about the value at the surface, or the outermost particles would feel half a slope.
//!
//! For a node near the surface the closest point on it is x - z n, with z the depth that its colour has under a flat surface. Nodes outside keep
//! that point's kappa; inside the harmonic field ([`Harmonic`](crate::physics::surface_tension::mesh::Harmonic)) is tied to it where a link of
//! nodes is cut by the surface: a link of which a part t is inside is 1/t times as strong.
//!
//! At walls, where kappa changes steeply towards the contact line, nodes keep what was found at their place, whose sum along the surface is
//! what the line pulls; up to C_w = 0.1 they go over to that.

use rayon::prelude::*;

use super::super::mesh::{Harmonic, Mesh};
use super::nodes::{LEAST_SLOPE, OUTERMOST, depth};
use super::normals::Normals;
use crate::vector::Vector;

/// Colours between which a node looks for its closest point: as far out as particles feel, and half a spacing more than
/// links reach inside.
const NEAR: [f64; 2] = [OUTERMOST, 0.85];
/// Weight of the surface below which there is none at a closest point.
const LEAST_SURFACE: f64 = 0.05;
/// Colour of a wall from which on kappa is as found.
const AT_WALL: f64 = 0.1;
/// Links, beside the weight 1 of a node that is known: what is known stays within a tenth of their mean.
const LINK: f64 = 0.1;
/// Least part of a link that is inside.
const LEAST_PART: f64 = 0.1;
/// Cycles over the levels of the harmonic field.
const CYCLES: usize = 2;
/// Passes of mirroring: after the first, what is mirrored beside the surface is half mirrored itself.
const MIRRORED: usize = 2;

/// Columns on the way.
#[derive(Debug, Default)]
pub(super) struct Inward<const D: usize> {
    /// kappa of the closest points.
    closest: Vec<f64>,
    known: Vec<f64>,
    spare: Vec<f64>,
    harmonic: Harmonic<D>,
}

/// What is there on the surface.
pub(super) struct Found<'a, const D: usize> {
    pub colour: &'a [f64],
    pub normals: &'a Normals<D>,
    /// Colour of walls; empty without.
    pub wall: &'a [f64],
    /// How much of the surface is around, without that at walls.
    pub surface: &'a [f64],
}

impl<const D: usize> Found<'_, D> {
    /// The point that lies `times` as far from a node against the normal as the surface does.
    fn point(&self, mesh: &Mesh<D>, node: usize, times: f64) -> Option<Vector<f64, D>> {
        let colour = self.colour[node];
        let near = colour > NEAR[0] && colour < NEAR[1];
        if !near || self.normals.slope(node) < LEAST_SLOPE {
            return None;
        }
        let away = self.normals.level(node) * (times * depth(colour) * mesh.spacing);
        Some(mesh.place(node) - away).filter(|x| mesh.holds(x))
    }

    /// 0 away from walls, 1 at them.
    fn beside(&self, node: usize) -> f64 {
        (self.wall.get(node)).map_or(0.0, |wall| (wall / AT_WALL).min(1.0))
    }

    /// How strongly a node is tied to what is at its closest point.
    fn tie(&self, mesh: &Mesh<D>, node: usize, link: f64) -> f64 {
        let own = self.colour[node] - 0.5;
        if own < 0.0 {
            return 1.0;
        }
        let mut tie = 0.0;
        for axis in 0..D {
            for other in mesh.beside(node, axis) {
                let other = self.colour[other] - 0.5;
                if other < 0.0 {
                    tie += link * (1.0 / (own / (own - other)).max(LEAST_PART) - 1.0);
                }
            }
        }
        tie
    }
}

impl<const D: usize> Inward<D> {
    /// Makes kappa that is known near the surface what it is to be everywhere.
    pub fn go_on(&mut self, mesh: &Mesh<D>, found: &Found<'_, D>, curvature: &mut [f64]) {
        let link = LINK / (2 * D) as f64;
        let (nodes, inner) = (mesh.nodes_per_task(), mesh.inner());
        for column in [&mut self.closest, &mut self.known, &mut self.spare] {
            column.resize(mesh.len(), 0.0);
        }
        let of = &*curvature;
        let parts = (self.closest.par_chunks_mut(nodes)).zip(self.known.par_chunks_mut(nodes));
        parts.enumerate().for_each(|(task, (closest, known))| {
            for (k, (closest, known)) in closest.iter_mut().zip(known).enumerate() {
                let i = task * nodes + k;
                let beside = found.beside(i);
                let point = found.point(mesh, i, 1.0).filter(|x| {
                    inner.contains(&i) && found.surface[mesh.nearest(x)] > LEAST_SURFACE
                });
                (*closest, *known) = match point {
                    Some(x) if beside < 1.0 => (
                        of[i] + (1.0 - beside) * (mesh.feel_at(of, &x).0 - of[i]),
                        beside * found.surface[i] + (1.0 - beside) * found.tie(mesh, i, link),
                    ),
                    Some(_) => (of[i], found.surface[i]),
                    None => (of[i], beside * found.surface[i]),
                };
            }
        });
        curvature.copy_from_slice(&self.closest);
        mesh.make_harmonic(curvature, &self.known, link, CYCLES, &mut self.harmonic);
        for _ in 0..MIRRORED {
            self.spare.copy_from_slice(curvature);
            let (from, closest, known) = (&self.spare, &self.closest, &self.known);
            let parts = curvature.par_chunks_mut(nodes).enumerate();
            parts.for_each(|(task, curvature)| {
                for (k, curvature) in curvature.iter_mut().enumerate() {
                    let i = task * nodes + k;
                    let beside = found.beside(i);
                    if found.colour[i] >= 0.5 || known[i] == 0.0 || beside == 1.0 {
                        continue;
                    }
                    if let Some(x) = found.point(mesh, i, 2.0) {
                        let mirrored = 2.0 * closest[i] - mesh.feel_at(from, &x).0;
                        *curvature += (1.0 - beside) * (mirrored - *curvature);
                    }
                }
            });
        }
    }
}
