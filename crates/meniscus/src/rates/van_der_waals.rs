//! A van der Waals fluid, with the lists of its long range.

use crate::fluid::Fluid;
use crate::pairs::Pairs;
use crate::particles::Particles;
use crate::physics::van_der_waals::{Flow, VanDerWaals};
use crate::scheme::Scheme;

/// The fluid and its far pairs, listed whenever the near ones are.
pub(crate) struct Cohesive<const D: usize> {
    pub(crate) flow: Flow<D>,
    far: Pairs<D>,
    /// Builds of the near lists that the far ones follow.
    followed: u64,
}

impl<const D: usize> Cohesive<D> {
    pub(super) fn new(
        model: VanDerWaals,
        scheme: &Scheme,
        fluids: &[Fluid],
        near: &Pairs<D>,
    ) -> Self {
        Self {
            flow: Flow::new(model, fluids.first().map_or(0.0, |fluid| fluid.viscosity)),
            far: near.with_range(model.cohesion_range * scheme.smoothing_length),
            followed: 0,
        }
    }

    /// Cohesion and pressure; see [`Flow::prepare`].
    pub(super) fn prepare(&mut self, near: &Pairs<D>, particles: &mut Particles<D>, dt: f64) {
        if self.followed != near.builds() {
            self.far.follow(near);
            self.followed = near.builds();
        }
        self.flow.prepare(&mut self.far, particles, dt);
    }
}
