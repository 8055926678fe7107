//! The force between two particles at rest.

use super::{Rates, momentum};
use crate::particles::Particles;
use crate::physics::momentum::Momentum;
use crate::simulation::Simulation;
use crate::term::{PairTerm, ScaledKernel};
use crate::vector::Vector;

impl<const D: usize> Rates<D> {
    fn force_at_rest(
        &self,
        particles: &Particles<D>,
        [i, j]: [usize; 2],
        offset: Vector<f64, D>,
    ) -> Vector<f64, D> {
        let (scheme, fluids) = (&self.scheme, &self.fluids[..]);
        let smoothing_length = scheme.smoothing_length;
        let scaled = ScaledKernel::new(scheme.kernel, smoothing_length, D);
        let pair = scaled.pair(scaled.approach(offset, || smoothing_length));
        let material = self.walls.material(fluids);
        let push = Momentum {
            artificial_viscosity: 0.0,
            viscosity: None,
            ..momentum(scheme, fluids, material, Some(scheme.pressure))
        };
        let mut acceleration = Vector::ZERO;
        let (own, other) = (push.record(particles, i), push.record(particles, j));
        push.pair(&own, &other, &pair, &mut acceleration);
        let force = acceleration * particles.mass[i];
        match &self.pull {
            Some(pull) => force + pull.force_between(particles, [i, j], &pair),
            None => force,
        }
    }
}

impl<const D: usize> Simulation<D> {
    /// The force, N, that row `j`, or an image of it from which row `i` is `offset` metres, exerted on row `i` in
    /// the last step by pressure and by pairwise forces; without viscosity, and without grad-h terms.
    pub fn force_at_rest(&self, rows: [usize; 2], offset: Vector<f64, D>) -> Vector<f64, D> {
        let particles = self.particles();
        self.rates.force_at_rest(particles, rows, offset)
    }

    /// The pressure, Pa, that the forces between particles at rest make in a ball about `centre` of `radius`
    /// metres, liquid alone: the mean of 1/(2 D V_i) sum_j x_ij . f_ij. None where it holds no particle.
    ///
    /// In a weakly compressible liquid with cohesion it is the small difference of two large pressures, that of the
    /// equation of state and that of the pairwise forces; disorder changes what the first comes to between particles.
    pub fn mechanical_pressure(&self, centre: Vector<f64, D>, radius: f64) -> Option<f64> {
        let (particles, scheme) = (self.particles(), self.scheme());
        let reach = scheme.kernel.support() * scheme.smoothing_length;
        let within = |limit: f64| -> Vec<usize> {
            let away = |i: usize| (particles.position[i] - centre).norm_squared();
            (0..particles.len())
                .filter(|&i| away(i) < limit * limit && !self.is_wall(particles.body[i]))
                .collect()
        };
        let (inside, near) = (within(radius), within(radius + reach));
        let (mut virial, mut volume) = (0.0, 0.0);
        for &i in &inside {
            volume += particles.volume(i);
            for &j in &near {
                let line = particles.position[i] - particles.position[j];
                let square = line.norm_squared();
                if square > 0.0 && square < reach * reach {
                    virial += self.force_at_rest([i, j], line).dot(&line);
                }
            }
        }
        (volume > 0.0).then(|| virial / (2.0 * D as f64 * volume))
    }
}
