//! The pair engine. Physics never sees it: a [`PairTerm`](crate::PairTerm)
//! comes in, one sum per particle goes out.
//!
//! - `columns`: particles sorted along a snake of columns
//! - `entries`: memory of the lists
//! - `lists`: clusters of eight and what is near them; `listing`: when they are built, and until when they hold
//! - `images`: periodic images
//! - `reach`: how far particles reach for others
//! - `second`: lists of another range beside the first
//! - `lane`: eight particles as one [`Real`](crate::Real), `narrow_lane`: the same in f32
//! - `arithmetic`: f64, or mixed precision
//! - `records`: what a sweep reads, packed
//! - `level`: work compiled for each instruction set
//! - `sweep`: a term summed over the lists; `summing`: in which numbers, with which kernel
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
mod listing;
mod lists;
mod narrow_lane;
mod parallel;
mod reach;
mod records;
mod second;
mod summing;
mod sweep;

pub use arithmetic::Precision;

use buffer::LineBuffer;
use columns::Columns;
use fearless_simd::Level;
use images::Image;
use level::is_fused;
use lists::Chunk;
use reach::Reach;

use crate::domain::Domain;
use crate::kernel::Kernel;
use crate::particles::Scratch;
use crate::smoothing::Smoothing;
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

    /// Has the next lists hold all pairs of this smoothing length too, for
    /// [`sweep_with`](crate::term::SweepWith::sweep_with).
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

/// Packed records, kept between sweeps.
#[derive(Debug, Default)]
struct Buffers {
    double: LineBuffer<f64>,
    mixed: LineBuffer<u32>,
}
