//! What the fluid exerts on walls.

use super::Walls;
use crate::particles::Particles;
use crate::simulation::Simulation;
use crate::vector::Vector;

/// What the fluid exerts on one wall.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WallLoad {
    /// Force, N; in 2D N/m, the third component zero.
    pub force: [f64; 3],
    /// Moment about the origin of coordinates, N m; in 2D N, the third component alone.
    pub moment: [f64; 3],
}

impl<const D: usize> Walls<D> {
    /// Takes what pairs exert on wall particles from their accelerations to the loads.
    pub(crate) fn bear(&mut self, particles: &Particles<D>, acceleration: &mut [Vector<f64, D>]) {
        for &row in &self.rows {
            let row = row as usize;
            let Some(wall) = self.wall_of(particles, row) else {
                continue;
            };
            let a = std::mem::take(&mut acceleration[row]);
            let force = (a * particles.mass[row]).to_3d();
            let x = particles.position[row].to_3d();
            if let Some(moved) = self.moved(particles, row, self.time) {
                self.power -= particles.mass[row] * a.dot(&moved.velocity);
            }
            let load = &mut self.loads[wall];
            for d in 0..3 {
                let (e, f) = ((d + 1) % 3, (d + 2) % 3);
                load.force[d] += force[d];
                load.moment[d] += x[e] * force[f] - x[f] * force[e];
            }
        }
    }
}

impl<const D: usize> Simulation<D> {
    /// What the fluid exerted on each wall in the last step, in the order of the scheme's
    /// walls; zero before the first step of a restored simulation.
    pub fn wall_loads(&self) -> &[WallLoad] {
        &self.rates.walls.loads
    }

    /// Whether a body is a wall.
    pub fn is_wall(&self, body: u16) -> bool {
        self.rates.walls.is_wall(body)
    }
}
