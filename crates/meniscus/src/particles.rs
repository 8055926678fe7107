//! The state of a flow: one column per quantity, one row per particle.

use crate::vector::Vector;

/// Rows that one task works on at least, where the work per row is small.
pub(crate) const ROWS_PER_TASK: usize = 2048;

/// Columns of all particles, SI. Rows are reordered as the flow moves;
/// [`id`](Self::id) says which particle a row holds.
#[derive(Clone, Debug, Default)]
pub struct Particles<const D: usize> {
    /// Position, m
    pub position: Vec<Vector<f64, D>>,
    /// Velocity, m/s
    pub velocity: Vec<Vector<f64, D>>,
    /// Acceleration, m/s^2
    pub acceleration: Vec<Vector<f64, D>>,
    /// Density, kg/m^3
    pub density: Vec<f64>,
    /// Pressure, Pa
    pub pressure: Vec<f64>,
    /// Curvature that the balanced model of surface tension carries, 1/m; otherwise empty
    pub curvature: Vec<f64>,
    /// Temperature, K; empty but for a van der Waals fluid
    pub temperature: Vec<f64>,
    /// Its rate, K/s; empty likewise
    pub heating: Vec<f64>,
    /// The rate of that by the acceleration alone, K/s^2; empty likewise
    pub heating_gain: Vec<f64>,
    /// Mass, kg (kg/m in 2D)
    pub mass: Vec<f64>,
    /// Smoothing length, m
    pub smoothing_length: Vec<f64>,
    /// Index of the fluid
    pub fluid: Vec<u16>,
    /// Index of the body that the particle started in
    pub body: Vec<u16>,
    /// Number that stays with the particle
    pub id: Vec<u32>,
}

/// One particle at the start. SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Particle<const D: usize> {
    /// Position, m
    pub position: Vector<f64, D>,
    /// Velocity, m/s
    pub velocity: Vector<f64, D>,
    /// Mass, kg (kg/m in 2D)
    pub mass: f64,
    /// Index of the fluid
    pub fluid: u16,
    /// Index of the body
    pub body: u16,
}

impl<const D: usize> Particles<D> {
    /// Particles at rest pressure; density and smoothing length are left for the caller to set.
    pub fn new(start: &[Particle<D>]) -> Self {
        Self {
            position: start.iter().map(|p| p.position).collect(),
            velocity: start.iter().map(|p| p.velocity).collect(),
            acceleration: vec![Vector::ZERO; start.len()],
            density: vec![0.0; start.len()],
            pressure: vec![0.0; start.len()],
            curvature: Vec::new(),
            temperature: Vec::new(),
            heating: Vec::new(),
            heating_gain: Vec::new(),
            mass: start.iter().map(|p| p.mass).collect(),
            smoothing_length: vec![0.0; start.len()],
            fluid: start.iter().map(|p| p.fluid).collect(),
            body: start.iter().map(|p| p.body).collect(),
            id: (0..start.len() as u32).collect(),
        }
    }

    /// The rows of some bodies alone, in the same order.
    pub fn of_bodies(&self, which: impl Fn(u16) -> bool) -> Self {
        let rows: Vec<u32> = (0..self.len() as u32)
            .filter(|&row| which(self.body[row as usize]))
            .collect();
        let mut part = self.clone();
        part.permute(&rows, &mut Scratch::default());
        part
    }

    /// Number of particles.
    pub fn len(&self) -> usize {
        self.position.len()
    }

    /// Whether there is no particle.
    pub fn is_empty(&self) -> bool {
        self.position.is_empty()
    }

    /// Volume m/rho of particle `i`, m^D.
    #[inline(always)]
    pub fn volume(&self, i: usize) -> f64 {
        self.mass[i] / self.density[i]
    }

    /// Reorders the rows: row `k` becomes the former row `order[k]`.
    pub(crate) fn permute(&mut self, order: &[u32], scratch: &mut Scratch<D>) {
        for column in [
            &mut self.position,
            &mut self.velocity,
            &mut self.acceleration,
        ] {
            gather(column, &mut scratch.vectors, order);
        }
        for column in [
            &mut self.density,
            &mut self.pressure,
            &mut self.curvature,
            &mut self.temperature,
            &mut self.heating,
            &mut self.heating_gain,
            &mut self.mass,
            &mut self.smoothing_length,
        ] {
            if !column.is_empty() {
                gather(column, &mut scratch.scalars, order);
            }
        }
        for column in [&mut self.fluid, &mut self.body] {
            gather(column, &mut scratch.indices, order);
        }
        gather(&mut self.id, &mut scratch.ids, order);
    }
}

/// Spare columns that [`Particles::permute`] swaps with.
#[derive(Debug, Default)]
pub(crate) struct Scratch<const D: usize> {
    vectors: Vec<Vector<f64, D>>,
    scalars: Vec<f64>,
    indices: Vec<u16>,
    ids: Vec<u32>,
}

fn gather<T: Copy>(column: &mut Vec<T>, spare: &mut Vec<T>, order: &[u32]) {
    spare.clear();
    spare.extend(order.iter().map(|&k| column[k as usize]));
    std::mem::swap(column, spare);
}
