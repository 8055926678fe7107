//! Kordilla, Tartakovsky and Geyer (2013), Adv. Water Resour. 59, 1, after Liu, Meakin and Huang
//! (2007): two cubic splines that reach s and 0.8 s, each one at r = 0,
//!
//! - f(r) = w(r / s) - 2 w(r / (0.8 s))
//! - w(q) = 2 (1 - q)^3 - 8 (1/2 - q)^3, each power zero where its base is negative

use super::Attraction;
use crate::real::Real;

/// Two splines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Kordilla;

impl Attraction for Kordilla {
    #[inline(always)]
    fn attraction<R: Real, const D: usize>(&self, distance: R, support: f64) -> R {
        spline(distance * (1.0 / support)) - spline(distance * (1.25 / support)) * 2.0
    }
}

#[inline(always)]
fn spline<R: Real>(q: R) -> R {
    let outer = (-q + 1.0).positive().powi(3);
    let inner = (-q + 0.5).positive().powi(3);
    outer * 2.0 - inner * 8.0
}
