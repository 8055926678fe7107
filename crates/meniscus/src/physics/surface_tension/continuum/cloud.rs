//! The particles at the surface, as a set of their own.
//!
//! Curvature is summed over particles with N = 1 alone, over a longer range
//! than all else. Lists of that range for all particles would cost several
//! times what the rest of a step does; of those at the surface, made anew for each step,
//! they cost little.

use crate::particles::Particles;
use crate::vector::Vector;

/// Finds the neighbours of a new set of particles.
pub trait Relist<const D: usize> {
    /// Sorts the particles, and finds their neighbours anew.
    fn relist(&mut self, particles: &mut Particles<D>);
}

/// Particles with N = 1.
#[derive(Debug, Default)]
pub(super) struct Cloud<const D: usize> {
    /// Their number is their row among all.
    particles: Particles<D>,
    normal: Vec<Vector<f64, D>>,
}

impl<const D: usize> Cloud<D> {
    /// Gathers the particles whose normal is no shorter than `shortest` (1/m).
    pub(super) fn gather(
        &mut self,
        lists: &mut impl Relist<D>,
        all: &Particles<D>,
        normal: &[Vector<f64, D>],
        shortest: f64,
    ) {
        let Particles {
            position,
            velocity,
            acceleration,
            density,
            pressure,
            curvature: _,
            temperature: _,
            heating: _,
            heating_gain: _,
            mass,
            smoothing_length,
            fluid,
            body,
            id,
        } = &mut self.particles;
        id.clear();
        let reliable = |i: &u32| {
            let length = normal[*i as usize].norm();
            length >= shortest && length > 0.0
        };
        id.extend((0..all.len() as u32).filter(reliable));
        for vectors in [&mut *velocity, &mut *acceleration] {
            vectors.resize(id.len(), Vector::ZERO);
        }
        pressure.resize(id.len(), 0.0);
        for indices in [fluid, body] {
            indices.resize(id.len(), 0);
        }
        let rows = || id.iter().map(|&i| i as usize);
        position.clear();
        position.extend(rows().map(|i| all.position[i]));
        for (column, of_all) in [
            (density, &all.density),
            (mass, &all.mass),
            (smoothing_length, &all.smoothing_length),
        ] {
            column.clear();
            column.extend(rows().map(|i| of_all[i]));
        }
        lists.relist(&mut self.particles);
        self.normal.clear();
        (self.normal).extend(self.particles.id.iter().map(|&i| normal[i as usize]));
    }

    pub(super) fn len(&self) -> usize {
        self.particles.len()
    }

    pub(super) fn particles(&self) -> &Particles<D> {
        &self.particles
    }

    /// n of each, 1/m.
    pub(super) fn normal(&self) -> &[Vector<f64, D>] {
        &self.normal
    }

    /// Writes `value` of each particle's sum to its row among all.
    pub(super) fn scatter<S>(&self, sums: &[S], to: &mut [f64], value: impl Fn(&S) -> f64) {
        for (&row, sum) in self.particles.id.iter().zip(sums) {
            to[row as usize] = value(sum);
        }
    }
}
