//! Forces beyond those of the scheme.

use crate::pairs::Pairs;
use crate::particles::Particles;
use crate::term::{PairTerm, Sweep};
use crate::vector::Vector;

/// A force of the user's own, added to the momentum equation.
pub trait Force<const D: usize>: Send + Sync {
    /// Adds its acceleration, m/s^2, to that of each particle.
    fn accelerate(
        &mut self,
        pairs: &mut Pairs<D>,
        particles: &Particles<D>,
        acceleration: &mut [Vector<f64, D>],
    );
}

/// A [`PairTerm`] that sums to an acceleration, as a [`Force`].
pub(crate) struct PairForce<T, const D: usize> {
    pub(crate) term: T,
    pub(crate) sums: Vec<Vector<f64, D>>,
}

impl<T, const D: usize> Force<D> for PairForce<T, D>
where
    T: PairTerm<D, Sum<f64> = Vector<f64, D>> + Send,
{
    fn accelerate(
        &mut self,
        pairs: &mut Pairs<D>,
        particles: &Particles<D>,
        acceleration: &mut [Vector<f64, D>],
    ) {
        pairs.sweep(&self.term, particles, |_| true, &mut self.sums);
        for (a, sum) in acceleration.iter_mut().zip(&self.sums) {
            *a += *sum;
        }
    }
}
