//! Which rows sums of liquid and walls concern.

use std::ops::Range;

use super::Walls;
use crate::pairs::Pairs;
use crate::particles::Particles;
use crate::physics::wall::Meeting;
use crate::term::Sweep;

impl<const D: usize> Walls<D> {
    /// Finds, once for each list, where liquid and walls may come within the kernel's support.
    pub(crate) fn meet(&mut self, pairs: &mut Pairs<D>, particles: &Particles<D>) {
        if self.is_empty() || self.met == Some(pairs.builds()) {
            return;
        }
        let is_wall = &self.is_wall;
        pairs.sweep(&Meeting { is_wall }, particles, |_| true, &mut self.meets);
        self.met = Some(pairs.builds());
    }

    /// Whether any of these rows is of liquid, or of a wall that meets some.
    pub(crate) fn may_matter(&self, particles: &Particles<D>, mut rows: Range<usize>) -> bool {
        rows.any(|row| !self.is_wall(particles.body[row]) || self.meets[row] > 0.0)
    }

    /// Whether any of these rows is of a wall that meets liquid.
    pub(super) fn may_be_wet(&self, particles: &Particles<D>, mut rows: Range<usize>) -> bool {
        rows.any(|row| self.is_wall(particles.body[row]) && self.meets[row] > 0.0)
    }

    /// Whether any of these rows is of liquid that meets a wall.
    pub(super) fn may_touch(&self, particles: &Particles<D>, mut rows: Range<usize>) -> bool {
        rows.any(|row| !self.is_wall(particles.body[row]) && self.meets[row] > 0.0)
    }
}
