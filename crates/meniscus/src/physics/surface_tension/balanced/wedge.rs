//! What the liquid would be under a surface that goes on straight into a wall, at the contact angle.
//!
//! A particle at a distance y from a wall, at a depth d under a plane surface that meets the wall
//! at the angle theta, sees c_f of liquid and c_w of wall. Were the part chi(d, y) of the wall liquid
//! that lies under the surface's plane, it would see C(d):
//!
//! c_f + c_w chi(d, y) = C(d),   c_w = 1 - C(y)
//!
//! which tells its depth from c_f and c_w.

use super::half_space::HalfSpace;
use crate::kernel::Kernel;

/// Cells of the table along d and y, and of the integrals.
const DEPTHS: usize = 64;
const DISTANCES: usize = 24;
const CELLS: usize = 80;
/// Where a wall is all but out of reach, as a part of the kernel's support.
const FARTHEST: f64 = 0.98;

/// A table of chi for one contact angle.
#[derive(Clone, Debug)]
pub struct Wedge {
    /// theta, rad
    pub angle: f64,
    reach: f64,
    part: Vec<f64>,
}

impl Wedge {
    /// For a kernel of this smoothing length, m, in 2 or 3 dimensions, and a contact angle, rad.
    pub fn new(kernel: Kernel, smoothing_length: f64, dimension: usize, angle: f64) -> Self {
        let reach = kernel.support() * smoothing_length;
        let cell = reach / CELLS as f64;
        let along_line = |r: f64| {
            if dimension == 2 {
                return kernel.value(r, smoothing_length, 2);
            }
            let top = (reach * reach - r * r).max(0.0).sqrt();
            let width = 2.0 * top / CELLS as f64;
            let at = |k: usize| (k as f64 + 0.5) * width - top;
            (0..CELLS)
                .map(|k| kernel.value(r.hypot(at(k)), smoothing_length, 3) * width)
                .sum()
        };
        let weights: Vec<f64> = (0..=CELLS).map(|k| along_line(k as f64 * cell)).collect();
        let weight = |r: f64| {
            let place = r / cell;
            let k = (place as usize).min(CELLS);
            let next = weights.get(k + 1).copied().unwrap_or(0.0);
            weights[k] + (next - weights[k]) * (place - k as f64).min(1.0)
        };
        let (sin, cos) = angle.sin_cos();
        let mut part = Vec::new();
        for row in 0..=DISTANCES {
            let y = FARTHEST * reach * row as f64 / DISTANCES as f64;
            let thickness = (reach - y) / CELLS as f64;
            // Weight of the wall by the depth from which on it lies under the surface.
            let mut share = [0.0; DEPTHS + 1];
            for a in 0..2 * CELLS {
                let x = (a as f64 + 0.5 - CELLS as f64) * cell;
                for b in 0..CELLS {
                    let z = y + (b as f64 + 0.5) * thickness;
                    let depth = -(x * sin + z * cos);
                    let column = (depth / reach + 1.0) * 0.5 * DEPTHS as f64;
                    share[column.ceil().clamp(0.0, DEPTHS as f64) as usize] += weight(x.hypot(z));
                }
            }
            let all: f64 = share.iter().sum();
            let mut sum = 0.0;
            part.extend(share.iter().map(|share| {
                sum += share;
                sum / all
            }));
        }
        Self { angle, reach, part }
    }

    fn part(&self, depth: f64, distance: f64) -> f64 {
        let place = |x: f64, cells: usize| {
            let x = (x * cells as f64).clamp(0.0, cells as f64 - 1e-9);
            (x as usize, x.fract())
        };
        let (i, f) = place((depth / self.reach + 1.0) * 0.5, DEPTHS);
        let (j, g) = place(distance / (FARTHEST * self.reach), DISTANCES);
        let at = |i: usize, j: usize| self.part[j * (DEPTHS + 1) + i];
        let low = at(i, j) * (1.0 - f) + at(i + 1, j) * f;
        let high = at(i, j + 1) * (1.0 - f) + at(i + 1, j + 1) * f;
        low * (1.0 - g) + high * g
    }

    /// The depth, m, of a particle that sees so much of liquid and so much of wall.
    pub fn depth(&self, half_space: &HalfSpace, liquid: f64, wall: f64) -> f64 {
        let distance = half_space.depth(1.0 - wall, 0.0).max(0.0);
        let (mut low, mut high) = (-self.reach, self.reach);
        for _ in 0..24 {
            let depth = 0.5 * (low + high);
            if half_space.filled(depth) - wall * self.part(depth, distance) < liquid {
                low = depth;
            } else {
                high = depth;
            }
        }
        0.5 * (low + high)
    }
}

#[cfg(test)]
mod tests {
    use super::{HalfSpace, Wedge};
    use crate::kernel::Kernel;

    #[test]
    fn a_surface_across_a_wall_goes_on_into_it() {
        // At a right angle the part of the wall is the part of the kernel, whatever the distance.
        for dimension in [2, 3] {
            let half_space = HalfSpace::new(Kernel::WendlandC2, 2.0, dimension);
            let right = std::f64::consts::FRAC_PI_2;
            let wedge = Wedge::new(Kernel::WendlandC2, 2.0, dimension, right);
            for (depth, distance) in [(0.5, 0.5), (0.0, 0.5), (1.0, 1.5), (3.0, 0.5)] {
                let wall = 1.0 - half_space.filled(distance);
                let liquid = half_space.filled(depth) * (1.0 - wall);
                let found = wedge.depth(&half_space, liquid, wall);
                // Cells of the table are an eighth of a spacing; deep down all is flat.
                let tolerance = if depth > 2.0 { 0.5 } else { 0.1 };
                assert!((found - depth).abs() < tolerance, "{found}, {depth}");
            }
        }
    }

    #[test]
    fn the_edge_of_a_wedge_sees_its_angle() {
        let half_space = HalfSpace::new(Kernel::WendlandC2, 2.0, 2);
        for degrees in [30.0_f64, 60.0, 120.0, 150.0] {
            let wedge = Wedge::new(Kernel::WendlandC2, 2.0, 2, degrees.to_radians());
            let found = wedge.depth(&half_space, degrees / 360.0, 0.5);
            assert!(found.abs() < 0.15, "{degrees}: {found}");
        }
    }
}
