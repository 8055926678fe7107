//! Lists of a second range over the same rows: forces that reach farther than the kernel.
//!
//! They are built whenever the first are, for the same places, so that the rows need to be sorted
//! for the first alone; and the first are built anew where the second no longer hold all pairs.

use super::Pairs;
use crate::kernel::Kernel;
use crate::particles::Particles;
use crate::smoothing::Smoothing;
use crate::term::Sweep;

impl<const D: usize> Pairs<D> {
    /// Keeps lists of a second range from the next build on; see [`second`](Self::second).
    pub fn set_second(&mut self, kernel: Kernel, smoothing: impl Into<Smoothing>) {
        self.second = Some(Box::new(Self {
            level: self.level,
            precision: self.precision,
            ..Self::new(kernel, smoothing, self.spacing, self.skin, self.domain)
        }));
    }

    /// Sums over the pairs of the second range, if there is one.
    pub fn second(&mut self) -> Option<&mut impl Sweep<D>> {
        self.second.as_deref_mut()
    }

    /// Builds the lists of the second range where the first were built.
    pub(super) fn follow(&mut self, particles: &Particles<D>) {
        if let Some(second) = &mut self.second {
            second.skin = self.skin;
            second.reference.clone_from(&self.reference);
            second.list_sorted(Some(&self.columns), particles);
        }
    }
}
