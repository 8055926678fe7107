//! Diffusion of density: what it keeps, and a liquid at rest under it.

use meniscus::physics::density_diffusion::{DensityGradient, Diffusion};
use meniscus::physics::surface_tension::gradient::Correctable;
use meniscus::scheme::{DensityDiffusion, DiffusionForm};
use meniscus::shape::{Arrangement, Pattern, Shape};
use meniscus::{Domain, Kernel, Particles, Vector, reference};

use crate::common::noise;
use crate::hydrostatics::{at_rest, worst};

/// A jittered drop, half of it of another fluid, of this density.
fn drop<const D: usize>(density: impl Fn(usize, Vector<f64, D>) -> f64) -> Particles<D> {
    let ball = Shape::Ball {
        centre: Vector::ZERO,
        radius: 0.45,
    };
    let lattice = Arrangement::new(Pattern::Cubic, 0.1);
    let mut start = lattice.body(&ball, 1000.0, 10_000).unwrap();
    for (k, particle) in start.iter_mut().enumerate() {
        for d in 0..D {
            particle.position[d] += 0.02 * noise((k * D + d) as i64);
        }
        particle.fluid = u16::from(particle.position[0] > 0.0);
    }
    let mut particles = Particles::new(&start);
    for i in 0..particles.len() {
        particles.density[i] = density(i, particles.position[i]);
    }
    particles
}

/// Rate of density over delta h c by the form of Antuono, 1/m^2 times kg/m^3.
fn flux<const D: usize>(particles: &Particles<D>) -> Vec<f64> {
    let (kernel, h, domain) = (Kernel::WendlandC2, 0.2, Domain::default());
    let gradients: Vec<_> = reference::sums(&DensityGradient, kernel, h, &domain, particles)
        .iter()
        .map(Correctable::corrected)
        .collect();
    let gradients = &gradients;
    reference::sums(&Diffusion { gradients }, kernel, h, &domain, particles)
}

#[test]
fn what_one_particle_gains_in_volume_another_gives_away() {
    let particles = drop::<2>(|i, _| 1000.0 + 10.0 * noise(i as i64));
    let flux = flux(&particles);
    let shares = || (0..particles.len()).map(|i| particles.volume(i) * flux[i]);
    let sum: f64 = shares().sum();
    let size: f64 = shares().map(f64::abs).sum();
    // Rounding of a hundred numbers.
    assert!(sum.abs() < 1e-13 * size, "{sum} of {size}");
}

fn linear_density_stays<const D: usize>() {
    // Of either fluid linear by itself; they do not mix.
    let particles = drop::<D>(|_, x| {
        if x[0] > 0.0 {
            1000.0 + 20.0 * x[0] - 30.0 * x[1]
        } else {
            10.0 + x[D - 1]
        }
    });
    for flux in flux(&particles) {
        // Slopes of 30 over a smoothing length of 0.2 and its square.
        assert!(flux.abs() < 1e-11 * 30.0 / 0.2, "{flux}");
    }
}

#[test]
fn a_linear_density_does_not_diffuse_up_to_surfaces() {
    linear_density_stays::<2>();
    linear_density_stays::<3>();
}

/// The height of the surface over the depth, and the largest error of pressure over that at the
/// bottom, of ten layers of liquid after times in which a wrong diffusion would part them.
fn settled(form: DiffusionForm) -> (f64, f64) {
    let simulation = at_rest::<2>(0.1, 1000.0, 6.0, |scheme| {
        let strength = 0.1;
        scheme.density_diffusion = Some(DensityDiffusion { form, strength });
    });
    let p = simulation.particles();
    let highest = (0..p.len())
        .filter(|&i| !simulation.is_wall(p.body[i]))
        .map(|i| p.position[i][1])
        .fold(0.0, f64::max);
    (highest + 0.05, worst(&simulation, 1000.0))
}

#[test]
fn a_liquid_at_rest_keeps_its_surface_if_its_own_gradient_does_not_diffuse() {
    for form in [DiffusionForm::Antuono, DiffusionForm::Fourtakas] {
        let (height, error) = settled(form);
        // Its weight compresses it by c^-2 g H / 2 = 0.5 %. Half a spacing's head is 5 %.
        assert!((height - 0.995).abs() < 0.01, "{form:?}: {height}");
        assert!(error < 0.05, "{form:?}: {error}");
    }
    // The oldest form diffuses the gradient that carries the weight: layers part without end.
    let (_, error) = settled(DiffusionForm::MolteniColagrossi);
    assert!(error > 0.15, "{error}");
}
