//! The Gaussian cut at three smoothing lengths: w(q) = exp(-q^2), q <= 3;
//! C_D = pi^(-D/2). Jancik and Hyhlik, eq. 4.
//!
//! The constant is the whole Gaussian's, as printed: the part cut off is
//! exp(-9) = 1.2e-4 of the integral in 2D, and 4.4e-4 in 3D.

use std::f64::consts::PI;

use super::SmoothingKernel;
use crate::real::Real;

/// The Gaussian cut at 3 h.
#[derive(Clone, Copy, Debug)]
pub struct TruncatedGaussian;

impl SmoothingKernel for TruncatedGaussian {
    const NAME: &'static str = "truncated-gaussian";
    const SUPPORT: f64 = 3.0;
    const FROM_SQUARE: bool = true;

    fn normalisation(dimension: usize) -> f64 {
        PI.powf(-0.5 * dimension as f64)
    }

    #[inline(always)]
    fn shape<R: Real>(q: R) -> R {
        Self::shape_from_square(q.square())
    }

    #[inline(always)]
    fn slope_over_q<R: Real>(q: R) -> R {
        Self::slope_over_q_from_square(q.square())
    }

    #[inline(always)]
    fn shape_from_square<R: Real>(square: R) -> R {
        let w = square.min(square.literal(10.0)).exp_minus();
        R::select(square.less(square.literal(9.0 + 1e-12)), w, square.zero())
    }

    #[inline(always)]
    fn slope_over_q_from_square<R: Real>(square: R) -> R {
        Self::shape_from_square(square) * -2.0
    }
}
