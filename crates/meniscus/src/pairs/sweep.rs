//! One sweep: a term summed over all pairs of all clusters.
//!
//! The particles of a cluster lie in the lanes; the neighbours come one at a
//! time, broadcast from a packed record (position first, then what the term
//! reads). Kernels vanish outside their support, so there is no mask.

use std::ops::Range;

use fearless_simd::{Level, Simd};

use super::arithmetic::Arithmetic;
use super::entries::PADDING;
use super::lane::WIDTH;
use super::level::{InstructionSets, WithSimd};
use super::lists::{Chunk, ROWS_PER_CHUNK};
use super::parallel::for_each_part;
use super::records::Records;
use super::summing::Active;
use crate::term::{Approach, PairTerm, Record, ScaledKernel, Shape};
use crate::vector::Vector;

/// List entries between the prefetched record and the one in use.
const PREFETCH_AHEAD: usize = 64;
/// Entries that one turn of the loop may look at.
const WINDOW: usize = PREFETCH_AHEAD + 2;
const _: () = assert!(WINDOW + 2 <= PADDING);

/// Sums `term` for the rows of every cluster for which `active` holds; the
/// others get zero, with instructions that `level` must have. `records` holds the rows, then the images.
pub(crate) fn run<I: InstructionSets, N: Arithmetic, Q: Shape, T: PairTerm<D>, const D: usize>(
    level: Level,
    term: &T,
    kernel: ScaledKernel<Q>,
    chunks: &[Chunk],
    records: Records<'_, N, T, D>,
    active: Active<'_>,
    sums: &mut [T::Sum<f64>],
) {
    for_each_part(sums, ROWS_PER_CHUNK, &|c, sums| {
        let (chunk, first) = (&chunks[c], c * ROWS_PER_CHUNK);
        assert!(chunk.bound().max(first + sums.len()) <= records.len());
        let task = Task {
            term,
            kernel,
            chunk,
            records,
            active,
            first,
            sums,
        };
        let done = I::run(level, task);
        debug_assert!(done.is_ok(), "the caller has looked at the level");
    });
}

struct Task<'a, N: Arithmetic, Q, T: PairTerm<D>, const D: usize> {
    term: &'a T,
    kernel: ScaledKernel<Q>,
    chunk: &'a Chunk,
    records: Records<'a, N, T, D>,
    active: Active<'a>,
    /// First row of the chunk.
    first: usize,
    /// Sums of its rows.
    sums: &'a mut [T::Sum<f64>],
}

impl<N, Q, T, const D: usize> WithSimd for Task<'_, N, Q, T, D>
where
    N: Arithmetic,
    Q: Shape,
    T: PairTerm<D>,
{
    #[inline(always)]
    fn run<S: Simd>(mut self, simd: S) {
        let all = std::mem::take(&mut self.sums);
        for (rows, list) in self.chunk.clusters() {
            let sums = &mut all[rows.clone()];
            let rows = self.first + rows.start..self.first + rows.end;
            if (self.active)(rows.clone()) {
                let sum = self.cluster(simd, rows, list);
                store::<N, S, _, _>(&sum, sums);
            } else {
                sums.fill(Record::read(&mut || 0.0));
            }
        }
    }
}

