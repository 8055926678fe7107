//! What physics hands to the pair engine: a formula for one pair.
//!
//! A [`PairTerm`] says what it reads from a particle (its record), what it
//! adds up (its sum), and the formula of one pair, written over any
//! [`Real`]. The engine decides whether that is one number or a lane of
//! eight, which pairs are near, and on which thread.

use std::marker::PhantomData;

use crate::kernel::{Kernel, SmoothingKernel, with_kernel};
use crate::particles::Particles;
use crate::real::Real;
use crate::smoothing::Smoothing;
use crate::vector::Vector;

/// A fixed number of reals with names: what a pair reads or adds up.
///
/// Implemented for nothing, one real, a [`Vector`], pairs of records, and by
/// [`record!`](crate::record) for structs.
pub trait Record<R: Real>: Copy + Send + Sync {
    /// How many reals it holds.
    const LENGTH: usize;
    /// Builds it from its reals, asked for in order.
    fn read(next: &mut impl FnMut() -> R) -> Self;
    /// Hands out its reals, in the same order.
    fn write(&self, put: &mut impl FnMut(R));
}

impl<R: Real> Record<R> for R {
    const LENGTH: usize = 1;
    #[inline(always)]
    fn read(next: &mut impl FnMut() -> R) -> Self {
        next()
    }
    #[inline(always)]
    fn write(&self, put: &mut impl FnMut(R)) {
        put(*self);
    }
}

impl<R: Real> Record<R> for () {
    const LENGTH: usize = 0;
    #[inline(always)]
    fn read(_: &mut impl FnMut() -> R) {}
    #[inline(always)]
    fn write(&self, _: &mut impl FnMut(R)) {}
}

impl<R: Real, A: Record<R>, B: Record<R>> Record<R> for (A, B) {
    const LENGTH: usize = A::LENGTH + B::LENGTH;
    #[inline(always)]
    fn read(next: &mut impl FnMut() -> R) -> Self {
        let first = A::read(next);
        (first, B::read(next))
    }
    #[inline(always)]
    fn write(&self, put: &mut impl FnMut(R)) {
        self.0.write(put);
        self.1.write(put);
    }
}

impl<R: Real, const D: usize> Record<R> for Vector<R, D> {
    const LENGTH: usize = D;
    #[inline(always)]
    fn read(next: &mut impl FnMut() -> R) -> Self {
        let mut components = [next(); D];
        for component in components.iter_mut().skip(1) {
            *component = next();
        }
        Vector(components)
    }
    #[inline(always)]
    fn write(&self, put: &mut impl FnMut(R)) {
        for d in 0..D {
            put(self.0[d]);
        }
    }
}

