//! A van der Waals fluid, with the lists of its long range.

use crate::fluid::Fluid;
use crate::pairs::Pairs;
use crate::particles::Particles;
use crate::physics::van_der_waals::{Flow, VanDerWaals};
use crate::scheme::Scheme;
use crate::smoothing::Smoothing;

/// The fluid, whose far pairs are those of the second lists.
pub(crate) struct Cohesive<const D: usize> {
    pub(crate) flow: Flow<D>,
}

impl<const D: usize> Cohesive<D> {
    pub(super) fn new(
        model: VanDerWaals,
        scheme: &Scheme,
        fluids: &[Fluid],
        pairs: &mut Pairs<D>,
    ) -> Self {
        let factor = model.cohesion_range;
        let range = if model.cohesion_adapts {
            Smoothing::Mean { factor }
        } else {
            Smoothing::Constant(factor * scheme.smoothing_length)
        };
        pairs.set_second(scheme.kernel, range);
        Self {
            flow: Flow::new(model, fluids.first().map_or(0.0, |fluid| fluid.viscosity)),
        }
    }

    /// Cohesion and pressure; see [`Flow::prepare`].
    pub(super) fn prepare(&mut self, pairs: &mut Pairs<D>, particles: &mut Particles<D>, dt: f64) {
        if let Some(far) = pairs.second() {
            self.flow.prepare(far, particles, dt);
        }
    }
}
