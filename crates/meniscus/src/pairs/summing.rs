//! A term summed over the lists: in which numbers, with which kernel.

use std::ops::Range;

use super::arithmetic::{Arithmetic, Double, Mixed, Precision};
use super::buffer::LineBuffer;
use super::level::{Widest, is_widest};
use super::{Pairs, records, sweep};
use crate::kernel::{Kernel, WendlandC2};
use crate::particles::Particles;
use crate::smoothing::Smoothing;
use crate::term::{PairTerm, Record, ScaledKernel, Sweep, SweepWith};

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

impl<const D: usize> SweepWith<D> for Pairs<D> {
    fn sweep_with<T: PairTerm<D>>(
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
}

impl<const D: usize> Pairs<D> {
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
pub(super) type Active<'a> = &'a (dyn Fn(Range<usize>) -> bool + Sync);
