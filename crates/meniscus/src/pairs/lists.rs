//! Which particles are near which cluster.
//!
//! A cluster is eight consecutive rows. Its list holds every row, and every
//! periodic image (numbered after the rows), within reach of the box around
//! the cluster. A cluster that runs over the end of a column has one box for
//! each part, so that a jump along the snake's way costs nothing.

use fearless_simd::{Level, Simd};
use rayon::prelude::*;

use super::columns::{Columns, Entries};
use super::lane::WIDTH;
use super::level::{WithSimd, with_simd};

/// Clusters that one task works on.
pub(crate) const CLUSTERS_PER_CHUNK: usize = 16;

/// Lists of consecutive clusters.
#[derive(Debug, Default)]
pub(crate) struct Chunk {
    /// End of each cluster's list in `entries`.
    ends: Vec<u32>,
    entries: Entries,
}

impl Chunk {
    /// The list of each cluster, in order.
    #[inline(always)]
    pub(crate) fn lists(&self) -> impl Iterator<Item = &[u32]> {
        let entries = self.entries.as_slice();
        (0..self.ends.len()).map(move |k| {
            let start = if k == 0 { 0 } else { self.ends[k - 1] as usize };
            &entries[start..self.ends[k] as usize]
        })
    }

    pub(crate) fn entries(&self) -> usize {
        self.entries.length
    }

    pub(crate) fn bytes(&self) -> usize {
        size_of::<u32>() * self.ends.capacity() + self.entries.bytes()
    }
}

/// Builds the lists of all clusters of `real`; image `k` is entry `real.len() + k`.
pub(crate) fn build<const D: usize>(
    level: Level,
    chunks: &mut Vec<Chunk>,
    real: &Columns<D>,
    images: &Columns<D>,
    reach: f64,
) {
    let clusters = real.len().div_ceil(WIDTH);
    chunks.resize_with(clusters.div_ceil(CLUSTERS_PER_CHUNK), Chunk::default);
    chunks.par_iter_mut().enumerate().for_each(|(c, chunk)| {
        let first = c * CLUSTERS_PER_CHUNK;
        let clusters = first..clusters.min(first + CLUSTERS_PER_CHUNK);
        with_simd(
            level,
            BuildChunk {
                chunk,
                clusters,
                real,
                images,
                reach,
            },
        );
    });
}

struct BuildChunk<'a, const D: usize> {
    chunk: &'a mut Chunk,
    clusters: std::ops::Range<usize>,
    real: &'a Columns<D>,
    images: &'a Columns<D>,
    reach: f64,
}

impl<const D: usize> WithSimd for BuildChunk<'_, D> {
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) {
        let Chunk { ends, entries } = self.chunk;
        ends.clear();
        entries.length = 0;
        let rows = self.real.len();
        for cluster in self.clusters {
            let begin = entries.length;
            let end = rows.min((cluster + 1) * WIDTH);
            let mut start = cluster * WIDTH;
            let mut parts = 0;
            while start < end {
                let column = self.real.column(start);
                let part = (start + 1..end)
                    .find(|&k| self.real.column(k) != column)
                    .unwrap_or(end);
                let bounds = self.real.bounds_of(start..part);
                self.real.append_near(simd, &bounds, self.reach, 0, entries);
                self.images
                    .append_near(simd, &bounds, self.reach, rows as u32, entries);
                start = part;
                parts += 1;
            }
            if parts > 1 {
                entries.length = begin + sort_and_merge(&mut entries.as_mut_slice()[begin..]);
            }
            ends.push(entries.length as u32);
        }
    }
}

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
