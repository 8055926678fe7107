//! What the continuum surface force of Qiang, Chen and Gao promises, on a free
//! surface and between two fluids.
//!
//! - `flat`: on a flat layer the force adds up to sigma
//! - `geometry`: curvature of a cylinder and a sphere
//! - `momentum`: what the forces on a disordered drop add up to
//! - `drops`: pressure in a drop at rest, alone and in another fluid
//! - `viscous_stress`: the dissipation of a motion with a constant gradient

#[path = "../common/mod.rs"]
mod common;

mod drops;
mod flat;
mod geometry;
mod momentum;
mod viscous_stress;

use common::{fluid, scheme};
use meniscus::physics::surface_tension::continuum::Continuum;
use meniscus::scheme::{Scheme, SurfaceTension};
use meniscus::shape::{Arrangement, Pattern, Shape};
use meniscus::{Domain, Kernel, Particle, Setup, Vector};

/// Fills a shape with liquid of density 1 and surface tension 1, on a lattice of
/// spacing 1; cubic spline, h = 2 dx.
pub fn liquid<const D: usize>(
    shape: &Shape<D>,
    pattern: Pattern,
    jitter: f64,
    model: Continuum,
) -> Setup<D> {
    let mut lattice = Arrangement::new(pattern, 1.0);
    lattice.jitter = jitter;
    let particles = (lattice.fill(shape, 200_000).expect("it fits").iter())
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
            kernel: Kernel::CubicSpline,
            smoothing_length: 2.0,
            artificial_viscosity: 0.1,
            surface_tension: Some(SurfaceTension::Continuum(model)),
            ..scheme(1.0)
        },
        fluids: vec![fluid(0.0, 1.0)],
        particles,
        spacing: 1.0,
        domain: Domain::default(),
    }
}

/// A disc or ball of liquid about the origin, `radius` in spacings.
pub fn ball<const D: usize>(
    radius: f64,
    pattern: Pattern,
    jitter: f64,
    model: Continuum,
) -> Setup<D> {
    let centre = Vector::ZERO;
    liquid(&Shape::Ball { centre, radius }, pattern, jitter, model)
}
