//! Entries of neighbour lists: a stretch of memory that is filled anew at each build.

use super::lane::WIDTH;

/// Zeros behind the last entry of a chunk's lists, so that a sweep may look ahead.
pub(crate) const PADDING: usize = 80;

/// Entries of neighbour lists, growing without giving memory back.
#[derive(Debug, Default)]
pub(crate) struct Entries {
    slots: Vec<u32>,
    pub(crate) length: usize,
}

impl Entries {
    /// Puts [`PADDING`] zeros behind the last entry.
    pub(crate) fn pad(&mut self) {
        let end = self.length + PADDING;
        if self.slots.len() < end {
            self.slots.resize(end, 0);
        }
        self.slots[self.length..end].fill(0);
    }

    /// All entries, and [`PADDING`] zeros.
    pub(crate) fn padded(&self) -> &[u32] {
        &self.slots[..self.length + PADDING]
    }

    pub(crate) fn as_slice(&self) -> &[u32] {
        &self.slots[..self.length]
    }

    pub(crate) fn as_mut_slice(&mut self) -> &mut [u32] {
        &mut self.slots[..self.length]
    }

    pub(crate) fn bytes(&self) -> usize {
        self.slots.capacity() * size_of::<u32>()
    }

    /// Appends `first + lane` for each lane whose bit is set, without a branch.
    #[inline(always)]
    pub(crate) fn append(&mut self, first: u32, lanes: u8) {
        if self.slots.len() < self.length + WIDTH {
            let more = self.slots.len() / 8 + 256;
            self.slots.reserve_exact(more);
            self.slots.resize(self.slots.len() + more, 0);
        }
        let slots = &mut self.slots[self.length..][..WIDTH];
        for (slot, lane) in slots.iter_mut().zip(LANES[lanes as usize]) {
            *slot = first + u32::from(lane);
        }
        self.length += lanes.count_ones() as usize;
    }
}

/// For each set of lanes, given by its bits, those lanes in order; then zeros.
static LANES: [[u8; WIDTH]; 256] = {
    let mut table = [[0; WIDTH]; 256];
    let mut set = 0;
    while set < 256 {
        let mut kept = 0;
        let mut lane = 0;
        while lane < WIDTH {
            if set >> lane & 1 == 1 {
                table[set][kept] = lane as u8;
                kept += 1;
            }
            lane += 1;
        }
        set += 1;
    }
    table
};
