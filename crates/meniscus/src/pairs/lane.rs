//! Eight particles at once: [`Real`] over a SIMD vector.
//!
//! The width is eight on every machine, so that sums run in the same order
//! and give the same bits whether the processor has AVX-512, AVX2 or neither.

use std::ops::{Add, Div, Mul, Neg, Sub};

use fearless_simd::{Select, Simd, SimdBase, SimdFloat, SimdMask, f64x8, mask64x8};

use crate::real::Real;

/// Number of particles in a lane.
pub(crate) const WIDTH: usize = 8;

/// Eight f64, carrying the token `S` of an instruction set.
#[derive(Clone, Copy)]
pub(crate) struct Lane<S: Simd>(f64x8<S>);

impl<S: Simd> Lane<S> {
    #[inline(always)]
    pub(crate) fn splat(simd: S, value: f64) -> Self {
        Lane(f64x8::splat(simd, value))
    }

    #[inline(always)]
    pub(crate) fn load(simd: S, values: [f64; WIDTH]) -> Self {
        Lane(f64x8::load_array(simd, values))
    }

    /// The first eight of `values`.
    #[inline(always)]
    pub(crate) fn load_slice(simd: S, values: &[f64]) -> Self {
        Lane(f64x8::from_slice(simd, &values[..WIDTH]))
    }

    /// Bits of the lanes that are at most those of `other`.
    #[inline(always)]
    pub(crate) fn not_above(self, other: Self) -> u8 {
        self.0.simd_le(other.0).to_bitmask() as u8
    }

    #[inline(always)]
    pub(crate) fn to_array(self) -> [f64; WIDTH] {
        self.0.to_array()
    }
}

macro_rules! operator {
    ($Trait:ident, $method:ident) => {
        impl<S: Simd> $Trait for Lane<S> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Lane(self.0.$method(other.0))
            }
        }
        impl<S: Simd> $Trait<f64> for Lane<S> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: f64) -> Self {
                let other = f64x8::splat(self.0.simd, other);
                Lane(self.0.$method(other))
            }
        }
    };
}

operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);

impl<S: Simd> Neg for Lane<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Lane(-self.0)
    }
}

impl<S: Simd> Real for Lane<S> {
    type Mask = mask64x8<S>;

    #[inline(always)]
    fn literal(self, value: f64) -> Self {
        Lane::splat(self.0.simd, value)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Lane(self.0.sqrt())
    }
    #[inline(always)]
    fn floor(self) -> Self {
        Lane(self.0.floor())
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Lane(self.0.min(other.0))
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Lane(self.0.max(other.0))
    }
    #[inline(always)]
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        Lane(self.0.mul_add(factor.0, addend.0))
    }
    #[inline(always)]
    fn less(self, other: Self) -> Self::Mask {
        self.0.simd_lt(other.0)
    }
    #[inline(always)]
    fn tiny(self) -> Self {
        self.literal(f64::MIN_POSITIVE)
    }
    #[inline(always)]
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self {
        Lane(mask.select(yes.0, no.0))
    }
}
