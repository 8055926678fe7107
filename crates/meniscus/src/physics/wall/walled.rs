//! The material of a flow with walls: any fluids and masses, and what may act between two
//! particles, told from one number of each. No branch: s is 0 in a fluid, 1 at a wall without
//! slip, 2 at one with free slip, and
//!
//! - max(0, 1 - s_i s_j)                1, or 0 between two walls
//! - min(1, max(0, 2 - s_i - s_j))      1, or 0 between two walls and where there is no friction

use crate::fluid::Fluid;
use crate::physics::momentum::{Contact, Material, Mixture, Substance};
use crate::real::Real;

/// Fluids by index, and walls by body.
#[derive(Clone, Copy, Debug)]
pub struct Walled<'a> {
    /// Fluids.
    pub fluids: &'a [Fluid],
    /// s of each body; bodies beyond are fluid.
    pub slip: &'a [f64],
}

impl Material for Walled<'_> {
    const WALLS: bool = true;
    type Record<R: Real> = (Substance<R, 0>, R);

    fn record(&self, mass: f64, fluid: u16, body: u16) -> (Substance<f64, 0>, f64) {
        let slip = self.slip.get(body as usize).copied().unwrap_or(0.0);
        (Mixture(self.fluids).record(mass, fluid, body), slip)
    }

    #[inline(always)]
    fn mass<R: Real>(&self, record: &(Substance<R, 0>, R), _: R) -> R {
        record.0.mass
    }
    #[inline(always)]
    fn sound_speed<R: Real>(&self, record: &(Substance<R, 0>, R), _: R) -> R {
        record.0.sound_speed
    }
    #[inline(always)]
    fn viscosity<R: Real>(&self, record: &(Substance<R, 0>, R), _: R) -> R {
        record.0.viscosity
    }
    #[inline(always)]
    fn contact<R: Real>(
        &self,
        i: &(Substance<R, 0>, R),
        j: &(Substance<R, 0>, R),
        like: R,
    ) -> Contact<R> {
        let one = like.literal(1.0);
        Contact {
            pressure: (one - i.1 * j.1).positive(),
            friction: (like.literal(2.0) - i.1 - j.1).positive().min(one),
        }
    }
}
