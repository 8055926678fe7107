//! In what numbers a sweep reckons: f64 throughout, or f32 for the pairs.
//!
//! The state is f64 in either case, and so is its march in time.
//! [`Precision::Mixed`] packs positions for each sweep as whole multiples of a
//! quantum, 2^-26 of the kernel's support, modulo 2^32. The difference of two
//! such numbers is exact, and right for any two particles less than 32 supports
//! apart, however large the domain is: only then it becomes an f32.

use fearless_simd::Simd;

use super::lane::{Lane, WIDTH};
use super::level::{Every, Fused, InstructionSets};
use super::narrow_lane::{NarrowLane, Places, Second};
use crate::real::Real;
use crate::vector::Vector;

/// In what numbers the pairs are worked out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Precision {
    /// f64 throughout
    #[default]
    Double,
    /// State and time integration in f64, exact differences of positions, formulas of pairs in f32
    Mixed,
}

/// How records are packed, and how a cluster reckons with them.
///
/// In f32 a vector has twice as many lanes as a cluster has particles. The
/// second half holds the cluster once more, and meets another neighbour.
pub(crate) trait Arithmetic: Copy + Sync {
    /// Neighbours that a cluster meets at once.
    const AT_ONCE: usize;
    /// Those it is compiled for.
    type InstructionSets: InstructionSets;
    /// One number of a packed record.
    type Packed: Copy + Default + Send + Sync;
    /// A quantity of each particle of a cluster.
    type Lane<S: Simd>: Real;
    /// One coordinate of each particle of a cluster.
    type Place<S: Simd>: Copy;
    /// What it takes to lay two neighbours into one vector.
    type Halves<S: Simd>: Copy;

    fn pack(value: f64) -> Self::Packed;
    fn pack_coordinate(self, x: f64) -> Self::Packed;
    /// A coordinate out of reach of any cluster with a particle at `packed`.
    fn out_of_reach(packed: Self::Packed) -> Self::Packed;
    fn splat<S: Simd>(simd: S, value: f64) -> Self::Lane<S>;
    /// The same number of two neighbours. Where only one is met at once, the second is not used.
    fn broadcast<S: Simd>(halves: Self::Halves<S>, pair: [Self::Packed; 2]) -> Self::Lane<S>;
    fn halves<S: Simd>(self, simd: S) -> Self::Halves<S>;
    fn load<S: Simd>(simd: S, packed: [Self::Packed; WIDTH]) -> Self::Lane<S>;
    fn load_place<S: Simd>(simd: S, packed: [Self::Packed; WIDTH]) -> Self::Place<S>;
    /// x_i - x_j, m
    fn offset<S: Simd>(
        self,
        halves: Self::Halves<S>,
        own: Self::Place<S>,
        pair: [Self::Packed; 2],
    ) -> Self::Lane<S>;
    /// Sums of each particle of a cluster, over what both halves met.
    fn gather<S: Simd>(sum: Self::Lane<S>) -> [f64; WIDTH];

    /// Packs a position into the first numbers of a record.
    fn pack_position<const D: usize>(self, x: &Vector<f64, D>, packed: &mut [Self::Packed]) {
        for d in 0..D {
            packed[d] = self.pack_coordinate(x[d]);
        }
    }
}

/// [`Precision::Double`]
#[derive(Clone, Copy, Debug)]
pub(crate) struct Double;

impl Arithmetic for Double {
    const AT_ONCE: usize = 1;
    type InstructionSets = Every;
    type Packed = f64;
    type Lane<S: Simd> = Lane<S>;
    type Place<S: Simd> = Lane<S>;
    type Halves<S: Simd> = S;

