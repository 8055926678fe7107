//! The curvature of a disc at rest whose surface has ripples: what the sharpening is for, and
//! what its strength was chosen by.

use meniscus::{Simulation, Vector};

use crate::ball;

/// Curvature found over exact of n waves around a disc: of what a flow without divergence, with the
/// potential r^n cos(n phi), makes of it, one way and the other.
fn transfer(radius: f64, waves: i32) -> f64 {
    let amplitude = 0.02;
    let at = |x: &Vector<f64, 2>| (x.norm() / radius, x[1].atan2(x[0]));
    let find = |sign: f64| {
        let mut setup = ball::<2>(Vector::ZERO, radius, 0.0, 0.0);
        for particle in &mut setup.particles {
            let (r, phi) = at(&particle.position);
            let length = sign * amplitude * r.powi(waves - 1);
            let (sin, cos) = (f64::from(waves - 1) * phi).sin_cos();
            particle.position += Vector([length * cos, -length * sin]);
        }
        let simulation = Simulation::new(setup).expect("a sound setup");
        let p = simulation.particles();
        let mut found = vec![(0.0, Vector::ZERO); p.len()];
        for i in 0..p.len() {
            found[p.id[i] as usize] = (simulation.surface().curvature[i], p.position[i]);
        }
        found
    };
    let (mut sum, mut squares) = (0.0, 0.0);
    for (one, other) in find(1.0).iter().zip(&find(-1.0)) {
        let (r, phi) = at(&((one.1 + other.1) * 0.5));
        if r * radius > radius - 1.5 {
            let wave = (f64::from(waves) * phi).cos();
            sum += (one.0 - other.0) / (2.0 * amplitude) * wave;
            squares += wave * wave;
        }
    }
    // kappa of r = R + a cos(n phi), of first order in a.
    let exact = f64::from(waves * waves - 1) / (radius * radius);
    sum / squares / exact
}

#[test]
fn long_ripples_have_their_curvature_and_short_ones_none() {
    // Waves of 31 and 21 spacings: within what a lattice leaves of the smoothing's second order.
    for waves in [4, 6] {
        let found = transfer(20.0, waves);
        assert!((found - 1.0).abs() < 0.1, "{waves} waves: {found}");
    }
    // Of 5 spacings: blind, but never with the wrong sign.
    let found = transfer(20.0, 25);
    assert!((0.0..0.2).contains(&found), "{found}");
}
