//! Density at the end of a step, and pressure.

use rayon::prelude::*;

use super::Rates;
use crate::particles::{Particles, ROWS_PER_TASK};
use crate::physics::continuity::{self, Continuity, NumberContinuity};
use crate::physics::summation::Summation;
use crate::physics::velocity_gradient::VelocityGradient;
use crate::physics::velocity_smoothing::VelocitySmoothing;
use crate::scheme::DensityForm;
use crate::term::Sweep;

impl<const D: usize> Rates<D> {
    /// Density at the end of a step of `dt` seconds that starts at `time`, then pressure. By
    /// continuity from positions and velocities at its middle, where XSPH moves
    /// particles too; by summation from positions at its end.
    pub(crate) fn advance_density(&mut self, particles: &mut Particles<D>, time: f64, dt: f64) {
        self.walls.go_halfway(&self.pairs, particles, dt);
        match self.scheme.density {
            DensityForm::Continuity | DensityForm::Number | DensityForm::Corrected => {
                self.walls.meet(&mut self.pairs, particles);
                self.find_compression(particles);
                // The pressure beyond capillary pressure has either sign.
                let pull = self.capillary_tension().is_some();
                self.walls
                    .compress(&mut self.pairs, particles, pull, &mut self.scalars);
                self.diffuse(particles, time + 0.5 * dt);
                self.smooth_motion(particles, dt);
                (particles.density.par_iter_mut(), &self.scalars)
                    .into_par_iter()
                    .with_min_len(ROWS_PER_TASK)
                    .for_each(|(density, rate)| *density += dt * *density * rate);
            }
            DensityForm::Summation => {
                self.adapt_smoothing(particles);
                self.pairs
                    .sweep(&Summation, particles, |_| true, &mut self.scalars);
                particles.density.copy_from_slice(&self.scalars);
            }
        }
        self.update_pressure(particles);
        if let Some(fluid) = &mut self.van_der_waals {
            fluid.prepare(&mut self.pairs, particles, dt);
        }
    }

    /// Gives particles the smoothing lengths that follow density, and builds new lists where these
    /// are too short for them.
    fn adapt_smoothing(&mut self, particles: &mut Particles<D>) {
        let Some(model) = self.scheme.adaptive_smoothing else {
            return;
        };
        let h = self.scheme.smoothing_length;
        model.adapt(h, &mut self.pairs, particles, &mut self.pilot);
        if self.pairs.is_stale(particles) {
            self.pairs.rebuild(particles);
            // The pilot in the new order of rows, and lengths as a resumed run finds them.
            model.adapt(h, &mut self.pairs, particles, &mut self.pilot);
        }
    }

    /// (1/rho) D rho/Dt by the motion of particles, 1/s, into the column of scalars.
    fn find_compression(&mut self, particles: &Particles<D>) {
        let (rates, walls) = (&mut self.scalars, &self.walls);
        let matters = |rows| walls.is_liquid_or_may_be_wet(particles, rows);
        match self.scheme.density {
            DensityForm::Number => {
                self.pairs
                    .sweep(&NumberContinuity, particles, matters, rates);
            }
            DensityForm::Corrected => {
                let sums = &mut self.velocity_gradients;
                self.pairs
                    .sweep(&VelocityGradient, particles, matters, sums);
                rates.resize(particles.len(), 0.0);
                (rates.par_iter_mut(), &*sums, &particles.body)
                    .into_par_iter()
                    .with_min_len(ROWS_PER_TASK)
                    .for_each(|(rate, sum, &body)| {
                        // What walls do to the fluid is the adjoint of the plain sum.
                        *rate = if walls.is_wall(body) {
                            continuity::plain(sum)
                        } else {
                            continuity::corrected(sum)
                        };
                    });
            }
            DensityForm::Continuity | DensityForm::Summation => {
                self.pairs.sweep(&Continuity, particles, matters, rates);
            }
        }
    }

    /// Adds diffusion to the rates of density at `time` seconds.
    fn diffuse(&mut self, particles: &mut Particles<D>, time: f64) {
        let Some(diffusion) = self.scheme.density_diffusion else {
            return;
        };
        let gravity = self.body_force(time);
        self.walls.hide(particles, |_| true);
        self.diffusing.add(
            diffusion,
            &mut self.pairs,
            particles,
            &self.fluids,
            self.scheme.smoothing_length,
            gravity,
            &mut self.scalars,
        );
        self.walls.show(particles);
    }

    /// Moves particles towards the velocity of their surroundings, for `dt` seconds.
    fn smooth_motion(&mut self, particles: &mut Particles<D>, dt: f64) {
        let strength = self.scheme.velocity_smoothing;
        if strength == 0.0 {
            return;
        }
        let term = VelocitySmoothing { strength };
        self.walls.hide(particles, |_| true);
        self.pairs
            .sweep(&term, particles, |_| true, &mut self.vectors);
        self.walls.show(particles);
        self.walls.keep(&mut self.vectors);
        (particles.position.par_iter_mut(), &self.vectors)
            .into_par_iter()
            .with_min_len(ROWS_PER_TASK)
            .for_each(|(position, velocity)| *position += *velocity * dt);
    }

    /// Pressure by density.
    pub(crate) fn update_pressure(&self, particles: &mut Particles<D>) {
        (
            particles.pressure.par_iter_mut(),
            &particles.density,
            &particles.fluid,
        )
            .into_par_iter()
            .with_min_len(ROWS_PER_TASK)
            .for_each(|(pressure, density, fluid)| {
                *pressure = self.equations_of_state[*fluid as usize].pressure(*density);
            });
    }
}
