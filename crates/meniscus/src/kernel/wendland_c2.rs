//! Wendland's C2 kernel: w(q) = (1 - q/2)^4 (1 + 2 q), q <= 2;
//! C_2 = 7 / (4 pi), C_3 = 21 / (16 pi).
//! Wendland (1995), Adv. Comput. Math. 4, 389; constants as in Dehnen and Aly (2012), table 1.

use std::f64::consts::PI;

use super::SmoothingKernel;
use crate::real::Real;

/// Wendland's C2 kernel, support 2 h.
#[derive(Clone, Copy, Debug)]
pub struct WendlandC2;

impl SmoothingKernel for WendlandC2 {
    const NAME: &'static str = "wendland-c2";
    const SUPPORT: f64 = 2.0;

    fn normalisation(dimension: usize) -> f64 {
        if dimension == 2 {
            7.0 / (4.0 * PI)
        } else {
            21.0 / (16.0 * PI)
        }
    }

    #[inline(always)]
    fn shape<R: Real>(q: R) -> R {
        let one = q.literal(1.0);
        let s = q.mul_add(q.literal(-0.5), one).positive();
        s.square().square() * q.mul_add(q.literal(2.0), one)
    }

    #[inline(always)]
    fn slope_over_q<R: Real>(q: R) -> R {
        let s = q.mul_add(q.literal(-0.5), q.literal(1.0)).positive();
        s.square() * s * -5.0
    }
}
