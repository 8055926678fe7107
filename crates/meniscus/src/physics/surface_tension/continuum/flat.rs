//! A flat layer of liquid, or flat layers of two, to measure on it what the
//! force on a flat surface adds up to.

use super::Surroundings;
use crate::particles::{Particle, Particles};
use crate::vector::Vector;

/// A layer on a square or cubic lattice: one row of particles along the last
/// axis, which repeats itself one spacing away along the others.
#[derive(Clone, Debug)]
pub struct FlatLayer<const D: usize> {
    /// Its particles, at rest density.
    pub particles: Particles<D>,
    /// (low, high) in metres of each periodic axis.
    pub periodic: [Option<(f64, f64)>; D],
    /// Area of its surfaces in all, m^(D-1).
    area: f64,
    /// Of the whole, m.
    height: f64,
}

impl<const D: usize> FlatLayer<D> {
    /// A layer with a free surface at either end; or where one fluid has
    /// surface tension and another has none, layers of both in turn. They are so thick
    /// that what one surface does ends before the other's: `support` is the radius of the
    /// kernel's support, m.
    pub fn new(surroundings: Surroundings<'_>, support: f64, spacing: f64) -> Self {
        let fluids = surroundings.fluids;
        let find = |inside: bool| {
            let found = fluids
                .iter()
                .position(|fluid| (fluid.surface_tension > 0.0) == inside);
            found.unwrap_or(0)
        };
        let (inner, outer) = (find(true), find(false));
        // Colour changes within one support of a surface, its gradient within two.
        let rows = 2 * (2.0 * support / spacing).ceil() as usize + 1;
        let interface = surroundings.has_interface();
        let all = if interface { 2 * rows } else { rows };
        let start: Vec<Particle<D>> = (0..all)
            .map(|row| {
                let fluid = if row < rows { inner } else { outer };
                let mut position = Vector([0.5 * spacing; D]);
                position[D - 1] += row as f64 * spacing;
                Particle {
                    position,
                    velocity: Vector::ZERO,
                    mass: fluids[fluid].density * spacing.powi(D as i32),
                    fluid: fluid as u16,
                    body: 0,
                }
            })
            .collect();
        let mut particles = Particles::new(&start);
        for i in 0..all {
            particles.density[i] = fluids[particles.fluid[i] as usize].density;
        }
        let mut periodic = [Some((0.0, spacing)); D];
        periodic[D - 1] = interface.then_some((0.0, all as f64 * spacing));
        Self {
            particles,
            periodic,
            height: all as f64 * spacing,
            area: 2.0 * spacing.powi(D as i32 - 1),
        }
    }

    /// The sum of `value` V over the area, for particles whose row it is given.
    pub(super) fn integral(&self, value: impl Fn(usize) -> f64) -> f64 {
        let rows = 0..self.particles.len();
        rows.map(|i| value(i) * self.particles.volume(i))
            .sum::<f64>()
            / self.area
    }

    /// How far a particle lies below the nearer surface, m; zero between two fluids, where it
    /// may lie on either side.
    pub(super) fn depth(&self, i: usize) -> f64 {
        let height = self.particles.position[i][D - 1];
        match self.periodic[D - 1] {
            Some(_) => 0.0,
            None => height.min(self.height - height),
        }
    }
}
