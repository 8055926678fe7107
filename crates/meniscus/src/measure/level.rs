//! Where the surface of a liquid on a wall is: the level set of its smoothed colour.
//!
//! Which particles are outermost, and how far the surface lies outside of their centres, depends on how they are ordered. Where
//! the volume of all of them ends does not: with a normal distribution S of variance v,
//!
//! c(x) = sum_j V_j S(x - x_j) / (1 - C_w(x)),   C_w the wall's part of S,
//!
//! is one half on the surface. Beside a wall it is a mean over that part of S that lies before it, whose middle is
//! M = sqrt(v) phi(z / sqrt(v)) / (1 - C_w) higher than x, at the height z: there it is that a straight surface lies. On one of curvature
//! kappa the level set lies deeper by v kappa / 2.

use std::f64::consts::{PI, SQRT_2};

use super::base::Base;
use crate::cells::Cells;
use crate::vector::Vector;

/// sqrt(v), in spacings.
const WIDTH: f64 = 1.0;
/// How far S is summed, in spacings.
const REACH: f64 = 3.5;
/// Steps to the level set, and how long they are at most, in spacings.
const STEPS: usize = 6;
const LONGEST: f64 = 0.7;
/// How far c may be off in the end, and the way to it, in spacings.
const LEEWAY: f64 = 0.01;
const FARTHEST: f64 = 2.0;

/// How much deeper than a surface of this curvature (1/m) the level set lies, m.
pub fn depth(curvature: f64, spacing: f64) -> f64 {
    0.5 * (WIDTH * spacing).powi(2) * curvature
}

/// Points of the surface of a liquid, one by each of the particles `near` it, about `spacing` (m) apart;
/// fewer where there is none.
pub fn surface_points<const D: usize>(
    positions: &[Vector<f64, D>],
    masses: &[f64],
    spacing: f64,
    wall: &Base<D>,
    near: &[usize],
) -> Vec<Vector<f64, D>> {
    let width = WIDTH * spacing;
    let mut cells = Cells::new(REACH * spacing);
    for (i, &x) in positions.iter().enumerate() {
        cells.add(i, x);
    }
    let mean = masses.iter().sum::<f64>() / masses.len() as f64;
    // Over (2 pi v)^(D/2), with what lies beyond the reach.
    let peak = (spacing / ((2.0 * PI).sqrt() * width)).powi(D as i32) / mean;
    let bend = 0.5 * (D as f64 - 1.0) * width * width * wall.curvature();
    // C_w and its slope over the height.
    let of_wall = |height: f64| {
        let y = (height + bend) / width;
        let part = 0.5 * libm::erfc(y / SQRT_2);
        let slope = (-0.5 * y * y).exp() / ((2.0 * PI).sqrt() * width);
        (part.min(0.9), slope)
    };
    // c and its gradient.
    let colour = |x: Vector<f64, D>| {
        let (mut sum, mut gradient) = (0.0, Vector::ZERO);
        cells.near(&x, |j, y| {
            let arm = y - x;
            let share = masses[j] * peak * (-0.5 * arm.norm_squared() / (width * width)).exp();
            sum += share;
            gradient += arm * (share / (width * width));
        });
        let (part, slope) = of_wall(wall.height(x));
        let free = 1.0 - part;
        let gradient = gradient - wall.normal(x) * (slope * sum / free);
        (sum / free, gradient * (1.0 / free))
    };
    let point = |&i: &usize| {
        let mut x = positions[i];
        for _ in 0..STEPS {
            let (c, gradient) = colour(x);
            let way = gradient * ((0.5 - c) / gradient.norm_squared().max(f64::MIN_POSITIVE));
            x += way * (LONGEST * spacing / way.norm().max(LONGEST * spacing));
        }
        let (c, _) = colour(x);
        let found = (c - 0.5).abs() < LEEWAY && (x - positions[i]).norm() < FARTHEST * spacing;
        let (part, slope) = of_wall(wall.height(x));
        let middle = width * width * slope / (1.0 - part);
        found.then(|| x + wall.normal(x) * middle)
    };
    near.iter().filter_map(point).collect()
}
