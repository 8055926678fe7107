//! Particles of a liquid beside walls are put in order, where capillary pressure asks for it.

use super::Rates;
use crate::particles::Particles;
use crate::physics::surface_tension::capillary_pressure::{
    MeanShift, Order, STEPS_BETWEEN, Shifted, Widening,
};
use crate::scheme::DensityForm;
use crate::term::Sweep;
use crate::vector::Vector;

/// Columns on the way.
#[derive(Debug, Default)]
pub(super) struct Shifts<const D: usize> {
    shifts: Vec<Vector<f64, D>>,
    around: Vec<Shifted<f64, D>>,
    widening: Vec<(f64, f64)>,
}

impl<const D: usize> Rates<D> {
    /// Shifts particles, and changes their density by it where it is by continuity, once in [`STEPS_BETWEEN`] of the `steps` since
    /// the start: the last one's `dt` (s) stands for all. After the forces of a step, in whose order of rows it knows places.
    pub(crate) fn put_in_order(&mut self, particles: &mut Particles<D>, steps: u64, dt: f64) {
        let Some(surface_tension) = self.capillary_tension() else {
            return;
        };
        if self.walls.is_empty() || !steps.is_multiple_of(STEPS_BETWEEN) {
            return;
        }
        let density = self.fluids[0].density;
        let order = Order::new::<D>(surface_tension, density, self.spacing);
        let surface = &self.surface;
        let Shifts {
            shifts,
            around,
            widening,
        } = &mut self.shifts;
        let Some(near) = self.pairs.second() else {
            return;
        };
        let minds = |rows| Order::is_beside_wall(surface, rows);
        near.sweep(&order, particles, minds, shifts);
        let time = STEPS_BETWEEN as f64 * dt;
        for (row, shift) in shifts.iter_mut().enumerate() {
            let speed = particles.velocity[row].norm();
            *shift = order.shift(surface, row, *shift, speed, time);
        }
        (self.pairs).sweep(&MeanShift { shifts }, particles, minds, around);
        let walls = self.walls.bodies();
        let widened = Widening { around, walls };
        (self.pairs).sweep(&widened, particles, minds, widening);
        let by_continuity = self.scheme.density != DensityForm::Summation;
        for (row, (shift, sums)) in shifts.iter().zip(widening).enumerate() {
            if !self.walls.is_wall(particles.body[row]) {
                particles.position[row] += *shift;
                if by_continuity {
                    particles.density[row] *= Widening::<D>::thinned(*sums);
                }
            }
        }
    }
}
