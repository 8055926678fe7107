//! Operations of pair formulas are counted as one would by hand.

use meniscus::kernel::WendlandC2;
use meniscus::term::Pair;
use meniscus::{PairTerm, Particles, Real};
use meniscus_bench::flops::{Operations, of_pair};

/// Sums (own + 1)^2 other^2, in which much is done twice, once or never.
#[derive(Clone, Copy)]
struct Squares;

impl<const D: usize> PairTerm<D> for Squares {
    type Record<R: Real> = R;
    type Sum<R: Real> = R;
    fn record(&self, _: &Particles<D>, _: usize) -> f64 {
        0.0
    }
    fn pair<R: Real>(&self, own: &R, other: &R, _: &Pair<R, D>, sum: &mut R) {
        let once = (*own + 1.0).square();
        let never = other.sqrt() / 2.0;
        let twice = (*other * *other, *other * *other);
        let kept = R::select(other.less(*own), twice.0, never);
        let _ = kept;
        *sum = *sum + once * twice.1;
    }
}

#[test]
fn what_is_read_and_changes_is_counted_once() {
    // The square of the other, times what is the same for all, added.
    let expected = Operations {
        flops: 3,
        others: 0,
    };
    assert_eq!(of_pair::<WendlandC2, _, 2>(&Squares), expected);
    assert_eq!(of_pair::<WendlandC2, _, 3>(&Squares), expected);
}

/// Sums the kernel.
#[derive(Clone, Copy)]
struct Number;

impl<const D: usize> PairTerm<D> for Number {
    type Record<R: Real> = ();
    type Sum<R: Real> = R;
    fn record(&self, _: &Particles<D>, _: usize) {}
    fn pair<R: Real>(&self, (): &(), (): &(), ij: &Pair<R, D>, sum: &mut R) {
        *sum = *sum + ij.w;
    }
}

#[test]
fn the_distance_and_the_kernel_are_counted() {
    // r^2: 3 + 5; q: 2; (1 - q/2)^4 (1 + 2 q): 2 + 2 + 2 + 1; its factor, the sum: 2.
    // max(0, 1 - q/2) has no flop.
    let expected = Operations {
        flops: 19,
        others: 1,
    };
    assert_eq!(of_pair::<WendlandC2, _, 3>(&Number), expected);
}
