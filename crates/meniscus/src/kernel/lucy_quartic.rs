//! Lucy's quartic: w(q) = (1 + 3 q) (1 - q)^3, q <= 1;
//! C_2 = 5 / pi, C_3 = 105 / (16 pi). The support is one smoothing length, as in
//! Lucy (1977), Astron. J. 82, 1013, and Sigalotti, Daza and Donoso (2006).

use std::f64::consts::PI;

use super::SmoothingKernel;
use crate::real::Real;

/// Lucy's quartic, support h.
#[derive(Clone, Copy, Debug)]
pub struct LucyQuartic;

impl SmoothingKernel for LucyQuartic {
    const NAME: &'static str = "lucy-quartic";
    const SUPPORT: f64 = 1.0;

    fn normalisation(dimension: usize) -> f64 {
        if dimension == 2 {
            5.0 / PI
        } else {
            105.0 / (16.0 * PI)
        }
    }

    #[inline(always)]
    fn shape<R: Real>(q: R) -> R {
        let s = (-q + 1.0).positive();
        s.square() * s * (q * 3.0 + 1.0)
    }

    #[inline(always)]
    fn slope_over_q<R: Real>(q: R) -> R {
        (-q + 1.0).positive().square() * -12.0
    }
}
