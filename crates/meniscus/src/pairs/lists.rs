//! Which particles are near which cluster.
//!
//! A cluster is up to eight consecutive rows. Its list holds every
//! row, and every periodic image (numbered after the rows), no farther from
//! any of its particles than both reach together. Candidates come from the columns, by the box around
//! the cluster; a cluster that runs over the end of a column has one box for
//! each part. A cluster ends early where the next row lies far away.

use std::ops::Range;

use fearless_simd::{Level, Simd};
use rayon::prelude::*;

use super::columns::Columns;
use super::entries::Entries;
use super::lane::{Lane, WIDTH};
use super::level::{Every, InstructionSets, WithSimd};
use super::reach::Reach;
use crate::real::Real;

/// Rows that one task works on: a whole number of clusters.
pub(crate) const ROWS_PER_CHUNK: usize = 128;

/// Rows of a cluster lie no farther apart along any axis than so many times
/// what two rows may reach together, to either side of the first: well within what
/// mixed precision allows.
const SPREAD: f64 = 4.0;

/// A cluster of consecutive rows and its list, within a chunk.
#[derive(Clone, Copy, Debug)]
struct Cluster {
    /// End of its rows.
    rows: u32,
    /// End of its list in the chunk's entries.
    list: u32,
}

/// Lists of the clusters of [`ROWS_PER_CHUNK`] rows.
#[derive(Debug, Default)]
pub(crate) struct Chunk {
    clusters: Vec<Cluster>,
    entries: Entries,
    /// One more than the largest entry.
    bound: usize,
}

impl Chunk {
    /// The rows of each cluster, counted from the chunk's first row, and where in
    /// [`entries`](Self::entries) its list is.
    #[inline(always)]
    pub(crate) fn clusters(&self) -> impl Iterator<Item = (Range<usize>, Range<usize>)> {
        let mut row = 0;
        let mut entry = 0;
        self.clusters.iter().map(move |cluster| {
            let (rows, list) = (row..cluster.rows as usize, entry..cluster.list as usize);
            (row, entry) = (rows.end, list.end);
            (rows, list)
        })
    }

    /// Lists one after the other.
    pub(crate) fn entries(&self) -> &Entries {
        &self.entries
    }

    /// One more than the largest entry.
    pub(crate) fn bound(&self) -> usize {
        self.bound
    }

    /// Number of clusters.
    pub(crate) fn len(&self) -> usize {
        self.clusters.len()
    }

    pub(crate) fn bytes(&self) -> usize {
        size_of::<Cluster>() * self.clusters.capacity() + self.entries.bytes()
    }
}

/// Builds the lists of all clusters of the `real` points; number `k` of the `images`
/// is entry `real.len() + k`. With each goes how far its points reach.
pub(crate) fn build<const D: usize>(
    level: Level,
    chunks: &mut Vec<Chunk>,
    (real, reach): (&Columns<D>, &Reach),
    (images, image_reach): (&Columns<D>, &Reach),
) {
    let rows = real.len();
    chunks.resize_with(rows.div_ceil(ROWS_PER_CHUNK), Chunk::default);
    chunks.par_iter_mut().enumerate().for_each(|(c, chunk)| {
        let first = c * ROWS_PER_CHUNK;
        let rows = first..rows.min(first + ROWS_PER_CHUNK);
        let task = BuildChunk {
            chunk,
            rows,
            near: Near {
                real,
                reach,
                images,
                image_reach,
            },
        };
        let done = Every::run(level, task);
        debug_assert!(done.is_ok(), "every level is among all of them");
    });
}

struct BuildChunk<'a, const D: usize> {
    chunk: &'a mut Chunk,
    rows: Range<usize>,
    near: Near<'a, D>,
}

