//! A complete simulation: an ellipse of water, 2 mm across, swings under
//! surface tension; its semi-axes are printed every half millisecond.
//!
//! `cargo run --release -p meniscus --example oscillating_drop`

use meniscus::scheme::PressureForm;
use meniscus::shape::{Arrangement, Pattern, Rotation, Shape};
use meniscus::{Domain, Fluid, Scheme, Setup, Simulation, SurfaceTension, Vector, measure};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let spacing = 0.05e-3;
    let mut water = Fluid::new("water", 998.0);
    water.surface_tension = 0.0728;
    water.sound_speed = 5.0;
    let centre = Vector::ZERO;
    let semi_axes = Vector([1.1e-3, 0.9e-3]);
    let rotation = Rotation::none();
    let ellipse = Shape::<2>::Ellipsoid {
        centre,
        semi_axes,
        rotation,
    };
    let lattice = Arrangement::new(Pattern::ClosePacked, spacing);
    let particles = lattice.body(&ellipse, water.density, 1_000_000)?;
    let mut scheme = Scheme::new(2.0 * spacing);
    scheme.surface_tension = Some(SurfaceTension::default());
    scheme.pressure = PressureForm::OverDensityProduct;
    let (fluids, domain) = (vec![water], Domain::default());
    let mut drop = Simulation::new(Setup {
        scheme,
        fluids,
        particles,
        spacing,
        domain,
    })?;
    for frame in 0..=20 {
        drop.advance_to(f64::from(frame) * 0.5e-3)?;
        let p = drop.particles();
        let axes = measure::semi_axes_along_coordinates(&p.position, &p.mass).unwrap_or_default();
        let [x, y] = axes.map(|axis| axis * 1e3);
        println!("{:.2} ms  {x:.4} mm  {y:.4} mm", drop.time() * 1e3);
    }
    Ok(())
}
