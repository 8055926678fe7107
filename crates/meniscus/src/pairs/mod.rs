//! The pair engine. Physics never sees it: a [`PairTerm`]
//! comes in, one sum per particle goes out.
//!
//! - `columns`: particles sorted along a snake of columns
//! - `entries`: memory of the lists
//! - `lists`: clusters of eight and what is near them
//! - `images`: periodic images
//! - `smoothing`: the smoothing length of a pair, and how far particles reach
//! - `second`: lists of another range beside the first
//! - `lane`: eight particles as one [`Real`](crate::Real), `narrow_lane`: the same in f32
//! - `arithmetic`: f64, or mixed precision
//! - `records`: what a sweep reads, packed
//! - `level`: work compiled for each instruction set
//! - `sweep`: a term summed over the lists
//! - `parallel`: loops on all threads
//! - `buffer`: aligned scratch memory
//! - `bodies`: which particles hang together

mod arithmetic;
mod bodies;
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
mod second;
mod smoothing;
mod sweep;

pub use arithmetic::Precision;
pub use images::Domain;
pub use smoothing::Smoothing;

use std::ops::Range;

use arithmetic::{Arithmetic, Double, Mixed};
use buffer::LineBuffer;
use columns::Columns;
use fearless_simd::Level;
use images::Image;
use level::{Widest, is_fused, is_widest};
use lists::Chunk;
use rayon::prelude::*;
use smoothing::Reach;

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
    smoothing: Smoothing,
    /// What lists are long enough for as well.
    also: Option<Smoothing>,
    domain: Domain<D>,
    spacing: f64,
    skin: f64,
    precision: Precision,
    level: Level,
    columns: Columns<D>,
    image_columns: Columns<D>,
    images: Vec<Image<D>>,
    sorted_images: Vec<Image<D>>,
    image_points: Vec<Vector<f64, D>>,
    chunks: Vec<Chunk>,
    /// How far rows reached when the lists were built, and images.
    reach: Reach,
    image_reach: Reach,
    /// Positions when the lists were built.
    reference: Vec<Vector<f64, D>>,
    /// Smoothing lengths then, where they vary.
    reference_smoothing_length: Vec<f64>,
    second: Option<Box<Pairs<D>>>,
    records: Buffers,
    scratch: Scratch<D>,
    builds: u64,
}

