//! Fluids and the walls around them.

use meniscus::physics::wall::layout::Layers;
use meniscus::scheme::{Scheme, Wall};
use meniscus::shape::{Arrangement, Pattern, Shape};
use meniscus::{Domain, Fluid, Particle, Setup, Vector};

/// Particles of a wall.
pub fn wall_particles<const D: usize>(
    positions: Vec<Vector<f64, D>>,
    body: u16,
    density: f64,
    spacing: f64,
) -> impl Iterator<Item = Particle<D>> {
    positions.into_iter().map(move |position| Particle {
        position,
        velocity: Vector::ZERO,
        mass: density * spacing.powi(D as i32),
        fluid: 0,
        body,
    })
}

pub fn layers(scheme: &Scheme, spacing: f64) -> Layers {
    let support = scheme.kernel.support() * scheme.smoothing_length;
    Layers::new(spacing, support, 1_000_000)
}

/// A tank `width` wide in every horizontal direction and `height` high, with its corner at the
/// origin, open at the top, and filled up to `depth`.
pub fn tank<const D: usize>(
    width: f64,
    height: f64,
    depth: f64,
    spacing: f64,
    scheme: Scheme,
    fluid: Fluid,
) -> Setup<D> {
    let upward = D - 1;
    let mut high = Vector([width; D]);
    high[upward] = depth;
    let block = Shape::Block {
        low: Vector::ZERO,
        high,
    };
    let arrangement = Arrangement::new(Pattern::Cubic, spacing);
    let mut particles = arrangement.body(&block, fluid.density, 1_000_000).unwrap();
    high[upward] = height;
    let wall = layers(&scheme, spacing)
        .tank(Vector::ZERO, high, &[(upward, true)])
        .unwrap();
    particles.extend(wall_particles(wall, 1, fluid.density, spacing));
    let mut scheme = scheme;
    scheme.walls = vec![Wall::new(1)];
    Setup {
        scheme,
        fluids: vec![fluid],
        particles,
        spacing,
        domain: Domain::default(),
    }
}

/// A channel between y = 0 and y = 1, periodic along x with `columns` particles, filled with
/// particles on a lattice; body 1 is the lower wall, body 2 the upper one.
pub fn channel(
    columns: usize,
    spacing: f64,
    scheme: Scheme,
    fluid: Fluid,
    walls: [Wall; 2],
) -> Setup<2> {
    let length = columns as f64 * spacing;
    let block = Shape::Block {
        low: Vector::ZERO,
        high: Vector([length, 1.0]),
    };
    let arrangement = Arrangement::new(Pattern::Cubic, spacing);
    let mut particles = arrangement.body(&block, fluid.density, 1_000_000).unwrap();
    let sides = [(0, false), (0, true)];
    let layers = layers(&scheme, spacing);
    for (body, y, open) in [(1, 0.0, (1, true)), (2, 1.0 - spacing, (1, false))] {
        let (low, high) = (Vector([0.0, y]), Vector([length, y + spacing]));
        let wall = layers.tank(low, high, &[sides[0], sides[1], open]).unwrap();
        particles.extend(wall_particles(wall, body, fluid.density, spacing));
    }
    let mut scheme = scheme;
    scheme.walls = walls.into();
    Setup {
        scheme,
        fluids: vec![fluid],
        particles,
        spacing,
        domain: Domain {
            periodic: [Some((0.0, length)), None],
        },
    }
}
