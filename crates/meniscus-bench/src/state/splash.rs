//! Two drops fly at one another, a little off centre, in a periodic box; the
//! sheet that they burst into meets its own image. What lies there then,
//! clusters, holes and spray, is laid side by side as often as needed.

use meniscus::particles::Particle;
use meniscus::rates::{Dimension, Space};
use meniscus::{Domain, Setup, Simulation, Vector};

use super::lattice::Random;
use super::{Flow, SOUND_SPEED, cut, fluid, particle, scheme};
use crate::BenchError;

/// Share of the box that is liquid.
const FILLED: f64 = 0.4;
/// Speed of each drop over the sound speed.
const MACH: f64 = 0.05;
/// The end, in times that a drop needs to cross its own diameter.
const CROSSINGS: f64 = 1.0;

/// A box of a splash.
#[derive(Clone, Debug)]
pub struct Piece<const D: usize> {
    particles: Vec<Particle<D>>,
    side: f64,
    /// How it came about.
    pub story: String,
}

/// Marches a splash of about `count` particles.
///
/// # Errors
/// If it blows up.
pub fn march<const D: usize>(count: usize) -> Result<Piece<D>, BenchError>
where
    Space: Dimension<D>,
{
    let side = (count as f64 / FILLED).powf(1.0 / D as f64);
    // Volume of a ball over that of the cube of its radius.
    let ball = std::f64::consts::PI * if D == 2 { 1.0 } else { 4.0 / 3.0 };
    let radius = (0.5 * count as f64 / ball).powf(1.0 / D as f64);
    let speed = MACH * SOUND_SPEED;
    let mut random = Random(2);
    let mut particles = Vec::with_capacity(count);
    for direction in [1.0, -1.0] {
        let mut centre = [0.5 * side; D];
        centre[0] -= direction * (radius + 0.5);
        centre[1] -= direction * 0.25 * radius;
        let half = radius.ceil() as i64;
        let cells = (2 * half + 1).pow(D as u32);
        for k in 0..cells {
            let offset: [f64; D] = std::array::from_fn(|d| {
                (k / (2 * half + 1).pow(d as u32) % (2 * half + 1) - half) as f64
            });
            if Vector(offset).norm() <= radius {
                let x = |d: usize| centre[d] + offset[d] + 0.1 * random.symmetric();
                let mut velocity = [0.0; D];
                velocity[0] = direction * speed;
                particles.push(particle(std::array::from_fn(x), velocity));
            }
        }
    }
    let domain = Domain {
        periodic: [Some((0.0, side)); D],
    };
    let mut simulation = Simulation::new(Setup {
        scheme: scheme::<D>(Flow::Plain),
        fluids: vec![fluid(Flow::Plain)],
        particles,
        spacing: 1.0,
        domain,
    })?;
    simulation.advance_to(CROSSINGS * 2.0 * radius / speed)?;
    let p = simulation.particles();
    let story = format!(
        "two {} of {} particles in all, flying at one another at Mach {MACH} each in a periodic \
         box, after {} steps; copies of it side by side",
        if D == 2 { "discs" } else { "drops" },
        p.len(),
        simulation.steps()
    );
    let particles = (p.position.iter().zip(&p.velocity))
        .map(|(x, v)| {
            let mut x = *x;
            domain.wrap(&mut x);
            particle(x.0, v.0)
        })
        .collect();
    Ok(Piece {
        particles,
        side,
        story,
    })
}

impl<const D: usize> Piece<D> {
    /// A cube of `count` particles, cut out of as many copies as it takes.
    pub fn block(&self, count: usize) -> Vec<Particle<D>> {
        let copies = (1..)
            .find(|n: &usize| n.pow(D as u32) * self.particles.len() >= count)
            .unwrap_or(1);
        let mut particles = Vec::with_capacity(copies.pow(D as u32) * self.particles.len());
        for k in 0..copies.pow(D as u32) {
            let shift: [f64; D] =
                std::array::from_fn(|d| (k / copies.pow(d as u32) % copies) as f64 * self.side);
            particles.extend(self.particles.iter().map(|p| Particle {
                position: p.position + Vector(shift),
                ..*p
            }));
        }
        cut(&mut particles, [0.5 * copies as f64 * self.side; D], count);
        particles
    }
}
