//! What the surface force of Jancik and Hyhlik promises.
//!
//! - `geometry`: normals and curvature of exact shapes
//! - `force`: what the forces add up to, and what they are invariant under
//! - `drops`: a drop at rest has a pressure, a drop out of shape has a frequency

#[path = "../common/mod.rs"]
mod common;

mod drops;
mod force;
mod geometry;

use common::{fluid, scheme};
use meniscus::physics::surface_tension::jancik_hyhlik::JancikHyhlik;
use meniscus::scheme::{Scheme, SurfaceTension};
use meniscus::shape::{Arrangement, Pattern, Shape};
use meniscus::{Domain, Kernel, Particle, Setup, Vector};

/// Fills a shape with liquid of density 1 and surface tension 1, on a lattice of
/// spacing 1; truncated Gaussian, h = 1.5 dx, normals from 0.01 / h on, as in the paper.
pub fn liquid<const D: usize>(shape: &Shape<D>, pattern: Pattern, jitter: f64) -> Setup<D> {
    let mut lattice = Arrangement::new(pattern, 1.0);
    lattice.jitter = jitter;
    let positions = lattice.fill(shape, 100_000).expect("it fits");
    let particles = (positions.iter())
        .map(|&position| Particle {
            position,
            velocity: Vector::ZERO,
            mass: lattice.particle_volume(),
            fluid: 0,
            body: 0,
        })
        .collect();
    Setup {
        scheme: Scheme {
            kernel: Kernel::TruncatedGaussian,
            smoothing_length: 1.5,
            artificial_viscosity: 0.1,
            surface_tension: Some(SurfaceTension::JancikHyhlik(JancikHyhlik {
                threshold: 0.01,
                ..JancikHyhlik::default()
            })),
            ..scheme(1.0)
        },
        fluids: vec![fluid(0.0, 1.0)],
        particles,
        spacing: 1.0,
        domain: Domain::default(),
    }
}

/// A disc or ball of liquid about the origin, `radius` in spacings.
pub fn ball<const D: usize>(radius: f64, pattern: Pattern, jitter: f64) -> Setup<D> {
    let centre = Vector::ZERO;
    liquid(&Shape::Ball { centre, radius }, pattern, jitter)
}

/// Volume of all particles.
pub fn volume<const D: usize>(setup: &Setup<D>) -> f64 {
    setup.particles.iter().map(|particle| particle.mass).sum()
}
