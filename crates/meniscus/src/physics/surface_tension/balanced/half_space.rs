//! What a particle at a depth d under a plane surface sees of the liquid, by integrals of the
//! kernel over planes at a distance d:
//!
//! - W_1(d) = integral of W over the plane
//! - C(d)   = 1/2 + integral of W_1 from 0 to d: the part of the kernel that is filled
//! - E(d)   = 1/(2 (D - 1)) integral of y^2 W over the plane, y the distance from its foot
//!
//! Under a surface of small curvature kappa (the sum of the principal ones) the part is
//! C(d) - kappa E(d), since the surface falls off by kappa y^2 / (2 (D - 1)).

use crate::kernel::Kernel;

const CELLS: usize = 400;

/// Tables of W_1, C and E.
#[derive(Clone, Debug)]
pub struct HalfSpace {
    reach: f64,
    plane: Vec<f64>,
    filled: Vec<f64>,
    falling: Vec<f64>,
}

impl HalfSpace {
    /// For a kernel of this smoothing length, m, in 2 or 3 dimensions.
    pub fn new(kernel: Kernel, smoothing_length: f64, dimension: usize) -> Self {
        let reach = kernel.support() * smoothing_length;
        let cell = reach / CELLS as f64;
        let over_plane = |d: f64, power: i32| -> f64 {
            let top = (reach * reach - d * d).max(0.0).sqrt();
            let width = top / CELLS as f64;
            let ring = |k: usize| {
                let y = (k as f64 + 0.5) * width;
                let measure = if dimension == 2 {
                    2.0
                } else {
                    std::f64::consts::TAU * y
                };
                kernel.value(d.hypot(y), smoothing_length, dimension) * measure * y.powi(power)
            };
            (0..CELLS).map(ring).sum::<f64>() * width
        };
        let depths = || (0..=CELLS).map(|k| k as f64 * cell);
        let plane: Vec<f64> = depths().map(|d| over_plane(d, 0)).collect();
        let share = 0.5 / (dimension as f64 - 1.0);
        let falling = depths().map(|d| share * over_plane(d, 2)).collect();
        let mut filled = vec![0.5];
        for pair in plane.windows(2) {
            filled.push(filled[filled.len() - 1] + 0.5 * cell * (pair[0] + pair[1]));
        }
        Self {
            reach,
            plane,
            filled,
            falling,
        }
    }

    fn read(&self, table: &[f64], depth: f64) -> f64 {
        let place = (depth.abs() / self.reach * CELLS as f64).min(CELLS as f64 - 1e-9);
        let (cell, rest) = (place as usize, place.fract());
        table[cell] * (1.0 - rest) + table[cell + 1] * rest
    }

    /// W_1 at a depth in metres, 1/m.
    pub fn plane(&self, depth: f64) -> f64 {
        self.read(&self.plane, depth)
    }

    /// C at a depth in metres, below zero outside.
    pub fn filled(&self, depth: f64) -> f64 {
        let filled = self.read(&self.filled, depth);
        if depth < 0.0 { 1.0 - filled } else { filled }
    }

    /// The depth in metres at which C(d) - kappa E(d) is `filled`, for a curvature in 1/m; no
    /// further than 9/10 of the kernel's support.
    pub fn depth(&self, filled: f64, curvature: f64) -> f64 {
        let most = 0.9 * self.reach;
        let mut depth = 0.0;
        // By Newton: E' = -d W_1 / 2, as integrating by parts shows.
        for _ in 0..6 {
            let slope = self.plane(depth) * (1.0 + 0.5 * curvature * depth).max(0.2);
            let error = self.filled(depth) - curvature * self.read(&self.falling, depth) - filled;
            depth = (depth - error / slope).clamp(-most, most);
        }
        depth
    }

    /// How far outside the surface a particle lies, m; zero within it.
    pub fn height(&self, filled: f64, curvature: f64) -> f64 {
        if filled >= self.filled[0] - curvature * self.falling[0] {
            return 0.0;
        }
        (-self.depth(filled, curvature)).max(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::HalfSpace;
    use crate::kernel::Kernel;

    #[test]
    fn the_depth_is_that_of_the_filled_part() {
        for dimension in [2, 3] {
            let half_space = HalfSpace::new(Kernel::WendlandC2, 2.0, dimension);
            // All of the kernel.
            assert!((half_space.filled(4.0) - 1.0).abs() < 1e-4);
            for depth in [-1.0, 0.0, 0.3, 0.5, 1.5] {
                let found = half_space.depth(half_space.filled(depth), 0.0);
                assert!(
                    (found - depth).abs() < 1e-9,
                    "{dimension}D: {found}, {depth}"
                );
            }
        }
    }

    #[test]
    fn a_ball_fills_what_its_curvature_says() {
        // The part of a kernel, d under the surface of a ball of radius R, that lies inside.
        let (h, radius, depth) = (0.2, 1.0, 0.1);
        let cells = 200;
        let side = 2.0 * h / f64::from(cells);
        let mut inside = 0.0;
        for a in -cells..cells {
            for b in -cells..cells {
                let [x, y] = [a, b].map(|k| (f64::from(k) + 0.5) * side);
                if (radius - depth + x).hypot(y) < radius {
                    inside += Kernel::WendlandC2.value(x.hypot(y), h, 2) * side * side;
                }
            }
        }
        let half_space = HalfSpace::new(Kernel::WendlandC2, h, 2);
        let found = half_space.depth(inside, 1.0 / radius);
        // Of first order in the curvature: what is left is of the order (h / R)^2 h, and a tenth of it at most.
        assert!(
            (found - depth).abs() < 0.1 * (h / radius).powi(2) * h,
            "{found}"
        );
    }
}
