//! Bodies that the tests measure.

use crate::shape::{Arrangement, Pattern, Shape};
use crate::vector::Vector;

/// A cubic lattice of spacing 1, each coordinate shifted at random by up to `jitter`.
pub(super) fn lattice<const D: usize>(shape: &Shape<D>, jitter: f64) -> Vec<Vector<f64, D>> {
    let arrangement = Arrangement {
        jitter,
        seed: 7,
        ..Arrangement::new(Pattern::Cubic, 1.0)
    };
    arrangement.fill(shape, 1 << 20).unwrap_or_default()
}
