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

    /// `self * factor + addend`, rounded once where the processor can.
    ///
    /// Formulas say so by name: the compiler may not fuse of itself, since
    /// that changes bits.
    #[inline(always)]
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        self * factor + addend
    }

    /// The least normal number: keeps a zero out of a denominator.
    fn tiny(self) -> Self;

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

    /// `exp(-x)` for `0 <= x <= 10`, relative error below 1e-14.
    ///
    /// Built from arithmetic alone, so that every machine gives the same
    /// bits: exp(-x) = (exp(-5/16) exp(-s))^16 with s = x/16 - 5/16, |s| <= 5/16,
    /// and exp(-s) its Taylor polynomial of degree 12, as a tree (Estrin) so that
    /// little waits for one another. The power 16 makes sixteen of the three rounding errors of the
    /// polynomial, and fifteen more on its way.
    #[inline(always)]
    fn exp_minus(self) -> Self {
        /// exp(-5/16) (-1)^n / n!
        const C: [f64; 13] = {
            let mut c = [0.731_615_628_946_641_8; 13];
            let mut n = 1;
            while n < c.len() {
                c[n] = c[n - 1] / -(n as f64);
                n += 1;
            }
            c
        };
        let s = self * (1.0 / 16.0) - 5.0 / 16.0;
        let s2 = s * s;
        let s4 = s2 * s2;
        let low = ((s * C[3] + C[2]) * s2 + (s * C[1] + C[0]))
            + ((s * C[7] + C[6]) * s2 + (s * C[5] + C[4])) * s4;
        let high = ((s * C[11] + C[10]) * s2 + (s * C[9] + C[8])) + s4 * C[12];
        (high * (s4 * s4) + low).square().square().square().square()
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
    fn tiny(self) -> f64 {
        f64::MIN_POSITIVE
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
            assert!(error < 1e-14, "x = {x}: relative error {error:e}");
        }
    }

    #[test]
    fn whole_powers() {
        assert_eq!(Real::powi(3.0, 0), 1.0);
        assert_eq!(Real::powi(3.0, 5), 243.0);
    }
}
