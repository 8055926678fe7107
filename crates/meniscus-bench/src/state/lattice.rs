//! A cube of a jittered lattice, stirred by an eddy that fills it, whose
//! fastest particle moves at a tenth of the sound speed. The eddy leaves the
//! cube a cube, and shears it little in the steps of a sample.

use std::f64::consts::PI;

use meniscus::particles::Particle;

use super::{SOUND_SPEED, cut, particle};

/// Largest displacement along each axis, spacings.
const JITTER: f64 = 0.05;

/// `count` particles.
pub fn cube<const D: usize>(count: usize) -> Vec<Particle<D>> {
    let side = side::<D>(count);
    let mut particles = stirred(side, PI / side as f64);
    cut(&mut particles, [0.5 * side as f64; D], count);
    particles
}

/// At least `count` particles, and the side of the periodic box that they fill with four eddies.
pub fn full<const D: usize>(count: usize) -> (Vec<Particle<D>>, f64) {
    let side = side::<D>(count);
    (stirred(side, 2.0 * PI / side as f64), side as f64)
}

/// Cells along each side for `count` particles.
fn side<const D: usize>(count: usize) -> usize {
    (1..)
        .find(|side: &usize| side.pow(D as u32) >= count)
        .unwrap_or(1)
}

/// A full lattice in eddies of this wave number.
fn stirred<const D: usize>(side: usize, wave_number: f64) -> Vec<Particle<D>> {
    let mut random = Random(1);
    (0..side.pow(D as u32))
        .map(|k| {
            let cell: [usize; D] = std::array::from_fn(|d| k / side.pow(d as u32) % side);
            let x = cell.map(|i| i as f64 + 0.5 + JITTER * random.symmetric());
            let (a, b) = (wave_number * x[0], wave_number * x[1]);
            let mut velocity = [0.0; D];
            velocity[0] = 0.1 * SOUND_SPEED * a.sin() * b.cos();
            velocity[1] = -0.1 * SOUND_SPEED * a.cos() * b.sin();
            particle(x, velocity)
        })
        .collect()
}

/// Knuth's linear congruential generator: the same lattice for ever.
pub struct Random(pub u64);

impl Random {
    /// Uniform in [-1, 1).
    pub fn symmetric(&mut self) -> f64 {
        let next = (self.0).wrapping_mul(6_364_136_223_846_793_005);
        self.0 = next.wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 * (2.0 / (1_u64 << 53) as f64) - 1.0
    }
}