    #[inline(always)]
    fn pack(value: f64) -> f64 {
        value
    }
    #[inline(always)]
    fn pack_coordinate(self, x: f64) -> f64 {
        x
    }
    #[inline(always)]
    fn out_of_reach(_: f64) -> f64 {
        f64::MAX
    }
    #[inline(always)]
    fn splat<S: Simd>(simd: S, value: f64) -> Lane<S> {
        Lane::splat(simd, value)
    }
    #[inline(always)]
    fn broadcast<S: Simd>(simd: S, [value, _]: [f64; 2]) -> Lane<S> {
        Lane::splat(simd, value)
    }
    #[inline(always)]
    fn halves<S: Simd>(self, simd: S) -> S {
        simd
    }
    #[inline(always)]
    fn load<S: Simd>(simd: S, packed: [f64; WIDTH]) -> Lane<S> {
        Lane::load(simd, packed)
    }
    #[inline(always)]
    fn load_place<S: Simd>(simd: S, packed: [f64; WIDTH]) -> Lane<S> {
        Lane::load(simd, packed)
    }
    #[inline(always)]
    fn offset<S: Simd>(self, simd: S, own: Lane<S>, [other, _]: [f64; 2]) -> Lane<S> {
        own - Lane::splat(simd, other)
    }
    #[inline(always)]
    fn gather<S: Simd>(sum: Lane<S>) -> [f64; WIDTH] {
        sum.to_array()
    }
}

/// [`Precision::Mixed`]
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mixed {
    /// m
    quantum: f64,
    inverse_quantum: f64,
    /// See [`Second::new`].
    halves: [f32; 2 * WIDTH],
}

impl Mixed {
    /// For a kernel that reaches `support` metres.
    pub(crate) fn new(support: f64) -> Self {
        let parts = f64::from(1 << 26);
        Self {
            quantum: support / parts,
            inverse_quantum: parts / support,
            halves: std::array::from_fn(|lane| if lane < WIDTH { 0.0 } else { 1.0 }),
        }
    }
}

impl Arithmetic for Mixed {
    const AT_ONCE: usize = 2;
    type InstructionSets = Fused;
    type Packed = u32;
    type Lane<S: Simd> = NarrowLane<S>;
    type Place<S: Simd> = Places<S>;
    type Halves<S: Simd> = Second<S>;

    #[inline(always)]
    fn pack(value: f64) -> u32 {
        (value as f32).to_bits()
    }
    #[inline(always)]
    fn pack_coordinate(self, x: f64) -> u32 {
        // The cast to i64 rounds towards zero, that to u32 is modulo 2^32.
        (x * self.inverse_quantum) as i64 as u32
    }
    #[inline(always)]
    fn out_of_reach(packed: u32) -> u32 {
        packed.wrapping_add(1 << 31)
    }
    #[inline(always)]
    fn splat<S: Simd>(simd: S, value: f64) -> NarrowLane<S> {
        NarrowLane::splat(simd, value)
    }
    #[inline(always)]
    fn broadcast<S: Simd>(second: Second<S>, pair: [u32; 2]) -> NarrowLane<S> {
        NarrowLane::halves(second, pair.map(f32::from_bits))
    }
    #[inline(always)]
    fn halves<S: Simd>(self, simd: S) -> Second<S> {
        Second::new(simd, self.halves)
    }
    #[inline(always)]
    fn load<S: Simd>(simd: S, packed: [u32; WIDTH]) -> NarrowLane<S> {
        NarrowLane::twice(simd, packed.map(f32::from_bits))
    }
    #[inline(always)]
    fn load_place<S: Simd>(simd: S, packed: [u32; WIDTH]) -> Places<S> {
        Places::twice(simd, packed)
    }
    #[inline(always)]
    fn offset<S: Simd>(self, second: Second<S>, own: Places<S>, pair: [u32; 2]) -> NarrowLane<S> {
        own.offset(second, pair) * self.quantum
    }
    #[inline(always)]
    fn gather<S: Simd>(sum: NarrowLane<S>) -> [f64; WIDTH] {
        let halves = sum.to_array().map(f64::from);
        std::array::from_fn(|k| halves[k] + halves[k + WIDTH])
    }
}
