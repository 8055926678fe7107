//! Wendland's C4 kernel: w(q) = (1 - q/2)^6 (1 + 3 q + 35 q^2 / 12), q <= 2;
//! C_2 = 9 / (4 pi), C_3 = 495 / (256 pi).
//! Wendland (1995), Adv. Comput. Math. 4, 389; constants as in Dehnen and Aly (2012), table 1.

use std::f64::consts::PI;

use super::SmoothingKernel;
use crate::real::Real;

/// Wendland's C4 kernel, support 2 h.
#[derive(Clone, Copy, Debug)]
pub struct WendlandC4;

impl SmoothingKernel for WendlandC4 {
    const NAME: &'static str = "wendland-c4";
    const SUPPORT: f64 = 2.0;

    fn normalisation(dimension: usize) -> f64 {
        if dimension == 2 {
            9.0 / (4.0 * PI)
        } else {
            495.0 / (256.0 * PI)
        }
    }

    #[inline(always)]
    fn shape<R: Real>(q: R) -> R {
        let s = (q * -0.5 + 1.0).positive();
        (s.square() * s).square() * (q * (q * (35.0 / 12.0) + 3.0) + 1.0)
    }

    #[inline(always)]
    fn slope_over_q<R: Real>(q: R) -> R {
        let s = (q * -0.5 + 1.0).positive();
        s.square().square() * s * (q * 2.5 + 1.0) * (-14.0 / 3.0)
    }
}