impl<N: Arithmetic, Q: Shape, T: PairTerm<D>, const D: usize> Task<'_, N, Q, T, D> {
    #[inline(always)]
    #[allow(unsafe_code)]
    fn cluster<S: Simd>(
        &self,
        simd: S,
        rows: Range<usize>,
        list: Range<usize>,
    ) -> T::Sum<N::Lane<S>> {
        // Copies: behind a reference their parameters would be read, and their
        // choices made, anew for each pair, since the prefetch might write.
        let (term, kernel, records) = (*self.term, self.kernel, self.records);
        let mut sum = T::Sum::<N::Lane<S>>::read(&mut || N::splat(simd, 0.0));
        if list.is_empty() {
            return sum;
        }
        let place: [N::Place<S>; D] =
            std::array::from_fn(|d| N::load_place(simd, records.column(&rows, d)));
        let share = if Q::MAY_VARY {
            N::load(simd, records.own_shares(&rows))
        } else {
            N::splat(simd, 0.0)
        };
        let mut column = D;
        let own = T::Record::<N::Lane<S>>::read(&mut || {
            column += 1;
            N::load(simd, records.column(&rows, column - 1))
        });
        let entries = &self.chunk.entries().padded()[list.start..][..list.len() + PADDING];
        let nobody = records.out_of_reach(rows.start);
        // Where the last neighbour has no partner.
        let lonely = if list.len().is_multiple_of(N::AT_ONCE) {
            usize::MAX
        } else {
            list.len() - 1
        };
        let halves = records.arithmetic.halves(simd);
        let own_place = OwnPlace { place, share };
        // SAFETY: `run` has seen that every entry, and the zeros behind them, are records.
        let mut next = unsafe {
            let pair = records.pair(&entries[..2], &nobody, lonely == 0);
            approach(simd, halves, records, &kernel, &own_place, entries, pair)
        };
        let windows = entries.windows(WINDOW).step_by(N::AT_ONCE);
        for (n, window) in (0..list.len()).step_by(N::AT_ONCE).zip(windows) {
            let those = &window[N::AT_ONCE..];
            for entry in &those[PREFETCH_AHEAD - N::AT_ONCE..][..N::AT_ONCE] {
                records.prefetch(*entry);
            }
            let now = next;
            // The root of the next pair runs while this one is worked out.
            // SAFETY: as above.
            next = unsafe {
                let pair = records.pair(&those[..2], &nobody, lonely == n + N::AT_ONCE);
                approach(simd, halves, records, &kernel, &own_place, those, pair)
            };
            // SAFETY: as above.
            let pair = unsafe { records.pair(&window[..2], &nobody, lonely == n) };
            let mut column = D;
            let other = T::Record::<N::Lane<S>>::read(&mut || {
                column += 1;
                N::broadcast(halves, pair.map(|record| record[column - 1]))
            });
            let pair = kernel.pair::<_, D>(now);
            term.pair(&own, &other, &pair, &mut sum);
        }
        sum
    }
}

/// Where the particles of a cluster are, and their shares in the smoothing length if it varies.
struct OwnPlace<P, L, const D: usize> {
    place: [P; D],
    share: L,
}

/// The distance of a neighbour, or of the next two entries, from the particles at `own`.
///
/// # Safety
/// The first two entries must be records.
#[inline(always)]
#[allow(unsafe_code)]
unsafe fn approach<N: Arithmetic, S: Simd, Q: Shape, T: PairTerm<D>, const D: usize>(
    simd: S,
    halves: N::Halves<S>,
    records: Records<'_, N, T, D>,
    kernel: &ScaledKernel<Q>,
    own: &OwnPlace<N::Place<S>, N::Lane<S>, D>,
    entries: &[u32],
    pair: [&[N::Packed]; 2],
) -> Approach<N::Lane<S>, D> {
    let mut offset = Vector([N::splat(simd, 0.0); D]);
    for d in 0..D {
        let there = pair.map(|record| record[d]);
        offset[d] = (records.arithmetic).offset(halves, own.place[d], there);
    }
    kernel.approach::<_, D>(
        offset,
        #[inline(always)]
        || {
            // SAFETY: the caller has seen that these are records.
            let shares = unsafe { records.shares([entries[0], entries[1]]) };
            own.share + N::broadcast(halves, shares)
        },
    )
}

/// Transposes a sum of lanes into one sum per row.
#[inline(always)]
fn store<N: Arithmetic, S: Simd, L: Record<N::Lane<S>>, F: Record<f64>>(sum: &L, out: &mut [F]) {
    const MOST: usize = 32;
    const { assert!(F::LENGTH <= MOST && F::LENGTH == L::LENGTH) };
    let mut lanes = [[0.0; WIDTH]; MOST];
    let mut column = 0;
    sum.write(&mut |lane: N::Lane<S>| {
        lanes[column] = N::gather(lane);
        column += 1;
    });
    for (row, out) in out.iter_mut().enumerate() {
        let mut column = 0;
        *out = F::read(&mut || {
            let value = lanes[column][row];
            column += 1;
            value
        });
    }
}