impl<const D: usize> Pairs<D> {
    /// An engine for particles about `spacing` metres apart, with lists that
    /// reach `skin` metres further than the kernel's support. A number for `smoothing` is one
    /// smoothing length for all pairs, m.
    ///
    /// Where it varies, terms have no code of their own for the default kernel; mixed
    /// precision is as with one length for all.
    pub fn new(
        kernel: Kernel,
        smoothing: impl Into<Smoothing>,
        spacing: f64,
        skin: f64,
        domain: Domain<D>,
    ) -> Self {
        // Clusters of eight come out about as wide as long.
        let width = spacing * (lane::WIDTH as f64).powf(1.0 / D as f64);
        Self {
            kernel,
            smoothing: smoothing.into(),
            also: None,
            domain,
            spacing,
            skin,
            precision: Precision::Double,
            level: Level::new(),
            columns: Columns::new(width),
            image_columns: Columns::new(width),
            images: Vec::new(),
            sorted_images: Vec::new(),
            image_points: Vec::new(),
            chunks: Vec::new(),
            reach: Reach::default(),
            image_reach: Reach::default(),
            reference: Vec::new(),
            reference_smoothing_length: Vec::new(),
            second: None,
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
        if let Some(second) = &mut self.second {
            second.level = self.level;
        }
    }

    /// Sets in what numbers the pairs are worked out.
    pub fn set_precision(&mut self, precision: Precision) {
        self.precision = precision;
        if let Some(second) = &mut self.second {
            second.precision = precision;
        }
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
        self.list(particles);
    }

    /// Builds the lists again that [`rebuild`](Self::rebuild) made for sorted
    /// particles at `reference`, with these smoothing lengths; false if these are not sorted.
    pub(crate) fn restore(&mut self, particles: &Particles<D>) -> bool {
        self.columns.sort(&particles.position);
        self.reference.clone_from(&particles.position);
        let sorted = (0..).zip(self.columns.order()).all(|(k, &row)| k == row);
        if sorted {
            self.list(particles);
        }
        sorted
    }

    fn list(&mut self, particles: &Particles<D>) {
        self.list_sorted(None, particles);
        self.follow(particles);
    }

    /// Builds the lists of particles that are sorted into columns, if not into its own.
    fn list_sorted(&mut self, columns: Option<&Columns<D>>, particles: &Particles<D>) {
        self.builds += 1;
        self.reference_smoothing_length.clear();
        if self.smoothing_varies() {
            (self.reference_smoothing_length).extend_from_slice(&particles.smoothing_length);
        }
        let mut reach = std::mem::take(&mut self.reach);
        let columns = columns.unwrap_or(&self.columns);
        if self.reach_varies() {
            let of_row = |i| self.support_share(particles, i) + 0.5 * self.skin;
            reach.fill(columns, (0..particles.len()).map(of_row));
        } else {
            reach.fill_same(self.support_share(particles, 0) + 0.5 * self.skin);
        }
        self.reach = reach;
        let farthest = 2.0 * self.reach.largest();
        images::collect(&self.domain, &self.reference, farthest, &mut self.images);
        self.image_points.clear();
        self.image_points.extend(
            (self.images.iter()).map(|image| self.reference[image.source as usize] + image.shift),
        );
        self.image_columns.sort(&self.image_points);
        let order = self.image_columns.order();
        self.sorted_images.clear();
        self.sorted_images
            .extend(order.iter().map(|&k| self.images[k as usize]));
        if let Some(same) = self.reach.same() {
            self.image_reach.fill_same(same);
        } else {
            let sources = self.sorted_images.iter().map(|image| image.source as usize);
            let of_image = sources.map(|source| self.reach.of(source));
            self.image_reach.fill(&self.image_columns, of_image);
        }
        lists::build(
            self.level,
            &mut self.chunks,
            (columns, &self.reach),
            (&self.image_columns, &self.image_reach),
        );
    }

    /// Whether some rows reach farther than others.
    fn reach_varies(&self) -> bool {
        let varies = |smoothing| matches!(smoothing, Smoothing::Mean { .. });
        varies(self.smoothing) || self.also.is_some_and(varies)
    }

    /// What row `i` adds to the support of its pairs, m.
    fn support_share(&self, particles: &Particles<D>, i: usize) -> f64 {
        let share = self.smoothing.share(particles, i);
        let also = self.also.map_or(share, |also| also.share(particles, i));
        self.kernel.support() * share.max(also)
    }

    /// Has the next lists hold all pairs of this smoothing length too, for
    /// [`sweep_with`](Self::sweep_with).
    pub fn hold_also(&mut self, smoothing: impl Into<Smoothing>) {
        self.also = Some(smoothing.into());
    }

    /// How far lists reach beyond the kernel's support, m.
    pub fn skin(&self) -> f64 {
        self.skin
    }

    /// Sets how far the next lists reach beyond the kernel's support, m.
    pub fn set_skin(&mut self, skin: f64) {
        self.skin = skin;
    }

    /// Whether particles have moved so far, or smoothing lengths grown so much, that a pair may
    /// be missing from the lists.
    pub fn is_stale(&self, particles: &Particles<D>) -> bool {
        self.reference.len() != particles.len()
            || !self.is_within_skin(particles)
            || (self.second.as_ref()).is_some_and(|second| second.is_stale(particles))
    }

    /// Whether each particle's way from where it was, and what its reach has grown by, are
    /// together at most half the skin; what is not a number is not.
    fn is_within_skin(&self, particles: &Particles<D>) -> bool {
        let varies = self.reach_varies();
        (particles.position.par_iter(), &self.reference)
            .into_par_iter()
            .with_min_len(4096)
            .enumerate()
            .all(|(i, (now, reference))| {
                let left = if varies {
                    self.reach.of(i) - self.support_share(particles, i)
                } else {
                    0.5 * self.skin
                };
                left >= 0.0 && (*now - *reference).norm_squared() <= left * left
            })
    }

    /// Positions for which the lists were built.
    pub(crate) fn reference(&self) -> &[Vector<f64, D>] {
        &self.reference
    }

    /// Smoothing lengths for which the lists were built; none where they do not vary.
    pub(crate) fn reference_smoothing_length(&self) -> &[f64] {
        &self.reference_smoothing_length
    }

    /// The smoothing length of pairs.
    pub(crate) fn smoothing(&self) -> Smoothing {
        self.smoothing
    }

    /// Whether the smoothing length varies from pair to pair.
    pub(crate) fn smoothing_varies(&self) -> bool {
        matches!(self.smoothing, Smoothing::Mean { .. })
    }

    /// For each row the body that it belongs to, and how many there are. Particles of two bodies
    /// have not been within each other's `support` (m) since the lists were built.
    /// Rows that do not take part have none.
    pub(crate) fn bodies(
        &self,
        support: f64,
        takes_part: impl Fn(usize) -> bool,
    ) -> (Vec<u32>, usize) {
        let rows: Vec<usize> = (0..self.reference.len())
            .filter(|&i| takes_part(i))
            .collect();
        let points: Vec<_> = rows.iter().map(|&i| self.reference[i]).collect();
        let (of, count) = bodies::connected(&points, support + self.skin, &self.domain);
        let mut of_row = vec![u32::MAX; self.reference.len()];
        for (row, of) in rows.into_iter().zip(of) {
            of_row[row] = of;
        }
        (of_row, count)
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
        let reach = self.reach.bytes()
            + self.image_reach.bytes()
            + self.reference_smoothing_length.capacity() * size_of::<f64>();
        let second = (self.second.as_ref()).map_or(0, |second| second.bytes());
        lists + records + reach + second + self.reference.capacity() * size_of::<Vector<f64, D>>()
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
        self.sweep_with(self.smoothing, term, particles, active, sums);
    }
}

impl<const D: usize> Pairs<D> {
    /// [`sweep`](Sweep::sweep) with another smoothing length, which the lists must be long enough for:
    /// not above that of any pair, or one that they [also hold](Self::hold_also).
    pub fn sweep_with<T: PairTerm<D>>(
        &mut self,
        smoothing: Smoothing,
        term: &T,
        particles: &Particles<D>,
        active: impl Fn(Range<usize>) -> bool + Sync,
        sums: &mut Vec<T::Sum<f64>>,
    ) {
        sums.resize(particles.len(), Record::read(&mut || 0.0));
        let mut records = std::mem::take(&mut self.records);
        if T::OFTEN && self.precision() == Precision::Mixed {
            let support = 2.0 * self.reach.largest() - self.skin;
            let arithmetic = Mixed::new(support.max(self.skin));
            let buffer = &mut records.mixed;
            self.sum_in(
                arithmetic, smoothing, term, particles, &active, buffer, sums,
            );
        } else {
            let buffer = &mut records.double;
            self.sum_in(Double, smoothing, term, particles, &active, buffer, sums);
        }
        self.records = records;
    }

    #[allow(clippy::too_many_arguments)]
    fn sum_in<N: Arithmetic, T: PairTerm<D>>(
        &self,
        arithmetic: N,
        smoothing: Smoothing,
        term: &T,
        particles: &Particles<D>,
        active: Active<'_>,
        buffer: &mut LineBuffer<N::Packed>,
        sums: &mut [T::Sum<f64>],
    ) {
        let images = &self.sorted_images;
        let (level, chunks) = (self.level, &self.chunks);
        let kernel = match smoothing {
            Smoothing::Constant(h) => ScaledKernel::new(self.kernel, h, D),
            Smoothing::Mean { .. } => ScaledKernel::varying(self.kernel, D),
        };
        let records = records::pack(arithmetic, smoothing, term, particles, images, buffer);
        let is_default = self.kernel == Kernel::WendlandC2;
        if T::OFTEN && is_default && !kernel.varies() && is_widest(level) {
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
