//! The cubic B-spline: w(q) = (2 - q)^3 / 4 - (1 - q)^3, each power zero where
//! its base is negative; C_2 = 10 / (7 pi), C_3 = 1 / pi.
//! Monaghan and Lattanzio (1985), Astron. Astrophys. 149, 135, eq. 21.

use std::f64::consts::PI;

use super::SmoothingKernel;
use crate::real::Real;

/// The cubic B-spline, support 2 h.
#[derive(Clone, Copy, Debug)]
pub struct CubicSpline;

impl SmoothingKernel for CubicSpline {
    const NAME: &'static str = "cubic-spline";
    const SUPPORT: f64 = 2.0;

    fn normalisation(dimension: usize) -> f64 {
        if dimension == 2 {
            10.0 / (7.0 * PI)
        } else {
            1.0 / PI
        }
    }

    #[inline(always)]
    fn shape<R: Real>(q: R) -> R {
        let inner = (-q + 1.0).positive();
        let outer = (-q + 2.0).positive();
        outer.square() * outer * 0.25 - inner.square() * inner
    }

    // Inside q = 1 the slope over q is the polynomial -3 + 9 q / 4; outside it is
    // -(3/4) (2 - q)^2 / q. The sum below is one or the other, and divides by
    // nothing smaller than one.
    #[inline(always)]
    fn slope_over_q<R: Real>(q: R) -> R {
        let inner = (-q + 1.0).positive();
        let beyond = q.max(q.literal(1.0));
        let outer = (-beyond + 2.0).positive();
        inner * -2.25 - outer.square() * 0.75 / beyond
    }
}
