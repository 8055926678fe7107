//! Which particles are near which cluster.
//!
//! A cluster is eight consecutive rows. Its list holds every row, and every
//! periodic image (numbered after the rows), within reach of the box around
//! the cluster. A cluster that runs over the end of a column has one box for
//! each part, so that a jump along the snake's way costs nothing.

use rayon::prelude::*;

use super::columns::Columns;
use super::lane::WIDTH;
use crate::vector::Vector;

/// Clusters that one task works on.
pub(crate) const CLUSTERS_PER_CHUNK: usize = 16;

/// Lists of consecutive clusters.
#[derive(Debug, Default)]
pub(crate) struct Chunk {
    /// End of each cluster's list in `entries`.
    ends: Vec<u32>,
    entries: Vec<u32>,
}

impl Chunk {
    /// The list of each cluster, in order.
    pub(crate) fn lists(&self) -> impl Iterator<Item = &[u32]> {
        (0..self.ends.len()).map(|k| {
            let start = if k == 0 { 0 } else { self.ends[k - 1] as usize };
            &self.entries[start..self.ends[k] as usize]
        })
    }

    pub(crate) fn entries(&self) -> usize {
        self.entries.len()
    }

    pub(crate) fn bytes(&self) -> usize {
        4 * (self.ends.capacity() + self.entries.capacity())
    }
}

/// Sorted points with their columns.
pub(crate) struct Sorted<'a, const D: usize> {
    pub(crate) columns: &'a Columns<D>,
    pub(crate) points: &'a [Vector<f64, D>],
}

/// Builds the lists of all clusters of `real`; image `k` is entry `real.len() + k`.
pub(crate) fn build<const D: usize>(
    chunks: &mut Vec<Chunk>,
    real: &Sorted<D>,
    images: &Sorted<D>,
    reach: f64,
) {
    let rows = real.points.len();
    let clusters = rows.div_ceil(WIDTH);
    chunks.resize_with(clusters.div_ceil(CLUSTERS_PER_CHUNK), Chunk::default);
    chunks.par_iter_mut().enumerate().for_each(|(c, chunk)| {
        chunk.ends.clear();
        chunk.entries.clear();
        let first = c * CLUSTERS_PER_CHUNK;
        for cluster in first..clusters.min(first + CLUSTERS_PER_CHUNK) {
            let range = cluster * WIDTH..rows.min((cluster + 1) * WIDTH);
            append_list(&mut chunk.entries, range, real, images, reach);
            chunk.ends.push(chunk.entries.len() as u32);
        }
    });
}

fn append_list<const D: usize>(
    entries: &mut Vec<u32>,
    range: std::ops::Range<usize>,
    real: &Sorted<D>,
    images: &Sorted<D>,
    reach: f64,
) {
    let begin = entries.len();
    let offset = real.points.len() as u32;
    let mut parts = 0;
    let mut start = range.start;
    while start < range.end {
        let column = real.columns.column(start);
        let mut end = start;
        let mut low = real.points[start].0;
        let mut high = low;
        while end < range.end && real.columns.column(end) == column {
            for d in 0..D {
                low[d] = low[d].min(real.points[end][d]);
                high[d] = high[d].max(real.points[end][d]);
            }
            end += 1;
        }
        real.columns
            .near_box(real.points, &low, &high, reach, |j| entries.push(j));
        images
            .columns
            .near_box(images.points, &low, &high, reach, |j| {
                entries.push(offset + j)
            });
        start = end;
        parts += 1;
    }
    if parts > 1 {
        entries[begin..].sort_unstable();
        let mut kept = begin;
        for k in begin..entries.len() {
            if k == begin || entries[k] != entries[k - 1] {
                entries[kept] = entries[k];
                kept += 1;
            }
        }
        entries.truncate(kept);
    }
}
