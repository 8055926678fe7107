//! Work that is done on the liquid from outside.

use serde::{Deserialize, Serialize};

use crate::particles::Particles;
use crate::vector::Vector;

/// Work done on the liquid since t = 0, J; in 2D J/m.
///
/// What it adds to the liquid's kinetic, compression and surface energy, but for what friction
/// turns into heat. Of second order in the time step, as the march is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Work {
    /// By the body force: the integral of sum m g.v. Of a constant one it is what the liquid
    /// lost in height.
    pub body_force: f64,
    /// By walls that move: the integral of sum F.v over their particles, F the force on the liquid.
    pub walls: f64,
    /// What walls did at the last force, W.
    power: f64,
}

impl Work {
    /// A drift of `dt` seconds in a mean body force, m/s^2, of the particles that `moves` holds for.
    pub(crate) fn fall<const D: usize>(
        &mut self,
        particles: &Particles<D>,
        moves: impl Fn(u16) -> bool,
        body_force: Vector<f64, D>,
        dt: f64,
    ) {
        let columns = (particles.velocity.iter().zip(&particles.mass)).zip(&particles.body);
        let mut momentum = Vector::ZERO;
        for ((&v, &m), &body) in columns {
            if moves(body) {
                momentum += v * m;
            }
        }
        self.body_force += momentum.dot(&body_force) * dt;
    }

    /// A step of `dt` seconds at whose end walls do work at this rate, W.
    pub(crate) fn push(&mut self, power: f64, dt: f64) {
        self.walls += 0.5 * (self.power + power) * dt;
        self.power = power;
    }
}
