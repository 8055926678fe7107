//! What walls do to the density of the fluid, and what they do not do at its edge.

use super::Walls;
use crate::pairs::Pairs;
use crate::particles::Particles;
use crate::physics::wall::{Edge, Shared};
use crate::term::Sweep;
use crate::vector::Vector;

impl<const D: usize> Walls<D> {
    /// Completes the rates that continuity has found, 1/s, by what walls do to the fluid: those that pull on it
    /// whatever their pressure, and but for what moves along them at its edge.
    pub(crate) fn compress(
        &mut self,
        pairs: &mut Pairs<D>,
        particles: &Particles<D>,
        pull: bool,
        rates: &mut [f64],
    ) {
        if self.is_empty() {
            return;
        }
        self.look(pairs, particles);
        let mut compression = std::mem::take(&mut self.compression);
        let time = self.time + 0.5 * self.step;
        let of_wall = |row: usize, rate: f64| {
            let weight = self.sums[row].weight;
            if weight <= 0.0 || !(pull || particles.pressure[row] > 0.0) {
                return None;
            }
            let edge = self.edge(particles, row, time).filter(|_| pull);
            let passing = edge.map_or(0.0, |edge| edge.passing(particles.velocity[row]));
            Some((rate + passing) / weight)
        };
        let touches = |rows| self.may_touch(particles, rows);
        compression.complete(pairs, particles, &self.rows, touches, of_wall, rates);
        self.compression = compression;
    }

    /// The edge of the fluid at a row of a wall, as of the last look.
    fn edge(&self, particles: &Particles<D>, row: usize, time: f64) -> Option<Edge<D>> {
        let mut normal = self.normal[particles.id[row] as usize];
        if let Some(moved) = self.moved(particles, row, time) {
            let wall = &self.walls[self.wall_of(particles, row)?];
            let start = self.start[particles.id[row] as usize];
            normal = wall.motion.at(start + normal, time).position - moved.position;
        }
        Edge::new(&self.sums[row], normal)
    }

    /// Keeps the pressure of walls from what it does along them at the edge of the fluid: on the fluid in rows that
    /// `near` holds for, and on the walls.
    pub(crate) fn slide(
        &mut self,
        pairs: &mut Pairs<D>,
        particles: &Particles<D>,
        near: impl Fn(std::ops::Range<usize>) -> bool + Sync,
        acceleration: &mut [Vector<f64, D>],
    ) {
        if self.is_empty() {
            return;
        }
        let mut kept = std::mem::take(&mut self.kept);
        kept.clear();
        kept.resize(particles.len(), Vector::ZERO);
        for &row in &self.rows {
            let row = row as usize;
            if let Some(edge) = self.edge(particles, row, self.time) {
                kept[row] = edge.kept(particles.pressure[row], particles.volume(row));
                acceleration[row] += kept[row] * (edge.weight() / particles.mass[row]);
            }
        }
        let mut shares = std::mem::take(&mut self.shares);
        pairs.sweep(&Shared { of: &kept }, particles, near, &mut shares);
        for (row, share) in shares.iter().enumerate() {
            if !self.is_wall(particles.body[row]) {
                acceleration[row] -= *share * (1.0 / particles.mass[row]);
            }
        }
        self.kept = kept;
        self.shares = shares;
    }
}
