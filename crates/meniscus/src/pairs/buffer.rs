//! A reusable buffer of reals that begins on a cache line, so that records
//! of 32 or 64 bytes never straddle two.

const LINE: usize = 64;

/// Reals on a cache line, kept between uses.
#[derive(Debug, Default)]
pub(crate) struct LineBuffer {
    reals: Vec<f64>,
}

impl LineBuffer {
    /// `length` reals of any value, aligned to a cache line.
    pub(crate) fn take(&mut self, length: usize) -> &mut [f64] {
        let spare = LINE / size_of::<f64>();
        if self.reals.len() < length + spare {
            self.reals.resize(length + spare, 0.0);
        }
        let offset = self.reals.as_ptr().align_offset(LINE).min(spare);
        &mut self.reals[offset..offset + length]
    }

    pub(crate) fn bytes(&self) -> usize {
        self.reals.capacity() * size_of::<f64>()
    }
}
