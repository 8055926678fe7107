//! Sums over all pairs, O(N^2): the slow truth that the engine is tested
//! against, and that a term of your own can be tested against.

use crate::domain::Domain;
use crate::kernel::Kernel;
use crate::particles::Particles;
use crate::smoothing::Smoothing;
use crate::term::{PairTerm, Record, ScaledKernel};

/// `term` summed for particle `i` over all particles, itself and periodic images included.
/// A number for `smoothing` is one smoothing length for all, m.
pub fn sum<T: PairTerm<D>, const D: usize>(
    term: &T,
    kernel: Kernel,
    smoothing: impl Into<Smoothing>,
    domain: &Domain<D>,
    particles: &Particles<D>,
    i: usize,
) -> T::Sum<f64> {
    let smoothing = smoothing.into();
    let own = term.record(particles, i);
    let mut sum = T::Sum::<f64>::read(&mut || 0.0);
    for j in 0..particles.len() {
        let smoothing_length = smoothing.of_pair(particles, i, j);
        let support = kernel.support() * smoothing_length;
        let scaled = ScaledKernel::new(kernel, smoothing_length, D);
        let other = term.record(particles, j);
        let offset = particles.position[i] - particles.position[j];
        domain.for_each_image(offset, support, &mut |offset| {
            let pair = scaled.pair::<f64, D>(scaled.approach(offset, || smoothing_length));
            term.pair(&own, &other, &pair, &mut sum);
        });
    }
    sum
}

/// [`sum`] for every particle.
pub fn sums<T: PairTerm<D>, const D: usize>(
    term: &T,
    kernel: Kernel,
    smoothing: impl Into<Smoothing>,
    domain: &Domain<D>,
    particles: &Particles<D>,
) -> Vec<T::Sum<f64>> {
    let smoothing = smoothing.into();
    (0..particles.len())
        .map(|i| sum(term, kernel, smoothing, domain, particles, i))
        .collect()
}
