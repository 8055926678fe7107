//! One sweep: a term summed over all pairs of all clusters.
//!
//! Eight particles of a cluster lie in the lanes; the neighbours come one at
//! a time, broadcast from a packed record (position first, then what the
//! term reads). Kernels vanish outside their support, so there is no mask.

use fearless_simd::{Level, Simd};
use rayon::prelude::*;

use super::lane::{Lane, WIDTH};
use super::level::{WithSimd, with_simd};
use super::lists::{CLUSTERS_PER_CHUNK, Chunk};
use crate::particles::Particles;
use crate::term::{Approach, PairTerm, Record, ScaledKernel, Shape};
use crate::vector::Vector;

/// List entries between the prefetched record and the one in use.
const PREFETCH_AHEAD: usize = 64;

/// Reals from one packed record to the next: a whole number of vectors of four.
pub(crate) const fn stride(reals: usize) -> usize {
    reals.next_multiple_of(4)
}

/// Packs position and record of every row into `records`.
pub(crate) fn pack<T: PairTerm<D>, const D: usize>(
    term: &T,
    particles: &Particles<D>,
    records: &mut [f64],
) {
    let stride = stride(D + T::Record::<f64>::LENGTH);
    records
        .par_chunks_exact_mut(stride)
        .with_min_len(1024)
        .enumerate()
        .for_each(|(i, packed)| {
            let position = particles.position[i];
            packed[..D].copy_from_slice(&position.0);
            let mut k = D;
            term.record(particles, i).write(&mut |value| {
                packed[k] = value;
                k += 1;
            });
        });
}

/// Sums `term` for the rows of every cluster for which `active` holds; the
/// others get zero. `records` holds the rows, then the images.
pub(crate) fn run<Q: Shape, T: PairTerm<D>, const D: usize>(
    level: Level,
    term: &T,
    kernel: ScaledKernel<Q>,
    chunks: &[Chunk],
    records: &[f64],
    active: &(impl Fn(std::ops::Range<usize>) -> bool + Sync),
    sums: &mut [T::Sum<f64>],
) {
    sums.par_chunks_mut(WIDTH * CLUSTERS_PER_CHUNK)
        .zip(chunks)
        .enumerate()
        .for_each(|(c, (sums, chunk))| {
            let first = c * WIDTH * CLUSTERS_PER_CHUNK;
            with_simd(
                level,
                Task {
                    term,
                    kernel,
                    chunk,
                    records,
                    active,
                    first,
                    sums,
                },
            );
        });
}

struct Task<'a, Q, T: PairTerm<D>, A, const D: usize> {
    term: &'a T,
    kernel: ScaledKernel<Q>,
    chunk: &'a Chunk,
    records: &'a [f64],
    active: &'a A,
    /// First row of the chunk.
    first: usize,
    /// Sums of its rows.
    sums: &'a mut [T::Sum<f64>],
}

impl<Q: Shape, T: PairTerm<D>, A: Fn(std::ops::Range<usize>) -> bool, const D: usize> WithSimd
    for Task<'_, Q, T, A, D>
{
    #[inline(always)]
    fn run<S: Simd>(mut self, simd: S) {
        let mut start = self.first;
        let sums = std::mem::take(&mut self.sums);
        for (sums, list) in sums.chunks_mut(WIDTH).zip(self.chunk.lists()) {
            let rows = start..start + sums.len();
            start = rows.end;
            if (self.active)(rows.clone()) {
                let sum = self.cluster(simd, rows, list);
                store(&sum, sums);
            } else {
                sums.fill(Record::read(&mut || 0.0));
            }
        }
    }
}

impl<Q: Shape, T: PairTerm<D>, A, const D: usize> Task<'_, Q, T, A, D> {
    #[inline(always)]
    fn approach<S: Simd>(
        &self,
        simd: S,
        position: &Vector<Lane<S>, D>,
        j: u32,
    ) -> Approach<Lane<S>, D> {
        let stride = const { stride(D + <T::Record<f64> as Record<f64>>::LENGTH) };
        let record = &self.records[j as usize * stride..][..D];
        let mut neighbour = *position;
        for d in 0..D {
            neighbour[d] = Lane::splat(simd, record[d]);
        }
        self.kernel.approach::<_, D>(*position - neighbour)
    }

    #[inline(always)]
    fn cluster<S: Simd>(
        &self,
        simd: S,
        rows: std::ops::Range<usize>,
        list: &[u32],
    ) -> T::Sum<Lane<S>> {
        let stride = const { stride(D + <T::Record<f64> as Record<f64>>::LENGTH) };
        let mut column = 0;
        let mut next_lane = || {
            let mut values = [0.0; WIDTH];
            for (lane, value) in values.iter_mut().enumerate() {
                // A last cluster of fewer than eight repeats its last row.
                let row = (rows.start + lane).min(rows.end - 1);
                *value = self.records[row * stride + column];
            }
            column += 1;
            Lane::load(simd, values)
        };
        let position = Vector::<Lane<S>, D>::read(&mut next_lane);
        let own = T::Record::<Lane<S>>::read(&mut next_lane);
        let mut sum = T::Sum::<Lane<S>>::read(&mut || Lane::splat(simd, 0.0));
        // Copies: behind a reference their parameters would be read, and their
        // choices made, anew for each pair, since the prefetch might write.
        let (term, kernel, records) = (*self.term, self.kernel, self.records);
        let Some(&first) = list.first() else {
            return sum;
        };
        let mut next = self.approach(simd, &position, first);
        for (n, &j) in list.iter().enumerate() {
            if let Some(&ahead) = list.get(n + PREFETCH_AHEAD) {
                prefetch(records, ahead as usize * stride, stride);
            }
            let now = next;
            // The root of the next pair runs while this one is worked out.
            next = self.approach(simd, &position, list[(n + 1).min(list.len() - 1)]);
            let record = &records[j as usize * stride..][..stride];
            let mut column = D;
            let other = T::Record::<Lane<S>>::read(&mut || {
                column += 1;
                Lane::splat(simd, record[column - 1])
            });
            let pair = kernel.pair::<_, D>(now);
            term.pair(&own, &other, &pair, &mut sum);
        }
        sum
    }
}

/// Transposes a sum of lanes into one sum per row.
#[inline(always)]
fn store<S: Simd, L: Record<Lane<S>>, F: Record<f64>>(sum: &L, out: &mut [F]) {
    const MOST: usize = 32;
    const { assert!(F::LENGTH <= MOST && F::LENGTH == L::LENGTH) };
    let mut lanes = [[0.0; WIDTH]; MOST];
    let mut column = 0;
    sum.write(&mut |lane: Lane<S>| {
        lanes[column] = lane.to_array();
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

/// Asks for the cache lines of `stride` reals from `start`.
#[inline(always)]
#[allow(unsafe_code)]
fn prefetch(records: &[f64], start: usize, stride: usize) {
    #[cfg(target_arch = "x86_64")]
    {
        use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
        let pointer = records.as_ptr().wrapping_add(start);
        // SAFETY: a prefetch is a hint; it reads nothing and faults on no address.
        unsafe {
            _mm_prefetch::<_MM_HINT_T0>(pointer.cast());
            if stride > 8 {
                _mm_prefetch::<_MM_HINT_T0>(pointer.wrapping_add(8).cast());
            }
        }
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = (records, start, stride);
}
