//! What tests of measurements are tried on: random numbers, and bodies cut from a lattice.

use std::f64::consts::TAU;

use crate::shape::{Arrangement, Pattern, Rotation, Shape};
use crate::vector::Vector;

/// Pseudo-random numbers by Steele, Lea and Flood's splitmix64.
pub struct Random(pub u64);

impl Random {
    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 * 2.0_f64.powi(-53) + 2.0_f64.powi(-54)
    }

    /// Box and Muller.
    pub fn normal(&mut self) -> f64 {
        (-2.0 * self.uniform().ln()).sqrt() * (TAU * self.uniform()).cos()
    }
}

/// The points of a square or cubic lattice of unit spacing for which `inside` holds, within
/// `reach` of the origin, which is no special point of it. It is turned by `angle` about the
/// third axis, and each coordinate has moved at random by up to `jitter`.
pub fn cut<const D: usize>(
    reach: f64,
    angle: f64,
    jitter: f64,
    inside: impl Fn(&Vector<f64, D>) -> bool,
) -> Vec<Vector<f64, D>> {
    let lattice = Arrangement {
        rotation: Rotation::about(Vector([0.0, 0.0, 1.0]), angle),
        origin: Some(Vector(std::array::from_fn(|d| 0.23 + 0.11 * d as f64))),
        jitter,
        ..Arrangement::new(Pattern::Cubic, 1.0)
    };
    let ball = Shape::Ball {
        centre: Vector::ZERO,
        radius: reach + 1.0,
    };
    let mut points = lattice.fill(&ball, 1_000_000).unwrap();
    points.retain(inside);
    points
}
