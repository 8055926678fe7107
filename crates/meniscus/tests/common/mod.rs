//! Flows that several tests start from.
#![allow(dead_code)] // each test file uses a part

use meniscus::fluid::Fluid;
use meniscus::measure::{Base, DropOnWall, Plane};
use meniscus::physics::wall::layout::Layers;
use meniscus::scheme::{Adhesion, Scheme, Slip, SurfaceTension, ViscosityForm, Wall};
use meniscus::{Domain, Particle, Setup, Simulation, Vector};

/// Unit density, viscosity `viscosity`, tension `surface_tension`, sound speed 10.
pub fn fluid(viscosity: f64, surface_tension: f64) -> Fluid {
    Fluid {
        viscosity,
        surface_tension,
        ..Fluid::new("fluid", 1.0)
    }
}

/// Plain weakly compressible flow, no viscosity, Wendland C2, h = 2 dx.
pub fn scheme(spacing: f64) -> Scheme {
    Scheme {
        artificial_viscosity: 0.0,
        viscosity: ViscosityForm::Morris,
        ..Scheme::new(2.0 * spacing)
    }
}

/// A box full of particles on a lattice of `n` per side, side 1, periodic on
/// all axes, with velocity from position.
pub fn periodic_box<const D: usize>(
    n: usize,
    velocity: impl Fn(Vector<f64, D>) -> Vector<f64, D>,
    fluid: Fluid,
) -> Setup<D> {
    periodic_lattice([n; D], 1.0 / n as f64, velocity, fluid)
}

/// A box of `counts` cells of size `spacing`, one particle in the middle of
/// each, one corner at the origin, periodic on all axes, with velocity from position.
pub fn periodic_lattice<const D: usize>(
    counts: [usize; D],
    spacing: f64,
    velocity: impl Fn(Vector<f64, D>) -> Vector<f64, D>,
    fluid: Fluid,
) -> Setup<D> {
    let particles = (0..counts.iter().product())
        .map(|k: usize| {
            let mut rest = k;
            let position = Vector(counts.map(|count| {
                let cell = rest % count;
                rest /= count;
                (cell as f64 + 0.5) * spacing
            }));
            Particle {
                position,
                velocity: velocity(position),
                mass: fluid.density * spacing.powi(D as i32),
                fluid: 0,
                body: 0,
            }
        })
        .collect();
    Setup {
        scheme: scheme(spacing),
        fluids: vec![fluid],
        particles,
        spacing,
        domain: Domain {
            periodic: counts.map(|count| Some((0.0, count as f64 * spacing))),
        },
    }
}

/// Noise between -1 and 1, the same for ever.
pub fn noise(k: i64) -> f64 {
    let x = (k as f64 * 78.233).sin() * 43_758.545_3;
    2.0 * (x - x.floor()) - 1.0
}

/// Particles of unit mass where `inside` says, out of a square or cubic lattice of spacing one within `reach` of
/// the origin, which is a corner of cells; jittered by a part of a spacing.
pub fn strewn<const D: usize>(
    reach: f64,
    jitter: f64,
    inside: impl Fn(Vector<f64, D>) -> bool,
) -> Vec<Particle<D>> {
    let half = reach.ceil() as i64 + 1;
    let side = 2 * half;
    let particles = (0..side.pow(D as u32)).filter_map(|k| {
        let place: Vector<f64, D> = Vector(std::array::from_fn(|d| {
            (k / side.pow(d as u32) % side - half) as f64 + 0.5
        }));
        let shift = Vector(std::array::from_fn(|d| {
            jitter * noise(7 * k + 31 * d as i64 + 1)
        }));
        inside(place).then_some(Particle {
            position: place + shift,
            velocity: Vector::ZERO,
            mass: 1.0,
            fluid: 0,
            body: 0,
        })
    });
    particles.collect()
}

/// An ellipse or ellipsoid, semi-axis 1.25 along x and 1 along the others,
/// cut from a cubic lattice that is shifted and jittered, with surface tension.
pub fn free_drop<const D: usize>(spacing: f64, jitter: f64) -> Setup<D> {
    let n = (1.4 / spacing) as i64;
    let side = 2 * n + 1;
    let mut particles = Vec::new();
    for k in 0..side.pow(D as u32) {
        let position: Vector<f64, D> = Vector(std::array::from_fn(|d| {
            let cell = (k / side.pow(d as u32) % side - n) as f64;
            (cell + 0.31 + jitter * noise(k * 12 + d as i64 * 5)) * spacing
        }));
        let stretched = Vector::<f64, D>(std::array::from_fn(|d| {
            position[d] / if d == 0 { 1.25 } else { 1.0 }
        }));
        if stretched.norm() < 1.0 {
            particles.push(Particle {
                position,
                velocity: Vector::ZERO,
                mass: spacing.powi(D as i32),
                fluid: 0,
                body: 0,
            });
        }
    }
    let mut scheme = scheme(spacing);
    scheme.artificial_viscosity = 0.1;
    scheme.surface_tension = Some(SurfaceTension::JancikHyhlik(Default::default()));
    Setup {
        scheme,
        fluids: vec![fluid(0.0, 1.0)],
        particles,
        spacing,
        domain: Domain::default(),
    }
}

