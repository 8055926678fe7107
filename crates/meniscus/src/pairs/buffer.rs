//! A reusable buffer of numbers that begins on a cache line, so that records
//! of 32 or 64 bytes never straddle two.

const LINE: usize = 64;

/// Numbers on a cache line, kept between uses.
#[derive(Debug, Default)]
pub(crate) struct LineBuffer<P> {
    numbers: Vec<P>,
}

impl<P: Copy + Default> LineBuffer<P> {
    /// `length` numbers of any value, aligned to a cache line.
    pub(crate) fn take(&mut self, length: usize) -> &mut [P] {
        let spare = LINE / size_of::<P>();
        if self.numbers.len() < length + spare {
            self.numbers.resize(length + spare, P::default());
        }
        let offset = self.numbers.as_ptr().align_offset(LINE).min(spare);
        &mut self.numbers[offset..offset + length]
    }

    pub(crate) fn bytes(&self) -> usize {
        self.numbers.capacity() * size_of::<P>()
    }
}
