//! Which rows sums of liquid and walls concern: what has none of the other kind in its list need not be looked at until lists are
//! built anew.

use std::ops::Range;

use super::Walls;
use crate::pairs::Pairs;
use crate::particles::Particles;
use crate::physics::wall::WallBodies;
use crate::real::Real;
use crate::term::{Pair, PairTerm, Sweep};

/// Sums to the number of neighbours of the other kind in the list, beyond the kernel's support too: no formula of physics.
#[derive(Clone, Copy)]
struct Meeting<'a> {
    walls: WallBodies<'a>,
}

impl<const D: usize> PairTerm<D> for Meeting<'_> {
    /// 1 for walls, 0 for liquid.
    type Record<R: Real> = R;
    type Sum<R: Real> = R;
    const OFTEN: bool = false;

    fn record(&self, particles: &Particles<D>, i: usize) -> f64 {
        match self.walls.hold(particles.body[i]) {
            true => 1.0,
            false => 0.0,
        }
    }

    #[inline(always)]
    fn pair<R: Real>(&self, i: &R, j: &R, _: &Pair<R, D>, sum: &mut R) {
        *sum = *sum + (*i - *j).square();
    }
}

impl<const D: usize> Walls<D> {
    /// Finds, once for each list, where liquid and walls may come within the kernel's support. The others ask for it.
    pub(crate) fn meet(&mut self, pairs: &mut Pairs<D>, particles: &Particles<D>) {
        if self.is_empty() || self.met_at_build == Some(pairs.builds()) {
            return;
        }
        let walls = WallBodies(&self.is_wall);
        pairs.sweep(&Meeting { walls }, particles, |_| true, &mut self.meets);
        self.met_at_build = Some(pairs.builds());
    }

    /// Whether any of these rows is of liquid, or of a wall that meets some.
    pub(crate) fn is_liquid_or_may_be_wet(
        &self,
        particles: &Particles<D>,
        mut rows: Range<usize>,
    ) -> bool {
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
