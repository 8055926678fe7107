//! The arithmetic that formulas are written in.
//!
//! A formula over `R: Real` runs on one number (`f64`), on a SIMD lane of
//! particles, and may later be recorded and printed for a GPU. The trait is
//! therefore small: arithmetic, square root, floor, minimum and maximum,
//! comparison to a mask, selection by it, literals. No early return, no
//! branch on a value.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number, or a lane of numbers, that physics formulas are written in.
pub trait Real:
    Copy
    + Send
    + Sync
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Add<f64, Output = Self>
    + Sub<f64, Output = Self>
    + Mul<f64, Output = Self>
    + Div<f64, Output = Self>
{
    /// The result of a comparison, one truth value per lane.
    type Mask: Copy;

    /// The literal `value` in the width of `self`, whose own value is ignored.
    fn literal(self, value: f64) -> Self;
    /// Square root.
    fn sqrt(self) -> Self;
    /// Largest integer not above.
    fn floor(self) -> Self;
    /// The smaller of two.
    fn min(self, other: Self) -> Self;
    /// The larger of two.
    fn max(self, other: Self) -> Self;
    /// `self < other`.
    fn less(self, other: Self) -> Self::Mask;
    /// `yes` where the mask holds, `no` elsewhere.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;

    /// Zero in the width of `self`.
    #[inline(always)]
    fn zero(self) -> Self {
        self.literal(0.0)
    }

    /// The positive part, `max(0, self)`.
    #[inline(always)]
    fn positive(self) -> Self {
        self.max(self.zero())
    }

    /// Square.
    #[inline(always)]
    fn square(self) -> Self {
        self * self
    }

    /// A whole power, by repeated squaring.
    #[inline(always)]
    fn powi(self, exponent: u32) -> Self {
        let mut result = self.literal(1.0);
        let mut base = self;
        let mut left = exponent;
        while left > 0 {
            if left & 1 == 1 {
                result = result * base;
            }
            base = base * base;
            left >>= 1;
        }
        result
    }

    /// `exp(-x)` for `0 <= x <= 10`, relative error below 1e-15.
    ///
    /// Built from arithmetic alone, so that every machine gives the same
    /// bits: x = k ln 2 + s with k whole and |s| <= ln 2 / 2, a Taylor series
    /// of degree 13 in s, and 2^-k from the four binary digits of k.
    #[inline(always)]
    fn exp_minus(self) -> Self {
        let k = (self * std::f64::consts::LOG2_E + 0.5).floor();
        // ln 2 in two parts, the first exact when multiplied by a small whole number.
        const LN2_HIGH: f64 = 0.693_147_180_369_123_8;
        const LN2_LOW: f64 = 1.908_214_929_270_587_7e-10;
        let s = (self - k * LN2_HIGH) - k * LN2_LOW;
        let mut sum = self.literal(1.0);
        for n in (1..=13).rev() {
            sum = sum * s / -f64::from(n) + 1.0;
        }
        let mut digits = k;
        let mut power = 0.5_f64;
        for _ in 0..4 {
            let half = (digits * 0.5).floor();
            let digit = digits - half * 2.0;
            sum = sum * (digit * (power - 1.0) + 1.0);
            digits = half;
            power *= power;
        }
        sum
    }
}

impl Real for f64 {
    type Mask = bool;

    #[inline(always)]
    fn literal(self, value: f64) -> f64 {
        value
    }
    #[inline(always)]
    fn sqrt(self) -> f64 {
        f64::sqrt(self)
    }
    #[inline(always)]
    fn floor(self) -> f64 {
        f64::floor(self)
    }
    #[inline(always)]
    fn min(self, other: f64) -> f64 {
        if self < other { self } else { other }
    }
    #[inline(always)]
    fn max(self, other: f64) -> f64 {
        if self > other { self } else { other }
    }
    #[inline(always)]
    fn less(self, other: f64) -> bool {
        self < other
    }
    #[inline(always)]
    fn select(mask: bool, yes: f64, no: f64) -> f64 {
        if mask { yes } else { no }
    }
}

#[cfg(test)]
mod tests {
    use super::Real;

    #[test]
    fn exp_minus_agrees_with_the_library_to_a_few_rounding_errors() {
        for i in 0..=10_000 {
            let x = f64::from(i) * 1e-3;
            let error = (Real::exp_minus(x) / (-x).exp() - 1.0).abs();
            assert!(error < 1e-15, "x = {x}: relative error {error:e}");
        }
    }

    #[test]
    fn whole_powers() {
        assert_eq!(Real::powi(3.0, 0), 1.0);
        assert_eq!(Real::powi(3.0, 5), 243.0);
    }
}
