//! Where liquid and walls meet: what has none of the other kind in its list need not be looked at until lists are built anew.

use crate::particles::Particles;
use crate::real::Real;
use crate::term::{Pair, PairTerm};

/// Sums to the number of neighbours of the other kind, however far they are.
#[derive(Clone, Copy, Debug)]
pub struct Meeting<'a> {
    /// Per body: whether it is a wall. Bodies beyond are not.
    pub is_wall: &'a [bool],
}

impl<const D: usize> PairTerm<D> for Meeting<'_> {
    /// 1 for walls, 0 for liquid.
    type Record<R: Real> = R;
    type Sum<R: Real> = R;
    const OFTEN: bool = false;

    fn record(&self, particles: &Particles<D>, i: usize) -> f64 {
        match self.is_wall.get(usize::from(particles.body[i])) {
            Some(true) => 1.0,
            _ => 0.0,
        }
    }

    #[inline(always)]
    fn pair<R: Real>(&self, i: &R, j: &R, _: &Pair<R, D>, sum: &mut R) {
        *sum = *sum + (*i - *j).square();
    }
}
