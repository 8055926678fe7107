//! What walls bear of forces that act on the liquid by fields on the mesh: their own push, and the pull of contact lines.
//!
//! A force F on liquid at x comes back on the particles of the wall that make up its colour there, each by its share of
//! C_w(x); so it does from nodes. On a contact line, the edge of the surface where s falls from 1 to 0, the wall pulls by what
//! q there comes to,
//!
//! g (-grad s + (l - n . -grad s) n),   l the contact line's part of kappa as in [`nodes`](super::nodes), without smoothing
//!
//! times sigma: at rest the tangential force of the surface, sigma sin(theta) along the wall's normal.

use super::super::mesh::Mesh;
use super::nodes::PASSES;
use crate::vector::Vector;

/// Forces of the wall on the liquid, over its colour, N (N/m in 2D), at nodes.
#[derive(Debug, Default)]
pub(super) struct Reaction<const D: usize> {
    nodes: Vec<Vector<f64, D>>,
    spare: Vec<Vector<f64, D>>,
    any: bool,
}

impl<const D: usize> Reaction<D> {
    /// Starts with the forces on contact lines, sigma dx^(D - 2), `unit` in N.
    pub fn start(&mut self, lines: &[Vector<f64, D>], wall: &[f64], unit: f64) {
        self.any = false;
        self.nodes.clear();
        self.nodes.resize(lines.len(), Vector::ZERO);
        for ((node, line), wall) in self.nodes.iter_mut().zip(lines).zip(wall) {
            if *line != Vector::ZERO {
                *node = *line * (unit / wall);
                self.any = true;
            }
        }
    }

    /// Adds a force (N) on liquid at `x`, where the wall has this colour.
    pub fn add(&mut self, mesh: &Mesh<D>, x: &Vector<f64, D>, force: Vector<f64, D>, wall: f64) {
        mesh.spread_at(&mut self.nodes, x, force * (1.0 / wall));
        self.any = true;
    }

    /// Hands it over to walls; whether there is any.
    pub fn finish(&mut self, mesh: &Mesh<D>) -> bool {
        if self.any {
            mesh.smooth(&mut self.nodes, &mut self.spare, PASSES);
        }
        self.any
    }

    /// The force on a particle of a wall, N.
    pub fn on_wall(&self, mesh: &Mesh<D>, x: &Vector<f64, D>) -> Vector<f64, D> {
        mesh.feel_vector_at(&self.nodes, x) * -1.0
    }
}