/// Declares a struct of reals and vectors, generic over `R: Real` and the
/// dimension `D`, that a [`PairTerm`](crate::PairTerm) can use as record or sum.
///
/// ```
/// meniscus::record! {
///     /// Velocity (m/s) and volume (m^D).
///     pub struct Moving<R, D> {
///         /// m/s
///         velocity: meniscus::Vector<R, D>,
///         /// m^D
///         volume: R,
///     }
/// }
/// ```
#[macro_export]
macro_rules! record {
    ($(#[$doc:meta])* $vis:vis struct $Name:ident<$R:ident, $D:ident> {
        $($(#[$field_doc:meta])* $field:ident: $Type:ty),+ $(,)?
    }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        $vis struct $Name<$R, const $D: usize> {
            $($(#[$field_doc])* pub $field: $Type,)+
        }
        impl<$R: $crate::Real, const $D: usize> $crate::term::Record<$R> for $Name<$R, $D> {
            const LENGTH: usize = 0 $(+ <$Type as $crate::term::Record<$R>>::LENGTH)+;
            #[inline(always)]
            fn read(next: &mut impl FnMut() -> $R) -> Self {
                $(let $field = <$Type as $crate::term::Record<$R>>::read(next);)+
                Self { $($field),+ }
            }
            #[inline(always)]
            fn write(&self, put: &mut impl FnMut($R)) {
                $($crate::term::Record::<$R>::write(&self.$field, put);)+
            }
        }
    };
}

/// The geometry of one pair.
#[derive(Clone, Copy, Debug)]
pub struct Pair<R, const D: usize> {
    /// x_i - x_j, m
    pub offset: Vector<R, D>,
    /// |x_i - x_j|^2, m^2
    pub distance_squared: R,
    /// W_ij, 1/m^D
    pub w: R,
    /// Gradient of W_ij with respect to x_i, 1/m^(D+1); zero for i = j
    pub grad_w: Vector<R, D>,
    /// (1/r) dW/dr, 1/m^(D+2): `grad_w` is `offset` times this
    pub slope_over_distance: R,
}

/// The shape of a kernel, compiled in ([`Compiled`]) or chosen at run time
/// ([`Kernel`]: well-predicted branches for each pair, and a sixth of the code).
pub(crate) trait Shape: Copy + Send + Sync {
    /// Whether the smoothing length may be another for each pair.
    const MAY_VARY: bool;
    /// What `shape` and `slope_over_q` want, from q^2.
    fn argument<R: Real>(self, square: R) -> R;
    /// The same from r^2 and 1/h: root and reciprocal need not wait for each other.
    fn argument_of<R: Real>(self, distance_squared: R, inverse_h: R) -> R;
    fn shape<R: Real>(self, argument: R) -> R;
    fn slope_over_q<R: Real>(self, argument: R) -> R;
}

/// A kernel known to the compiler.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Compiled<K>(pub(crate) PhantomData<K>);

impl<K: SmoothingKernel> Shape for Compiled<K> {
    const MAY_VARY: bool = false;

    #[inline(always)]
    fn argument<R: Real>(self, square: R) -> R {
        if K::FROM_SQUARE {
            square
        } else {
            square.sqrt()
        }
    }
    #[inline(always)]
    fn argument_of<R: Real>(self, distance_squared: R, inverse_h: R) -> R {
        if K::FROM_SQUARE {
            distance_squared * inverse_h.square()
        } else {
            distance_squared.sqrt() * inverse_h
        }
    }
    #[inline(always)]
    fn shape<R: Real>(self, argument: R) -> R {
        if K::FROM_SQUARE {
            K::shape_from_square(argument)
        } else {
            K::shape(argument)
        }
    }
    #[inline(always)]
    fn slope_over_q<R: Real>(self, argument: R) -> R {
        if K::FROM_SQUARE {
            K::slope_over_q_from_square(argument)
        } else {
            K::slope_over_q(argument)
        }
    }
}

impl Shape for Kernel {
    const MAY_VARY: bool = true;

    #[inline(always)]
    fn argument<R: Real>(self, square: R) -> R {
        with_kernel!(self, K => Compiled::<K>(PhantomData).argument(square))
    }
    #[inline(always)]
    fn argument_of<R: Real>(self, distance_squared: R, inverse_h: R) -> R {
        with_kernel!(self, K => Compiled::<K>(PhantomData).argument_of(distance_squared, inverse_h))
    }
    #[inline(always)]
    fn shape<R: Real>(self, argument: R) -> R {
        with_kernel!(self, K => Compiled::<K>(PhantomData).shape(argument))
    }
    #[inline(always)]
    fn slope_over_q<R: Real>(self, argument: R) -> R {
        with_kernel!(self, K => Compiled::<K>(PhantomData).slope_over_q(argument))
    }
}

/// The distance of a pair, before the kernel is evaluated.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Approach<R, const D: usize> {
    offset: Vector<R, D>,
    distance_squared: R,
    argument: R,
    /// 1/h_ij, 1/m, where it varies.
    inverse_h: R,
}

/// A kernel with its smoothing length worked into factors.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ScaledKernel<Q> {
    shape: Q,
    /// Whether each pair has a smoothing length of its own; the factors are those of one metre then.
    varies: bool,
    inverse_h_squared: f64,
    value_factor: f64,
    slope_factor: f64,
}

impl ScaledKernel<Kernel> {
    pub(crate) fn new(kernel: Kernel, smoothing_length: f64, dimension: usize) -> Self {
        let value_factor =
            kernel.normalisation(dimension) / smoothing_length.powi(dimension as i32);
        Self {
            shape: kernel,
            varies: false,
            inverse_h_squared: 1.0 / (smoothing_length * smoothing_length),
            value_factor,
            slope_factor: value_factor / (smoothing_length * smoothing_length),
        }
    }

    /// With a smoothing length that each pair brings along.
    pub(crate) fn varying(kernel: Kernel, dimension: usize) -> Self {
        Self {
            varies: true,
            ..Self::new(kernel, 1.0, dimension)
        }
    }

    /// Whether each pair has a smoothing length of its own.
    pub(crate) fn varies(&self) -> bool {
        self.varies
    }

    /// The same with its shape compiled in, which must be that of the kernel; for one smoothing length.
    pub(crate) fn compiled<K: SmoothingKernel>(self) -> ScaledKernel<Compiled<K>> {
        let Self {
            varies,
            inverse_h_squared,
            value_factor,
            slope_factor,
            ..
        } = self;
        ScaledKernel {
            shape: Compiled(PhantomData),
            varies,
            inverse_h_squared,
            value_factor,
            slope_factor,
        }
    }
}

impl<Q: Shape> ScaledKernel<Q> {
    /// The first half of [`pair`](Self::pair), with its slow root, for an early start.
    /// `smoothing_length` is asked for where it varies.
    #[inline(always)]
    pub(crate) fn approach<R: Real, const D: usize>(
        &self,
        offset: Vector<R, D>,
        smoothing_length: impl FnOnce() -> R,
    ) -> Approach<R, D> {
        let distance_squared = offset.norm_squared();
        let (inverse_h, argument) = if Q::MAY_VARY && self.varies {
            let inverse_h = distance_squared.literal(1.0) / smoothing_length();
            let argument = self.shape.argument_of(distance_squared, inverse_h);
            (inverse_h, argument)
        } else {
            let square = distance_squared * self.inverse_h_squared;
            (distance_squared, self.shape.argument(square))
        };
        Approach {
            offset,
            distance_squared,
            argument,
            inverse_h,
        }
    }

    #[inline(always)]
    pub(crate) fn pair<R: Real, const D: usize>(&self, approach: Approach<R, D>) -> Pair<R, D> {
        let Approach {
            offset,
            distance_squared,
            argument,
            inverse_h,
        } = approach;
        let mut w = self.shape.shape(argument) * self.value_factor;
        let mut slope_over_distance = self.shape.slope_over_q(argument) * self.slope_factor;
        if Q::MAY_VARY && self.varies {
            let square = inverse_h.square();
            let power = if D == 3 { square * inverse_h } else { square };
            w = w * power;
            slope_over_distance = slope_over_distance * (power * square);
        }
        Pair {
            offset,
            distance_squared,
            w,
            grad_w: offset * slope_over_distance,
            slope_over_distance,
        }
    }
}

/// One term of an equation, as a sum over neighbours.
///
/// The sum runs over all particles within the kernel's support, the particle
/// itself included. The formula must give zero, by its factor W or grad W,
/// for a pair outside the support, and finite values for two particles at
/// the same place. A term is `Copy`: a few numbers, and references to columns.
pub trait PairTerm<const D: usize>: Copy + Sync {
    /// What the formula reads from either particle.
    type Record<R: Real>: Record<R>;
    /// What is added up over the neighbours.
    type Sum<R: Real>: Record<R>;
    /// Whether many runs sum it in every step. If not, it has no code of its own for the
    /// default kernel, nor for mixed precision, where it is summed in double: a fraction of the
    /// machine code, for some speed.
    const OFTEN: bool = true;

    /// The record of particle `i`.
    fn record(&self, particles: &Particles<D>, i: usize) -> Self::Record<f64>;

    /// Adds the pair (i, j) to the sum of particle i.
    fn pair<R: Real>(
        &self,
        i: &Self::Record<R>,
        j: &Self::Record<R>,
        ij: &Pair<R, D>,
        sum: &mut Self::Sum<R>,
    );
}

/// Sums a term over the neighbours: the engine, or the O(N^2) reference.
pub trait Sweep<const D: usize> {
    /// Sums `term` for every particle of each range of rows that `active`
    /// holds for, and zero for the others.
    fn sweep<T: PairTerm<D>>(
        &mut self,
        term: &T,
        particles: &Particles<D>,
        active: impl Fn(std::ops::Range<usize>) -> bool + Sync,
        sums: &mut Vec<T::Sum<f64>>,
    );
}

/// Sums a term with another smoothing length than the usual.
pub trait SweepWith<const D: usize>: Sweep<D> {
    /// [`sweep`](Sweep::sweep) with this smoothing length, which the lists must be long enough for:
    /// not above the usual one of any pair, or one that they are known to hold.
    fn sweep_with<T: PairTerm<D>>(
        &mut self,
        smoothing: Smoothing,
        term: &T,
        particles: &Particles<D>,
        active: impl Fn(std::ops::Range<usize>) -> bool + Sync,
        sums: &mut Vec<T::Sum<f64>>,
    );
}
