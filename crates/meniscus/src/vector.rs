//! A vector of `D` components over any [`Real`].

use std::ops::{Add, AddAssign, Index, IndexMut, Mul, Neg, Sub, SubAssign};

use crate::real::Real;

/// A vector of `D` components.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vector<R, const D: usize>(pub [R; D]);

impl<const D: usize> Vector<f64, D> {
    /// The zero vector.
    pub const ZERO: Self = Vector([0.0; D]);

    /// Euclidean length.
    pub fn norm(&self) -> f64 {
        self.dot(self).sqrt()
    }

    /// The same components in three dimensions, missing ones zero.
    pub fn to_3d(&self) -> [f64; 3] {
        std::array::from_fn(|d| if d < D { self.0[d] } else { 0.0 })
    }

    /// The first `D` of three components.
    pub fn from_3d(v: [f64; 3]) -> Self {
        Vector(std::array::from_fn(|d| v[d]))
    }
}

impl<const D: usize> Default for Vector<f64, D> {
    fn default() -> Self {
        Self::ZERO
    }
}

impl<R: Real, const D: usize> Vector<R, D> {
    /// Scalar product.
    #[inline(always)]
    pub fn dot(&self, other: &Self) -> R {
        let mut sum = self.0[0] * other.0[0];
        for d in 1..D {
            sum = self.0[d].mul_add(other.0[d], sum);
        }
        sum
    }

    /// Scalar product with itself.
    #[inline(always)]
    pub fn norm_squared(&self) -> R {
        self.dot(self)
    }

    /// `self + other * factor`.
    #[inline(always)]
    pub fn add_scaled(self, other: Self, factor: R) -> Self {
        self.zip(other, |a, b| b.mul_add(factor, a))
    }

    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(R, R) -> R) -> Self {
        let mut out = self;
        for d in 0..D {
            out.0[d] = f(self.0[d], other.0[d]);
        }
        out
    }
}

impl<R: Real, const D: usize> Add for Vector<R, D> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.zip(other, |a, b| a + b)
    }
}

impl<R: Real, const D: usize> Sub for Vector<R, D> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.zip(other, |a, b| a - b)
    }
}

impl<R: Real, const D: usize> AddAssign for Vector<R, D> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<R: Real, const D: usize> SubAssign for Vector<R, D> {
    #[inline(always)]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl<R: Real, const D: usize> Mul<R> for Vector<R, D> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: R) -> Self {
        self.zip(self, |a, _| a * factor)
    }
}

impl<R: Real, const D: usize> Neg for Vector<R, D> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.zip(self, |a, _| -a)
    }
}

impl<R, const D: usize> Index<usize> for Vector<R, D> {
    type Output = R;
    #[inline(always)]
    fn index(&self, d: usize) -> &R {
        &self.0[d]
    }
}

impl<R, const D: usize> IndexMut<usize> for Vector<R, D> {
    #[inline(always)]
    fn index_mut(&mut self, d: usize) -> &mut R {
        &mut self.0[d]
    }
}
