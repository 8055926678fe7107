//! The symplectic scheme, kick-drift-kick. One step of length dt:
//!
//! 1. v += dt/2 a                            kick
//! 2. x += dt v                              drift
//! 3. rho += dt rho sum V (v - v_j).grad W   at the new x, with the v of mid-step; p(rho)
//! 4. a from the new x, rho, p and the v of mid-step
//! 5. v += dt/2 a                            kick
//!
//! Density advances with the velocity of mid-step, the very one that moves
//! the particles; with the velocity at the end of the step, free-surface
//! flows disorder and blow up. A drag -k v is applied exactly, as a factor
//! exp(-k dt/2) to either half.

use rayon::prelude::*;

use crate::particles::Particles;
use crate::rates::ROWS_PER_TASK;

/// Steps 1 and 2.
pub(crate) fn kick_drift<const D: usize>(particles: &mut Particles<D>, dt: f64, damping: f64) {
    let decay = (-0.5 * damping * dt).exp();
    (
        particles.position.par_iter_mut(),
        particles.velocity.par_iter_mut(),
        &particles.acceleration,
    )
        .into_par_iter()
        .with_min_len(ROWS_PER_TASK)
        .for_each(|(x, v, a)| {
            *v = (*v + *a * (0.5 * dt)) * decay;
            *x += *v * dt;
        });
}

/// Step 5.
pub(crate) fn kick<const D: usize>(particles: &mut Particles<D>, dt: f64, damping: f64) {
    let decay = (-0.5 * damping * dt).exp();
    (particles.velocity.par_iter_mut(), &particles.acceleration)
        .into_par_iter()
        .with_min_len(ROWS_PER_TASK)
        .for_each(|(v, a)| *v = *v * decay + *a * (0.5 * dt));
}
