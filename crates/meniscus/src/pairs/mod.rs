//! The pair engine. Physics never sees it: a [`PairTerm`]
//! comes in, one sum per particle goes out.
//!
//! - `columns`: particles sorted along a snake of columns
//! - `entries`: memory of the lists
//! - `lists`: clusters of eight and what is near them
//! - `images`: periodic images
//! - `lane`: eight particles as one [`Real`](crate::Real), `narrow_lane`: the same in f32
//! - `arithmetic`: f64, or mixed precision
//! - `records`: what a sweep reads, packed
//! - `level`: work compiled for each instruction set
//! - `sweep`: a term summed over the lists
//! - `parallel`: loops on all threads
//! - `buffer`: aligned scratch memory

mod arithmetic;
mod buffer;
mod columns;
mod entries;
mod images;
mod lane;
mod level;
mod lists;
mod narrow_lane;
mod parallel;
mod records;
mod sweep;

pub use arithmetic::Precision;
pub use images::Domain;

use std::ops::Range;

use arithmetic::{Arithmetic, Double, Mixed};
use buffer::LineBuffer;
use columns::Columns;
use fearless_simd::Level;
use images::Image;
use level::{Widest, is_fused, is_widest};
use lists::Chunk;
use rayon::prelude::*;
use records::stride;

use crate::kernel::{Kernel, WendlandC2};
use crate::particles::{Particles, Scratch};
use crate::term::{PairTerm, Record, ScaledKernel, Sweep};
use crate::vector::Vector;

/// Which instructions the sweeps use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Instructions {
    /// The best that the processor has.
    Best,
    /// At most AVX2.
    Avx2,
    /// What every processor of the architecture has.
    Portable,
}

/// Neighbour lists of a set of particles, and the sweeps over them.
#[derive(Debug)]
pub struct Pairs<const D: usize> {
    kernel: Kernel,
    smoothing_length: f64,
    domain: Domain<D>,
    support: f64,
    skin: f64,
    precision: Precision,
    level: Level,
    columns: Columns<D>,
    image_columns: Columns<D>,
    images: Vec<Image<D>>,
    sorted_images: Vec<Image<D>>,
    image_points: Vec<Vector<f64, D>>,
    chunks: Vec<Chunk>,
    /// Positions when the lists were built.
    reference: Vec<Vector<f64, D>>,
    records: Buffers,
    scratch: Scratch<D>,
    builds: u64,
}

impl<const D: usize> Pairs<D> {
    /// An engine for particles about `spacing` metres apart, with lists that
    /// reach `skin` metres further than the kernel's support.
    pub fn new(
        kernel: Kernel,
        smoothing_length: f64,
        spacing: f64,
        skin: f64,
        domain: Domain<D>,
    ) -> Self {
        // Clusters of eight come out about as wide as long.
        let width = spacing * (lane::WIDTH as f64).powf(1.0 / D as f64);
        Self {
            kernel,
            smoothing_length,
            domain,
            support: kernel.support() * smoothing_length,
            skin,
            precision: Precision::Double,
            level: Level::new(),
            columns: Columns::new(width),
            image_columns: Columns::new(width),
            images: Vec::new(),
            sorted_images: Vec::new(),
            image_points: Vec::new(),
            chunks: Vec::new(),
            reference: Vec::new(),
            records: Buffers::default(),
            scratch: Scratch::default(),
            builds: 0,
        }
    }

    /// An engine of the same kernel for other particles, without a skin.
    pub(crate) fn sibling(&self, smoothing_length: f64, spacing: f64, domain: Domain<D>) -> Self {
        Self {
            level: self.level,
            precision: self.precision,
            ..Self::new(self.kernel, smoothing_length, spacing, 0.0, domain)
        }
    }

    /// An engine for the same particles with another smoothing length, m, which
    /// [`follow`](Self::follow)s this one.
    pub(crate) fn with_range(&self, smoothing_length: f64) -> Self {
        Self {
            level: self.level,
            precision: self.precision,
            columns: self.columns.like(),
            image_columns: self.columns.like(),
            ..Self::new(self.kernel, smoothing_length, 1.0, self.skin, self.domain)
        }
    }

    /// Lists the particles as `other` last sorted them, with the same skin.
    pub(crate) fn follow(&mut self, other: &Self) {
        self.skin = other.skin;
        self.level = other.level;
        let sorted = self.restore(&other.reference);
        debug_assert!(sorted, "the other's columns are as wide");
    }

    /// Periodic axes.
    pub(crate) fn domain(&self) -> Domain<D> {
        self.domain
    }

    /// Restricts the instructions, to measure or to test the other paths.
    pub fn set_instructions(&mut self, instructions: Instructions) {
        self.level = match instructions {
            Instructions::Best => Level::new(),
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Instructions::Avx2 => Level::new()
                .as_avx2()
                .map_or(Level::baseline(), Level::Avx2),
            #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
            Instructions::Avx2 => Level::new(),
            Instructions::Portable => Level::baseline(),
        };
    }

    /// Sets in what numbers the pairs are worked out.
    pub fn set_precision(&mut self, precision: Precision) {
        self.precision = precision;
    }

    /// In what numbers the pairs are worked out: in mixed precision only where
    /// the instructions have at least AVX2, since without it nothing is gained.
    pub fn precision(&self) -> Precision {
        if is_fused(self.level) {
            self.precision
        } else {
            Precision::Double
        }
    }

    /// Sorts the particles and builds the lists anew.
    pub fn rebuild(&mut self, particles: &mut Particles<D>) {
        if self.domain.is_periodic() {
            for point in &mut particles.position {
                self.domain.wrap(point);
            }
        }
        self.columns.sort(&particles.position);
        particles.permute(self.columns.order(), &mut self.scratch);
        self.reference.clear();
        self.reference.extend_from_slice(&particles.position);
        self.list();
    }

