//! The yardstick: continuity and momentum as a textbook has them. A list of
//! neighbours for each particle, two plain loops over it, one number at a
//! time, compiled as it stands. It gets the particles in the engine's order,
//! which is kind to its caches.

use std::ops::Range;

use meniscus::{Kernel, Particles, Vector};
use rayon::prelude::*;

use crate::state::SOUND_SPEED;

/// Neighbours of every particle, and what the loops read.
#[derive(Debug)]
pub struct Yardstick<'a, const D: usize> {
    particles: &'a Particles<D>,
    /// The rows that have neighbours here.
    rows: Range<usize>,
    /// First neighbour of each of these rows in `neighbours`, and the end.
    starts: Vec<usize>,
    neighbours: Vec<u32>,
    /// m / rho
    volume: Vec<f64>,
    /// p / rho^2
    stress: Vec<f64>,
    /// h
    smoothing_length: f64,
    /// Of (1 - q/2)^3 in (1/r) dW/dr.
    slope: f64,
    /// alpha of the artificial viscosity.
    alpha: f64,
}

impl<'a, const D: usize> Yardstick<'a, D> {
    /// Lists, for these rows, of all neighbours nearer than the support of
    /// Wendland's kernel, 2 h.
    pub fn new(
        particles: &'a Particles<D>,
        rows: Range<usize>,
        smoothing_length: f64,
        alpha: f64,
    ) -> Self {
        let position = &particles.position;
        let support = 2.0 * smoothing_length;
        let grid = Grid::new(position, support);
        let lists: Vec<Vec<u32>> = (rows.clone().into_par_iter())
            .with_min_len(1024)
            .map(|i| {
                let x = position[i];
                let mut list = Vec::new();
                grid.visit(&x, |j| {
                    let near = (x - position[j as usize]).norm_squared() < support * support;
                    if near && j as usize != i {
                        list.push(j);
                    }
                });
                list
            })
            .collect();
        let mut starts = vec![0];
        let mut neighbours = Vec::with_capacity(lists.iter().map(Vec::len).sum());
        for list in &lists {
            neighbours.extend_from_slice(list);
            starts.push(neighbours.len());
        }
        let h = smoothing_length;
        let normalisation = Kernel::WendlandC2.normalisation(D) / h.powi(D as i32);
        let columns = || particles.pressure.iter().zip(&particles.density);
        Self {
            particles,
            rows,
            starts,
            neighbours,
            volume: (0..particles.len()).map(|i| particles.volume(i)).collect(),
            stress: columns().map(|(p, rho)| p / (rho * rho)).collect(),
            smoothing_length,
            slope: -5.0 * normalisation / (h * h),
            alpha,
        }
    }

    /// The rows that it knows the neighbours of.
    pub fn rows(&self) -> Range<usize> {
        self.rows.clone()
    }

    /// Directed pairs (i, j), i itself left out, of these rows.
    pub fn pairs(&self, rows: Range<usize>) -> usize {
        let first = self.rows.start;
        self.starts[rows.end - first] - self.starts[rows.start - first]
    }

    fn neighbours(&self, i: usize) -> &[u32] {
        let i = i - self.rows.start;
        &self.neighbours[self.starts[i]..self.starts[i + 1]]
    }

    /// (1/r) dW/dr of Wendland's C2 kernel, for a neighbour.
    fn slope_over_distance(&self, r: f64) -> f64 {
        let s = 1.0 - 0.5 * r / self.smoothing_length;
        self.slope * s * s * s
    }

    /// sum_j V_j (v_i - v_j) . grad W for each row from `first` on, 1/s.
    pub fn continuity(&self, first: usize, rates: &mut [f64]) {
        let Particles {
            position, velocity, ..
        } = self.particles;
        for (i, rate) in (first..).zip(rates) {
            let mut sum = 0.0;
            for &j in self.neighbours(i) {
                let j = j as usize;
                let x = position[i] - position[j];
                let v = velocity[i] - velocity[j];
                sum += self.volume[j] * v.dot(&x) * self.slope_over_distance(x.norm());
            }
            *rate = sum;
        }
    }

    /// Acceleration by pressure and artificial viscosity for each row from
    /// `first` on, m/s^2.
    pub fn momentum(&self, first: usize, accelerations: &mut [Vector<f64, D>]) {
        let Particles {
            position,
            velocity,
            density,
            mass,
            ..
        } = self.particles;
        let h = self.smoothing_length;
        for (i, acceleration) in (first..).zip(accelerations) {
            let mut sum = Vector::ZERO;
            for &j in self.neighbours(i) {
                let j = j as usize;
                let x = position[i] - position[j];
                let v = velocity[i] - velocity[j];
                let r = x.norm();
                let mut factor = self.stress[i] + self.stress[j];
                let approach = v.dot(&x);
                if approach < 0.0 {
                    let mean_density = 0.5 * (density[i] + density[j]);
                    let denominator = (r * r + 0.01 * h * h) * mean_density;
                    factor -= self.alpha * SOUND_SPEED * h * approach / denominator;
                }
                sum -= x * (mass[j] * factor * self.slope_over_distance(r));
            }
            *acceleration = sum;
        }
    }
}

/// Cells as wide as the support.
struct Grid<const D: usize> {
    low: Vector<f64, D>,
    width: f64,
    counts: [usize; D],
    starts: Vec<u32>,
    order: Vec<u32>,
}

impl<const D: usize> Grid<D> {
    fn new(position: &[Vector<f64, D>], width: f64) -> Self {
        let mut low = Vector([f64::INFINITY; D]);
        let mut high = [f64::NEG_INFINITY; D];
        for x in position {
            for d in 0..D {
                low[d] = low[d].min(x[d]);
                high[d] = high[d].max(x[d]);
            }
        }
        let counts = std::array::from_fn(|d| ((high[d] - low[d]) / width) as usize + 1);
        let cells: usize = counts.iter().product();
        let mut grid = Self {
            low,
            width,
            counts,
            starts: vec![0; cells + 1],
            order: vec![0; position.len()],
        };
        let cell_of: Vec<usize> = position.iter().map(|x| grid.index(grid.cell(x))).collect();
        for &cell in &cell_of {
            grid.starts[cell + 1] += 1;
        }
        for cell in 0..cells {
            grid.starts[cell + 1] += grid.starts[cell];
        }
        let mut next = grid.starts.clone();
        for (i, &cell) in cell_of.iter().enumerate() {
            grid.order[next[cell] as usize] = i as u32;
            next[cell] += 1;
        }
        grid
    }

    fn cell(&self, x: &Vector<f64, D>) -> [usize; D] {
        std::array::from_fn(|d| ((x[d] - self.low[d]) / self.width) as usize)
    }

    fn index(&self, cell: [usize; D]) -> usize {
        (0..D).fold(0, |index, d| index * self.counts[d] + cell[d])
    }

    /// Visits all particles in the cells around `x`, its own included.
    fn visit(&self, x: &Vector<f64, D>, mut found: impl FnMut(u32)) {
        let own = self.cell(x);
        for k in 0..3_usize.pow(D as u32) {
            let around: [Option<usize>; D] = std::array::from_fn(|d| {
                let cell = own[d] + k / 3_usize.pow(d as u32) % 3;
                (1..=self.counts[d]).contains(&cell).then(|| cell - 1)
            });
            if around.iter().all(Option::is_some) {
                let cell = self.index(around.map(Option::unwrap_or_default));
                let range = self.starts[cell] as usize..self.starts[cell + 1] as usize;
                self.order[range].iter().for_each(|&j| found(j));
            }
        }
    }
}
