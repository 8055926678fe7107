//! Tartakovsky and Meakin (2005), Phys. Rev. E 72, 026301, with s the support:
//!
//! - f(r) = -cos(3 pi r / (2 s)), r < s
//!
//! Repulsive below s / 3, strongest at 2 s / 3.

use std::f64::consts::{FRAC_PI_2, PI};

use super::Attraction;
use crate::real::Real;

/// The cosine force.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cosine;

impl Attraction for Cosine {
    #[inline(always)]
    fn attraction<R: Real, const D: usize>(&self, distance: R, support: f64) -> R {
        let one = distance.literal(1.0);
        let q = distance * (1.0 / support);
        // -cos(2 y) = 2 cos^2(y - pi/2) - 1: an argument from -pi/2 to pi/4.
        let x = q.min(one) * (0.75 * PI) - FRAC_PI_2;
        let value = cosine(x).square() * 2.0 - 1.0;
        R::select(q.less(one), value, one.zero())
    }
}

/// cos(x) for |x| <= pi/2 to 1e-14: its Taylor polynomial.
#[inline(always)]
fn cosine<R: Real>(x: R) -> R {
    let square = x.square();
    let mut sum = x.literal(1.0);
    let mut n = 20;
    while n > 0 {
        sum = -square * sum * (1.0 / (n * (n - 1)) as f64) + 1.0;
        n -= 2;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_polynomial_is_the_cosine() {
        for k in 0..1000 {
            let r = f64::from(k) * 2e-3;
            let exact = if r < 1.0 { -(1.5 * PI * r).cos() } else { 0.0 };
            let found: f64 = Cosine.attraction::<f64, 2>(r, 1.0);
            assert!((found - exact).abs() < 1e-13, "{r}: {found} for {exact}");
        }
    }
}
