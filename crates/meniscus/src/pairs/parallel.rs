//! Loops over parts of a slice on all threads, compiled once.
//!
//! A generic parallel loop costs more machine code than a sweep does; here its
//! body is behind a pointer, called once for each part.

use rayon::prelude::*;

/// Calls `work` with each part of `part` items and its number, on any thread.
pub(crate) fn for_each_part<T: Send>(
    items: &mut [T],
    part: usize,
    work: &(impl Fn(usize, &mut [T]) + Sync),
) {
    let length = items.len();
    let items = Items(items.as_mut_ptr());
    for_each(length.div_ceil(part), &|k| {
        let start = k * part;
        // SAFETY: parts lie in the slice, and no two overlap; each `k` comes once.
        #[allow(unsafe_code)]
        let part = unsafe { items.part(start, part.min(length - start)) };
        work(k, part);
    });
}

/// Calls `work` with each number below `count`, once.
fn for_each(count: usize, work: &(dyn Fn(usize) + Sync)) {
    (0..count).into_par_iter().for_each(work);
}

struct Items<T>(*mut T);

// SAFETY: it hands out parts that do not overlap, of items that may be sent.
#[allow(unsafe_code)]
unsafe impl<T: Send> Sync for Items<T> {}

impl<T> Items<T> {
    /// # Safety
    /// The part must lie in the slice, and nothing else may refer to it.
    #[allow(unsafe_code, clippy::mut_from_ref)]
    unsafe fn part(&self, start: usize, length: usize) -> &mut [T] {
        // SAFETY: see above.
        unsafe { std::slice::from_raw_parts_mut(self.0.add(start), length) }
    }
}
