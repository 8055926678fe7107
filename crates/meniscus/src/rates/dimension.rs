//! The sweeps, compiled once.

use super::Rates;
use crate::divergence::{self, Culprit};
use crate::domain::Domain;
use crate::pairs::Pairs;
use crate::particles::Particles;

/// The dimensions that the library is compiled for: `Space` implements this
/// for 2 and 3.
///
/// The sweeps are the bulk of the machine code. Reached through this trait
/// they are compiled once, in this crate, and not again in every crate that
/// mentions a simulation.
pub trait Dimension<const D: usize> {
    #[doc(hidden)]
    fn table() -> Table<D>;
}

/// Implements [`Dimension`] for 2 and 3.
#[derive(Clone, Copy, Debug)]
pub struct Space;

/// Entry points of the compiled sweeps.
#[doc(hidden)]
#[derive(Clone, Copy)]
pub struct Table<const D: usize> {
    pub(crate) advance_density: fn(&mut Rates<D>, &mut Particles<D>, f64, f64),
    pub(crate) accelerate: fn(&mut Rates<D>, &mut Particles<D>, f64),
    pub(crate) put_in_order: fn(&mut Rates<D>, &mut Particles<D>, u64, f64),
    pub(crate) rebuild: fn(&mut Pairs<D>, &mut Particles<D>),
    pub(crate) diagnose: fn(&Rates<D>, &Particles<D>, &Domain<D>, f64, usize) -> Culprit,
}

macro_rules! compile_for {
    ($D:literal) => {
        impl Dimension<$D> for Space {
            // Inlined, it would be compiled, and all it points to, in every crate anew.
            #[inline(never)]
            fn table() -> Table<$D> {
                Table {
                    advance_density: Rates::<$D>::advance_density,
                    accelerate: Rates::<$D>::accelerate,
                    put_in_order: Rates::<$D>::put_in_order,
                    rebuild: Pairs::<$D>::rebuild,
                    diagnose: divergence::diagnose::<$D>,
                }
            }
        }
    };
}

compile_for!(2);
compile_for!(3);
