//! The symplectic scheme, kick-drift-kick. One step of length dt:
//!
//! 1. v += dt/2 a                            kick
//! 2. x += dt/2 v                            half the drift
//! 3. rho += dt rho sum V (v - v_j).grad W   with x and v of mid-step; p(rho)
//! 4. x += dt/2 v                            the other half
//! 5. a from the new x, rho, p and the v of mid-step
//! 6. v += dt/2 a                            kick
//!
//! Density advances with the velocity of mid-step, the very one that moves
//! the particles; with the velocity at the end of the step, free-surface
//! flows disorder and blow up. The places are of mid-step too: with those at
//! the end of the step the density of a body that turns at omega would leave
//! that of its particles by omega^2 dt per second. Density by summation is
//! taken at the end of the step instead, between 4 and 5.
//!
//! Second order in dt, but for two things. Forces that depend on velocity see
//! v half a step late: a decay at a rate k comes out as k (1 + k dt/2). And the
//! volumes V of step 3 are those before it, which leaves dt times the square of
//! the rate of density, times (h / wavelength)^2: nothing in a weakly compressible
//! flow. A drag -k v is applied exactly, as a factor exp(-k dt/2) to either half.
//!
//! The temperature of a van der Waals fluid is kicked with the velocity; there step 5 works with
//! velocity and temperature foretold for the end of the step ([`crate::physics::van_der_waals::flow`]).

use rayon::prelude::*;

use crate::particles::{Particles, ROWS_PER_TASK};

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
            *x += *v * (0.5 * dt);
        });
    heat(particles, dt, 0.25 * dt);
}

/// Half a step's heat, with either kick, of a velocity which acceleration has changed for `lead` seconds
/// on the average.
fn heat<const D: usize>(particles: &mut Particles<D>, dt: f64, lead: f64) {
    let rates = particles.heating.iter().zip(&particles.heating_gain);
    for (temperature, (rate, gain)) in particles.temperature.iter_mut().zip(rates) {
        *temperature += 0.5 * dt * (rate + lead * gain);
    }
}

/// Step 4.
pub(crate) fn drift<const D: usize>(particles: &mut Particles<D>, dt: f64) {
    (particles.position.par_iter_mut(), &particles.velocity)
        .into_par_iter()
        .with_min_len(ROWS_PER_TASK)
        .for_each(|(x, v)| *x += *v * (0.5 * dt));
}

/// Step 6.
pub(crate) fn kick<const D: usize>(particles: &mut Particles<D>, dt: f64, damping: f64) {
    let decay = (-0.5 * damping * dt).exp();
    (particles.velocity.par_iter_mut(), &particles.acceleration)
        .into_par_iter()
        .with_min_len(ROWS_PER_TASK)
        .for_each(|(v, a)| *v = *v * decay + *a * (0.5 * dt));
    heat(particles, dt, -0.25 * dt);
}
