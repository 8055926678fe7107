//! What a sweep reads of every particle, packed: its position, then the record
//! of the term, then nothing up to a whole vector. Behind the last row stand the shares of
//! all in the smoothing length, where that varies: beside the positions they would take
//! many a record over the end of its vector.

use std::marker::PhantomData;
use std::ops::Range;

use super::arithmetic::Arithmetic;
use super::buffer::LineBuffer;
use super::images::Image;
use super::lane::WIDTH;
use super::parallel::for_each_part;
use crate::particles::Particles;
use crate::smoothing::Smoothing;
use crate::term::{PairTerm, Record};

/// Rows, or images, that one task packs.
const ROWS_PER_TASK: usize = 1024;

/// Most numbers of a record.
pub(crate) const MOST_REALS: usize = 64;

/// Packed records of a term: of the rows, then of the images.
pub(crate) struct Records<'a, N: Arithmetic, T, const D: usize> {
    pub(crate) arithmetic: N,
    numbers: &'a [N::Packed],
    /// As many as records; of no meaning where the smoothing length is constant.
    shares: &'a [N::Packed],
    term: PhantomData<T>,
}

impl<N: Arithmetic, T, const D: usize> Clone for Records<'_, N, T, D> {
    #[inline(always)]
    fn clone(&self) -> Self {
        *self
    }
}

impl<N: Arithmetic, T, const D: usize> Copy for Records<'_, N, T, D> {}

/// Packs records of all rows and images of `term` into `buffer`.
pub(crate) fn pack<'a, N: Arithmetic, T: PairTerm<D>, const D: usize>(
    arithmetic: N,
    smoothing: Smoothing,
    term: &T,
    particles: &Particles<D>,
    images: &[Image<D>],
    buffer: &'a mut LineBuffer<N::Packed>,
) -> Records<'a, N, T, D> {
    let stride = Records::<N, T, D>::STRIDE;
    let count = particles.len() + images.len();
    let (numbers, shares) = buffer
        .take(count * (stride + 1))
        .split_at_mut(count * stride);
    let (own, shifted) = numbers.split_at_mut(particles.len() * stride);
    for_each_part(own, ROWS_PER_TASK * stride, &|part, own| {
        let rows = part * ROWS_PER_TASK..;
        for (packed, i) in own.chunks_exact_mut(stride).zip(rows) {
            arithmetic.pack_position(&particles.position[i], packed);
            let mut k = D;
            term.record(particles, i).write(&mut |value| {
                packed[k] = N::pack(value);
                k += 1;
            });
        }
    });
    for_each_part(shifted, ROWS_PER_TASK * stride, &|part, shifted| {
        let images = &images[part * ROWS_PER_TASK..];
        for (packed, image) in shifted.chunks_exact_mut(stride).zip(images) {
            let source = image.source as usize;
            packed.copy_from_slice(&own[source * stride..][..stride]);
            arithmetic.pack_position(&(particles.position[source] + image.shift), packed);
        }
    });
    if matches!(smoothing, Smoothing::Mean { .. }) {
        let (own, shifted) = shares.split_at_mut(particles.len());
        for_each_part(own, ROWS_PER_TASK, &|part, own| {
            for (share, row) in own.iter_mut().zip(part * ROWS_PER_TASK..) {
                *share = N::pack(smoothing.share(particles, row));
            }
        });
        for (share, image) in shifted.iter_mut().zip(images) {
            *share = own[image.source as usize];
        }
    }
    Records {
        arithmetic,
        numbers,
        shares,
        term: PhantomData,
    }
}

impl<N: Arithmetic, T: PairTerm<D>, const D: usize> Records<'_, N, T, D> {
    /// Numbers from one row to the next: whole vectors of 32 bytes.
    const STRIDE: usize =
        (D + <T::Record<f64> as Record<f64>>::LENGTH).next_multiple_of(32 / size_of::<N::Packed>());

    /// Number of records.
    pub(crate) fn len(&self) -> usize {
        self.numbers.len() / Self::STRIDE
    }

    /// Number `column` of the record of each row, the last row repeated.
    #[inline(always)]
    pub(crate) fn column(&self, rows: &Range<usize>, column: usize) -> [N::Packed; WIDTH] {
        std::array::from_fn(|lane| {
            let row = (rows.start + lane).min(rows.end - 1);
            self.numbers[row * Self::STRIDE + column]
        })
    }

    /// The share in the smoothing length of each row, the last row repeated.
    #[inline(always)]
    pub(crate) fn own_shares(&self, rows: &Range<usize>) -> [N::Packed; WIDTH] {
        std::array::from_fn(|lane| self.shares[(rows.start + lane).min(rows.end - 1)])
    }

    /// The shares in the smoothing length of two entries.
    ///
    /// # Safety
    /// Both must be below [`len`](Self::len).
    #[inline(always)]
    #[allow(unsafe_code)]
    pub(crate) unsafe fn shares(&self, entries: [u32; 2]) -> [N::Packed; 2] {
        entries.map(|j| {
            debug_assert!((j as usize) < self.shares.len());
            // SAFETY: there are as many as records.
            unsafe { *self.shares.get_unchecked(j as usize) }
        })
    }

    /// A record that no particle of a cluster beginning with `row` meets.
    #[inline(always)]
    pub(crate) fn out_of_reach(&self, row: usize) -> [N::Packed; MOST_REALS] {
        const { assert!(Self::STRIDE <= MOST_REALS) };
        let mut record = [N::Packed::default(); MOST_REALS];
        record[..Self::STRIDE].copy_from_slice(&self.numbers[row * Self::STRIDE..][..Self::STRIDE]);
        for x in &mut record[..D] {
            *x = N::out_of_reach(*x);
        }
        record
    }

    /// Record `j`.
    ///
    /// # Safety
    /// `j` must be below [`len`](Self::len).
    #[inline(always)]
    #[allow(unsafe_code)]
    pub(crate) unsafe fn get(&self, j: u32) -> &[N::Packed] {
        debug_assert!((j as usize) < self.len());
        let start = j as usize * Self::STRIDE;
        // SAFETY: see above.
        unsafe { self.numbers.get_unchecked(start..start + Self::STRIDE) }
    }

    /// The records of two entries, or of one and `nobody`.
    ///
    /// # Safety
    /// As for [`get`](Self::get).
    #[inline(always)]
    #[allow(unsafe_code)]
    pub(crate) unsafe fn pair<'b>(
        &'b self,
        entries: &[u32],
        nobody: &'b [N::Packed],
        lonely: bool,
    ) -> [&'b [N::Packed]; 2] {
        let nobody = &nobody[..Self::STRIDE];
        // SAFETY: see above.
        let [first, second] = unsafe { [self.get(entries[0]), self.get(entries[1])] };
        [first, if lonely { nobody } else { second }]
    }

    /// Asks for the cache lines of record `j`.
    #[inline(always)]
    #[allow(unsafe_code)]
    pub(crate) fn prefetch(&self, j: u32) {
        #[cfg(target_arch = "x86_64")]
        {
            use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
            let pointer = (self.numbers.as_ptr()).wrapping_add(j as usize * Self::STRIDE);
            let line = 64 / size_of::<N::Packed>();
            // SAFETY: a prefetch is a hint; it reads nothing and faults on no address.
            unsafe {
                _mm_prefetch::<_MM_HINT_T0>(pointer.cast());
                if Self::STRIDE > line {
                    _mm_prefetch::<_MM_HINT_T0>(pointer.wrapping_add(line).cast());
                }
            }
        }
        #[cfg(not(target_arch = "x86_64"))]
        let _ = j;
    }
}
