//! A pair term of your own: the vorticity of a flow, curl v = sum V_j
//! (v_j - v_i) x grad W, in 2D. The formula is written once; the engine runs
//! it eight particles at a time.
//!
//! `cargo run --release -p meniscus --example own_pair_term`

use meniscus::term::Pair;
use meniscus::{
    Domain, Fluid, PairTerm, Particle, Particles, Real, Scheme, Setup, Simulation, Vector,
};

meniscus::record! {
    /// What the formula reads of a particle.
    struct Moving<R, D> {
        /// m/s
        velocity: Vector<R, D>,
        /// m^2
        volume: R,
    }
}

#[derive(Clone, Copy)]
struct Vorticity;

impl PairTerm<2> for Vorticity {
    type Record<R: Real> = Moving<R, 2>;
    type Sum<R: Real> = R;

    fn record(&self, particles: &Particles<2>, i: usize) -> Moving<f64, 2> {
        Moving {
            velocity: particles.velocity[i],
            volume: particles.volume(i),
        }
    }

    fn pair<R: Real>(&self, i: &Moving<R, 2>, j: &Moving<R, 2>, ij: &Pair<R, 2>, sum: &mut R) {
        let v = j.velocity - i.velocity;
        *sum = *sum + j.volume * (v[1] * ij.grad_w[0] - v[0] * ij.grad_w[1]);
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // A square of water in rigid rotation: its vorticity is twice the rate, 20 /s, in the middle.
    let spacing = 0.02;
    let particles = (0..2500)
        .map(|k| {
            let position = Vector([(k % 50) as f64 - 24.5, (k / 50) as f64 - 24.5]) * spacing;
            let velocity = Vector([-10.0 * position[1], 10.0 * position[0]]);
            Particle {
                position,
                velocity,
                mass: 1000.0 * spacing * spacing,
                fluid: 0,
                body: 0,
            }
        })
        .collect();
    let fluids = vec![Fluid {
        sound_speed: 100.0,
        ..Fluid::new("water", 1000.0)
    }];
    let (scheme, domain) = (Scheme::new(2.0 * spacing), Domain::default());
    let mut flow = Simulation::new(Setup {
        scheme,
        fluids,
        particles,
        spacing,
        domain,
    })?;
    let vorticity = flow.sum(&Vorticity);
    let nearest = (0..vorticity.len())
        .min_by(|&a, &b| {
            let distance = |i: usize| flow.particles().position[i].norm();
            distance(a).total_cmp(&distance(b))
        })
        .unwrap_or(0);
    println!("vorticity in the middle: {:.4} /s", vorticity[nearest]);
    Ok(())
}
