//! The quintic B-spline: w(q) = (3 - q)^5 - 6 (2 - q)^5 + 15 (1 - q)^5, each
//! power zero where its base is negative; C_2 = 7 / (478 pi), C_3 = 1 / (120 pi).
//! Schoenberg (1946); in this form Morris, Fox and Zhu (1997), J. Comput. Phys.
//! 136, 214, eq. 19, and Price (2012), J. Comput. Phys. 231, 759, eq. 22.

use std::f64::consts::PI;

use super::SmoothingKernel;
use crate::real::Real;

/// The quintic B-spline, support 3 h.
#[derive(Clone, Copy, Debug)]
pub struct QuinticSpline;

impl SmoothingKernel for QuinticSpline {
    const NAME: &'static str = "quintic-spline";
    const SUPPORT: f64 = 3.0;

    fn normalisation(dimension: usize) -> f64 {
        if dimension == 2 {
            7.0 / (478.0 * PI)
        } else {
            1.0 / (120.0 * PI)
        }
    }

    #[inline(always)]
    fn shape<R: Real>(q: R) -> R {
        let inner = (-q + 1.0).positive();
        let middle = (-q + 2.0).positive();
        let outer = (-q + 3.0).positive();
        outer.powi(5) - middle.powi(5) * 6.0 + inner.powi(5) * 15.0
    }

    // Inside q = 1 the powers cancel to -5 (24 - 24 q^2 + 10 q^3); outside two of
    // them are left, over q. At q = 1 both are -50. The sum below is one or the
    // other, and divides by nothing smaller than one.
    #[inline(always)]
    fn slope_over_q<R: Real>(q: R) -> R {
        let one = q.literal(1.0);
        let within = q.min(one);
        let beyond = q.max(one);
        let middle = (-beyond + 2.0).positive();
        let outer = (-beyond + 3.0).positive();
        let inner = within.square() * (within * 10.0 - 24.0) + 14.0;
        let rest = (outer.square().square() - middle.square().square() * 6.0) / beyond;
        (inner + rest) * -5.0
    }
}
