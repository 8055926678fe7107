//! A complete simulation: an ellipse of water, 2 mm across, swings under
//! surface tension; its longer axis is printed once every half millisecond.
//!
//! `cargo run --release -p meniscus --example oscillating_drop`

use meniscus::shape::{Arrangement, Pattern, Rotation, Shape};
use meniscus::{
    Domain, Fluid, Kernel, Particle, Scheme, Setup, Simulation, SurfaceTension, Vector, measure,
};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let spacing = 0.05e-3;
    let water = Fluid {
        surface_tension: 0.0728,
        sound_speed: 5.0,
        ..Fluid::new("water", 998.0)
    };
    let ellipse = Shape::<2>::Ellipsoid {
        centre: Vector::ZERO,
        semi_axes: Vector([1.1e-3, 0.9e-3]),
        rotation: Rotation::none(),
    };
    let lattice = Arrangement::new(Pattern::ClosePacked, spacing);
    let mass = water.density * lattice.particle_volume();
    let particles = lattice
        .fill(&ellipse, 1_000_000)?
        .into_iter()
        .map(|position| Particle {
            position,
            velocity: Vector::ZERO,
            mass,
            fluid: 0,
            body: 0,
        })
        .collect();
    let scheme = Scheme {
        kernel: Kernel::TruncatedGaussian,
        surface_tension: Some(SurfaceTension::default()),
        ..Scheme::new(1.5 * spacing)
    };
    let domain = Domain::default();
    let mut drop = Simulation::new(Setup {
        scheme,
        fluids: vec![water],
        particles,
        spacing,
        domain,
    })?;
    for frame in 0..=20 {
        drop.advance_to(f64::from(frame) * 0.5e-3)?;
        let p = drop.particles();
        let axes = measure::semi_axes_along_coordinates(&p.position, &p.mass).unwrap_or_default();
        println!(
            "{:.2} ms  {:.4} mm  {:.4} mm",
            drop.time() * 1e3,
            axes[0] * 1e3,
            axes[1] * 1e3
        );
    }
    Ok(())
}