impl<const D: usize> WithSimd for BuildChunk<'_, D> {
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) {
        let Chunk {
            clusters,
            entries,
            bound,
        } = self.chunk;
        clusters.clear();
        entries.length = 0;
        let mut start = self.rows.start;
        while start < self.rows.end {
            let most = self.rows.end.min(start + WIDTH);
            let end = self.near.cluster_from(start, most);
            self.near.list(simd, start..end, entries);
            clusters.push(Cluster {
                rows: (end - self.rows.start) as u32,
                list: entries.length as u32,
            });
            start = end;
        }
        entries.pad();
        *bound = entries
            .as_slice()
            .iter()
            .max()
            .map_or(0, |&j| j as usize + 1);
    }
}

/// Where the neighbours are sought.
#[derive(Clone, Copy)]
struct Near<'a, const D: usize> {
    real: &'a Columns<D>,
    reach: &'a Reach,
    images: &'a Columns<D>,
    image_reach: &'a Reach,
}

impl<const D: usize> Near<'_, D> {
    /// End of the cluster that begins with row `start`, at most `most`.
    #[inline(always)]
    fn cluster_from(&self, start: usize, most: usize) -> usize {
        let spread = SPREAD * 2.0 * self.reach.largest();
        let far = |row: usize| {
            (0..D).any(|d| {
                let offset = self.real.coordinate(row, d) - self.real.coordinate(start, d);
                offset.abs() > spread
            })
        };
        (start + 1..most).find(|&row| far(row)).unwrap_or(most)
    }

    /// Appends the list of the cluster `rows`.
    #[inline(always)]
    fn list<S: Simd>(&self, simd: S, rows: Range<usize>, entries: &mut Entries) {
        let begin = entries.length;
        let own = rows.clone().map(|row| self.reach.of(row));
        let farthest = own.fold(0.0, f64::max);
        let mut start = rows.start;
        let mut parts = 0;
        while start < rows.end {
            let column = self.real.column(start);
            let part = (start + 1..rows.end)
                .find(|&k| self.real.column(k) != column)
                .unwrap_or(rows.end);
            let bounds = self.real.bounds_of(start..part);
            (self.real).append_near(simd, &bounds, farthest, self.reach, 0, entries);
            let images = self.real.len() as u32;
            (self.images).append_near(simd, &bounds, farthest, self.image_reach, images, entries);
            start = part;
            parts += 1;
        }
        let mut list = &mut entries.as_mut_slice()[begin..];
        if parts > 1 {
            let length = sort_and_merge(list);
            list = &mut list[..length];
        }
        entries.length = begin + self.near_any(simd, rows, list);
    }

    /// Keeps the entries of `list` that any of `rows` reaches; gives how many.
    #[inline(always)]
    fn near_any<S: Simd>(&self, simd: S, rows: Range<usize>, list: &mut [u32]) -> usize {
        let own: [Lane<S>; D] = std::array::from_fn(|d| self.real.lane(simd, rows.clone(), d));
        let own_reach =
            std::array::from_fn(|lane| self.reach.of((rows.start + lane).min(rows.end - 1)));
        let own_reach = Lane::load(simd, own_reach);
        let count = self.real.len();
        let mut kept = 0;
        for k in 0..list.len() {
            let entry = list[k] as usize;
            let (columns, reach, row) = if entry < count {
                (self.real, self.reach, entry)
            } else {
                (self.images, self.image_reach, entry - count)
            };
            let mut square = Lane::splat(simd, 0.0);
            for (d, own) in own.iter().enumerate() {
                let offset = *own - columns.coordinate(row, d);
                square = offset.mul_add(offset, square);
            }
            let both = own_reach + reach.of(row);
            list[kept] = entry as u32;
            kept += usize::from(square.not_above(both.square()) != 0);
        }
        kept
    }
}

const _: () = assert!(ROWS_PER_CHUNK.is_multiple_of(WIDTH));

/// Sorts a list and drops what stands in it twice; gives the length left.
fn sort_and_merge(list: &mut [u32]) -> usize {
    list.sort_unstable();
    let mut kept = 0;
    for k in 0..list.len() {
        if kept == 0 || list[k] != list[kept - 1] {
            list[kept] = list[k];
            kept += 1;
        }
    }
    kept
}
