//! Eight particles with two neighbours at once, in f32: [`Real`] for mixed precision.

use std::ops::{Add, Div, Mul, Neg, Sub};

use fearless_simd::{
    Select, Simd, SimdBase, SimdCombine, SimdFloat, SimdInt, f32x8, f32x16, i32x8, i32x16,
    mask32x16,
};

use super::lane::WIDTH;
use crate::real::Real;

/// Sixteen f32, carrying the token `S` of an instruction set.
#[derive(Clone, Copy)]
pub(crate) struct NarrowLane<S: Simd>(f32x16<S>);

/// One coordinate of eight particles, twice, in quanta modulo 2^32.
#[derive(Clone, Copy)]
pub(crate) struct Places<S: Simd>(i32x16<S>);

/// Which lanes are of the second half.
#[derive(Clone, Copy)]
pub(crate) struct Second<S: Simd> {
    simd: S,
    lanes: mask32x16<S>,
}

impl<S: Simd> Second<S> {
    /// `halves` is 0.0 for each lane of the first half and 1.0 for the second.
    ///
    /// A compiler that knew the lanes would build the halves by three shuffles,
    /// which compete with the arithmetic; unknown, a load under a mask does it.
    #[inline(always)]
    pub(crate) fn new(simd: S, halves: [f32; 2 * WIDTH]) -> Self {
        let zero = f32x16::splat(simd, 0.0);
        let lanes = zero.simd_lt(f32x16::load_array(simd, halves));
        Second { simd, lanes }
    }
}

impl<S: Simd> Places<S> {
    #[inline(always)]
    pub(crate) fn twice(simd: S, quanta: [u32; WIDTH]) -> Self {
        let half = i32x8::load_array(simd, quanta.map(u32::cast_signed));
        Places(half.combine(half))
    }

    /// The exact differences to a neighbour for either half, rounded to f32.
    #[inline(always)]
    pub(crate) fn offset(self, second: Second<S>, pair: [u32; 2]) -> NarrowLane<S> {
        let [a, b] = pair.map(|quanta| i32x16::splat(second.simd, quanta.cast_signed()));
        NarrowLane((self.0 - second.lanes.select(b, a)).to_float())
    }
}

impl<S: Simd> NarrowLane<S> {
    #[inline(always)]
    pub(crate) fn splat(simd: S, value: f64) -> Self {
        NarrowLane(f32x16::splat(simd, value as f32))
    }

    /// One value for either half.
    #[inline(always)]
    pub(crate) fn halves(second: Second<S>, pair: [f32; 2]) -> Self {
        let [a, b] = pair.map(|value| f32x16::splat(second.simd, value));
        NarrowLane(second.lanes.select(b, a))
    }

    /// The same values in either half.
    #[inline(always)]
    pub(crate) fn twice(simd: S, values: [f32; WIDTH]) -> Self {
        let half = f32x8::load_array(simd, values);
        NarrowLane(half.combine(half))
    }

    #[inline(always)]
    pub(crate) fn to_array(self) -> [f32; 2 * WIDTH] {
        self.0.to_array()
    }
}

macro_rules! operator {
    ($Trait:ident, $method:ident) => {
        impl<S: Simd> $Trait for NarrowLane<S> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                NarrowLane(self.0.$method(other.0))
            }
        }
        impl<S: Simd> $Trait<f64> for NarrowLane<S> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: f64) -> Self {
                self.$method(Self::splat(self.0.simd, other))
            }
        }
    };
}

operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);

impl<S: Simd> Neg for NarrowLane<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        NarrowLane(-self.0)
    }
}

impl<S: Simd> Real for NarrowLane<S> {
    type Mask = mask32x16<S>;

    #[inline(always)]
    fn literal(self, value: f64) -> Self {
        NarrowLane::splat(self.0.simd, value)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        NarrowLane(self.0.sqrt())
    }
    #[inline(always)]
    fn floor(self) -> Self {
        NarrowLane(self.0.floor())
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        NarrowLane(self.0.min(other.0))
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        NarrowLane(self.0.max(other.0))
    }
    #[inline(always)]
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        NarrowLane(self.0.mul_add(factor.0, addend.0))
    }
    #[inline(always)]
    fn less(self, other: Self) -> Self::Mask {
        self.0.simd_lt(other.0)
    }
    #[inline(always)]
    fn tiny(self) -> Self {
        self.literal(f32::MIN_POSITIVE.into())
    }
    #[inline(always)]
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self {
        NarrowLane(mask.select(yes.0, no.0))
    }
}