/// Ten steps; what the sizes of all impulses in them, and of their moments about the origin, add up to:
/// the scale of what momentum may lose to rounding.
pub fn ten_steps<const D: usize>(simulation: &mut Simulation<D>) -> (f64, f64) {
    let (mut forces, mut torques) = (0.0, 0.0);
    for _ in 0..10 {
        simulation.step().expect("short of any disaster");
        let p = simulation.particles();
        for i in 0..p.len() {
            let force = p.acceleration[i].norm() * p.mass[i] * simulation.next_step();
            forces += force;
            torques += force * p.position[i].norm();
        }
    }
    (forces, torques)
}

/// Particles of unit density, tension and spacing, pulled by this model; of this viscosity. Sound is ten times as fast as what
/// surface tension moves at this radius.
pub fn of_unit_tension<const D: usize>(
    particles: Vec<Particle<D>>,
    radius: f64,
    viscosity: f64,
    model: SurfaceTension,
) -> Setup<D> {
    let mut scheme = scheme(1.0);
    scheme.surface_tension = Some(model);
    let mut liquid = fluid(viscosity, 1.0);
    liquid.sound_speed = 10.0 * (2.0 / radius).sqrt();
    Setup {
        scheme,
        fluids: vec![liquid],
        particles,
        spacing: 1.0,
        domain: Domain::default(),
    }
}

/// How far from the middle a particle comes to lie that starts 1.5 spacings outside of a disc of eight.
pub fn where_a_stray_comes(mut disc: Setup<2>) -> f64 {
    let mut stray = disc.particles[0];
    stray.position = Vector([9.5, 0.2]);
    disc.particles.push(stray);
    disc.scheme.damping = 0.1;
    let id = disc.particles.len() as u32 - 1;
    let mut simulation = Simulation::new(disc).expect("a sound setup");
    simulation.advance_to(40.0).expect("the drop is calm");
    let p = simulation.particles();
    let row = p.id.iter().position(|&other| other == id);
    p.position[row.expect("it stays")].norm()
}

/// Puts a plate of this contact angle under liquid of unit spacing, its surface at y = 0, as a body of its own.
pub fn put_on_a_plate(setup: &mut Setup<2>, width: f64, degrees: f64, slip: Slip) {
    let plate = Layers::new(1.0, 4.0, 10_000).plane(Vector::ZERO, Vector([0.0, 1.0]), width);
    put_beside_wall(setup, &plate.expect("it fits"), degrees, slip);
}

/// Puts a wall of this contact angle, as a body of its own, beside liquid of unit spacing.
pub fn put_beside_wall(setup: &mut Setup<2>, wall: &[Vector<f64, 2>], degrees: f64, slip: Slip) {
    let particle = |&position: &Vector<f64, 2>| Particle {
        position,
        velocity: Vector::ZERO,
        mass: 1.0,
        fluid: 0,
        body: 1,
    };
    (setup.particles).extend(wall.iter().map(particle));
    setup.scheme.walls = vec![Wall {
        adhesion: Adhesion::ContactAngle(degrees.to_radians()),
        slip,
        ..Wall::new(1)
    }];
}

/// The angle by a circle, in degrees, at which liquid comes to rest on a plate after `time` seconds.
pub fn angle_on_a_plate(mut setup: Setup<2>, degrees: f64, slip: Slip, time: f64) -> f64 {
    put_on_a_plate(&mut setup, 50.0, degrees, slip);
    let mut simulation = Simulation::new(setup).expect("a sound setup");
    simulation.advance_to(time).expect("a drop at rest");
    let p = simulation.particles().of_bodies(|body| body == 0);
    let wall = Plane::new(Vector::ZERO, Vector([0.0, 1.0])).expect("a plane");
    let drop = DropOnWall::measure(&p.position, &p.mass, 1.0, &Base::Plane(wall)).expect("a drop");
    drop.circle.value.to_degrees()
}
