//! Plane waves along the last axis of a periodic strip, one wavelength of 1
//! long and four spacings across, and what a kernel makes of them.
//!
//! The quintic spline at h = 2.5 dx sums over a square lattice as over a
//! continuum to 1e-4 (0.4 % for the sum of fourth order in Monaghan and
//! Cleary's viscosity), so that what a test sees is the equation.

use std::f64::consts::TAU;

use meniscus::fluid::Fluid;
use meniscus::{Kernel, Particles, Setup, Vector};

use crate::common::periodic_lattice;

/// Wave number of one wave in the strip.
pub const K: f64 = TAU;

pub const KERNEL: Kernel = Kernel::QuinticSpline;

/// The smoothing length of a strip with `n` particles to the wave.
pub fn smoothing_length(n: usize) -> f64 {
    2.5 / n as f64
}

/// A strip at rest but for the velocity `amplitude` sin(K x) of one component.
pub fn strip<const D: usize>(n: usize, component: usize, amplitude: f64, fluid: Fluid) -> Setup<D> {
    let mut counts = [4; D];
    counts[D - 1] = n;
    let velocity = |x: Vector<f64, D>| {
        let mut v = Vector::ZERO;
        v[component] = amplitude * (K * x[D - 1]).sin();
        v
    };
    let mut setup = periodic_lattice(counts, 1.0 / n as f64, velocity, fluid);
    setup.scheme.kernel = KERNEL;
    setup.scheme.smoothing_length = smoothing_length(n);
    setup
}

/// Amplitude of sin(K x) in one component of `field`.
pub fn amplitude<const D: usize>(
    particles: &Particles<D>,
    field: &[Vector<f64, D>],
    component: usize,
) -> f64 {
    let sum: f64 = (particles.position.iter().zip(field))
        .map(|(x, v)| v[component] * (K * x[D - 1]).sin())
        .sum();
    2.0 * sum / particles.len() as f64
}

/// The mean of `f(x)` with the kernel of a strip as weight, x one component of
/// the distance. Sums over a grid of h/16; for smooth f that is better than 1e-6.
pub fn mean_over_kernel(n: usize, dimension: usize, f: impl Fn(f64) -> f64) -> f64 {
    let h = smoothing_length(n);
    let step = h / 16.0;
    let reach = (KERNEL.support() * h / step).ceil() as i64;
    let depth = if dimension == 3 { reach } else { 0 };
    let mut sum = 0.0;
    for ix in -reach..=reach {
        let x = ix as f64 * step;
        let mut weight = 0.0;
        for iy in -reach..=reach {
            for iz in -depth..=depth {
                let r2 = (iy * iy + iz * iz) as f64 * step * step + x * x;
                weight += KERNEL.value(r2.sqrt(), h, dimension);
            }
        }
        sum += weight * f(x);
    }
    sum * step.powi(dimension as i32)
}