    /// Builds the lists again that [`rebuild`](Self::rebuild) made for sorted
    /// particles at `reference`; false if these are not sorted.
    pub(crate) fn restore(&mut self, reference: &[Vector<f64, D>]) -> bool {
        self.columns.sort(reference);
        self.reference = reference.to_vec();
        let sorted = (0..).zip(self.columns.order()).all(|(k, &row)| k == row);
        if sorted {
            self.list();
        }
        sorted
    }

    fn list(&mut self) {
        self.builds += 1;
        let reach = self.support + self.skin;
        images::collect(&self.domain, &self.reference, reach, &mut self.images);
        self.image_points.clear();
        self.image_points.extend(
            (self.images.iter()).map(|image| self.reference[image.source as usize] + image.shift),
        );
        self.image_columns.sort(&self.image_points);
        let order = self.image_columns.order();
        self.sorted_images.clear();
        self.sorted_images
            .extend(order.iter().map(|&k| self.images[k as usize]));
        lists::build(
            self.level,
            &mut self.chunks,
            &self.columns,
            &self.image_columns,
            reach,
        );
    }

    /// How far lists reach beyond the kernel's support, m.
    pub fn skin(&self) -> f64 {
        self.skin
    }

    /// Sets how far the next lists reach beyond the kernel's support, m.
    pub fn set_skin(&mut self, skin: f64) {
        self.skin = skin;
    }

    /// Whether particles have moved so far that a pair may be missing from the lists.
    pub fn is_stale(&self, particles: &Particles<D>) -> bool {
        self.reference.len() != particles.len()
            || !all_within(0.5 * self.skin, &particles.position, &self.reference)
    }

    /// Positions for which the lists were built.
    pub(crate) fn reference(&self) -> &[Vector<f64, D>] {
        &self.reference
    }

    /// How often lists were built.
    pub fn builds(&self) -> u64 {
        self.builds
    }

    /// Particles in a full cluster.
    pub fn cluster_width(&self) -> usize {
        lane::WIDTH
    }

    /// Mean number of list entries per cluster; each costs one pair formula for all particles of the cluster.
    pub fn entries_per_cluster(&self) -> f64 {
        let entries: usize = self
            .chunks
            .iter()
            .map(|c| c.entries().as_slice().len())
            .sum();
        let clusters: usize = self.chunks.iter().map(Chunk::len).sum();
        entries as f64 / clusters.max(1) as f64
    }

    /// Memory held by lists and scratch, bytes.
    pub fn bytes(&self) -> usize {
        let lists: usize = self.chunks.iter().map(Chunk::bytes).sum();
        let records = self.records.double.bytes() + self.records.mixed.bytes();
        lists + records + self.reference.capacity() * size_of::<Vector<f64, D>>()
    }
}

impl<const D: usize> Sweep<D> for Pairs<D> {
    fn sweep<T: PairTerm<D>>(
        &mut self,
        term: &T,
        particles: &Particles<D>,
        active: impl Fn(Range<usize>) -> bool + Sync,
        sums: &mut Vec<T::Sum<f64>>,
    ) {
        sums.resize(particles.len(), Record::read(&mut || 0.0));
        let count = particles.len() + self.sorted_images.len();
        let mut records = std::mem::take(&mut self.records);
        if T::OFTEN && self.precision() == Precision::Mixed {
            let packed = records.mixed.take(count * stride::<Mixed, T, D>());
            let arithmetic = Mixed::new(self.support.max(self.skin));
            self.sum_in(arithmetic, term, particles, &active, packed, sums);
        } else {
            let packed = records.double.take(count * stride::<Double, T, D>());
            self.sum_in(Double, term, particles, &active, packed, sums);
        }
        self.records = records;
    }
}

impl<const D: usize> Pairs<D> {
    fn sum_in<N: Arithmetic, T: PairTerm<D>>(
        &self,
        arithmetic: N,
        term: &T,
        particles: &Particles<D>,
        active: Active<'_>,
        packed: &mut [N::Packed],
        sums: &mut [T::Sum<f64>],
    ) {
        let images = &self.sorted_images;
        let records = records::pack(arithmetic, term, particles, images, packed);
        let kernel = ScaledKernel::new(self.kernel, self.smoothing_length, D);
        let (level, chunks) = (self.level, &self.chunks);
        if T::OFTEN && self.kernel == Kernel::WendlandC2 && is_widest(level) {
            // The default kernel is worth code of its own.
            let kernel = kernel.compiled::<WendlandC2>();
            sweep::run::<Widest, _, _, _, D>(level, term, kernel, chunks, records, active, sums);
        } else {
            sweep::run::<N::InstructionSets, _, _, _, D>(
                level, term, kernel, chunks, records, active, sums,
            );
        }
    }
}

/// Which ranges of rows are summed: behind a pointer, or each caller's would
/// have the sweep compiled once more.
type Active<'a> = &'a (dyn Fn(Range<usize>) -> bool + Sync);

/// Packed records, kept between sweeps.
#[derive(Debug, Default)]
struct Buffers {
    double: LineBuffer<f64>,
    mixed: LineBuffer<u32>,
}

/// Whether no row of `a` is farther than `distance` from that of `b`; a NaN is.
fn all_within<const D: usize>(distance: f64, a: &[Vector<f64, D>], b: &[Vector<f64, D>]) -> bool {
    a.par_iter()
        .with_min_len(4096)
        .zip(b)
        .all(|(a, b)| (*a - *b).norm_squared() <= distance * distance)
}
