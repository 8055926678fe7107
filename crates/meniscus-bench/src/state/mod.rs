//! What is measured on: liquid of spacing 1, density 1 and sound speed
//! [`SOUND_SPEED`], whose fastest motion is about a tenth of that.
//!
//! - `lattice`: a cube of a jittered lattice, stirred
//! - `splash`: two drops that have burst on one another, marched here and now

mod lattice;
mod splash;

use crate::variant::Variant;
use meniscus::particles::Particle;
use meniscus::physics::surface_tension::jancik_hyhlik::JancikHyhlik;
use meniscus::physics::surface_tension::pairwise::Pairwise;
use meniscus::physics::surface_tension::pairwise::akinci::Akinci;
use meniscus::physics::wall::layout::Layers;
use meniscus::rates::{Dimension, Space};
use meniscus::scheme::{AdaptiveSmoothing, Adhesion, DensityForm, PressureForm, Wall};
use meniscus::{Domain, Fluid, Scheme, Setup, Simulation, SurfaceTension, Vector};
use serde::Serialize;

use crate::BenchError;

/// Sound speed of the liquid; all is in units of spacing and density.
pub const SOUND_SPEED: f64 = 10.0;
/// Drops of twenty spacings that meet at a tenth of the sound speed have a
/// Weber number of 200: they splash.
const SURFACE_TENSION: f64 = 0.1;

/// How particles lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Arrangement {
    /// A square or cubic lattice, jittered.
    Lattice,
    /// As a splash left them.
    Splash,
}

impl Arrangement {
    /// As printed.
    pub fn name(self) -> &'static str {
        match self {
            Arrangement::Lattice => "lattice",
            Arrangement::Splash => "splash",
        }
    }
}

/// What is solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Flow {
    /// Continuity, pressure and artificial viscosity.
    Plain,
    /// That, and the continuum surface force of a free surface (Jancik and Hyhlik).
    Csf,
    /// Plain, and cohesion and adhesion by forces of pairs (Akinci), on a floor that wets.
    Wetting,
    /// Density by summation, pressure and artificial viscosity, in a box full of liquid.
    Summation,
    /// The same with smoothing lengths that follow density, about the same.
    Adaptive,
}

impl Flow {
    /// All that is measured on a lattice.
    pub const ALL: [Flow; 5] = [
        Flow::Plain,
        Flow::Csf,
        Flow::Wetting,
        Flow::Summation,
        Flow::Adaptive,
    ];
    /// Those that need no box full of liquid.
    pub const FREE: [Flow; 3] = [Flow::Plain, Flow::Csf, Flow::Wetting];
    /// Those that are measured from small to large.
    pub const SCALED: [Flow; 2] = [Flow::Plain, Flow::Csf];

    /// As printed.
    pub fn name(self) -> &'static str {
        match self {
            Flow::Plain => "plain",
            Flow::Csf => "surface force",
            Flow::Wetting => "pair forces on a floor",
            Flow::Summation => "summation",
            Flow::Adaptive => "adaptive summation",
        }
    }
}

/// Smoothing length over the spacing for 75 neighbours in 3D and 26 in 2D,
/// with the support of Wendland's kernel, 2 h.
pub fn smoothing_length(dimension: usize) -> f64 {
    if dimension == 2 { 1.437 } else { 1.31 }
}

/// The liquid.
pub fn fluid(flow: Flow) -> Fluid {
    Fluid {
        sound_speed: SOUND_SPEED,
        surface_tension: match flow {
            Flow::Plain | Flow::Summation | Flow::Adaptive => 0.0,
            Flow::Csf | Flow::Wetting => SURFACE_TENSION,
        },
        ..Fluid::new("liquid", 1.0)
    }
}

fn scheme<const D: usize>(flow: Flow) -> Scheme {
    let plain = Scheme::new(smoothing_length(D));
    match flow {
        Flow::Plain => plain,
        Flow::Csf => Scheme {
            surface_tension: Some(SurfaceTension::JancikHyhlik(JancikHyhlik::default())),
            ..plain
        },
        Flow::Wetting => Scheme {
            surface_tension: Some(SurfaceTension::Pairwise(
                Pairwise::Akinci(Akinci::default()),
            )),
            pressure: PressureForm::OverDensityProduct,
            walls: vec![Wall {
                adhesion: Adhesion::ContactAngle(1.0),
                ..Wall::new(FLOOR)
            }],
            ..plain
        },
        Flow::Summation => Scheme {
            density: DensityForm::Summation,
            ..plain
        },
        Flow::Adaptive => Scheme {
            density: DensityForm::Summation,
            adaptive_smoothing: Some(AdaptiveSmoothing {
                k: 1.0,
                ..AdaptiveSmoothing::default()
            }),
            ..plain
        },
    }
}

/// The body of the floor.
const FLOOR: u16 = 1;

/// A floor half a spacing below the lowest particle, as wide as they reach.
fn floor<const D: usize>(
    particles: &[Particle<D>],
    scheme: &Scheme,
) -> Result<Vec<Particle<D>>, BenchError> {
    let (mut low, mut high) = ([f64::INFINITY; D], [f64::NEG_INFINITY; D]);
    for particle in particles {
        for d in 0..D {
            low[d] = low[d].min(particle.position[d]);
            high[d] = high[d].max(particle.position[d]);
        }
    }
    let upward = D - 1;
    let mut middle = Vector(std::array::from_fn(|d| 0.5 * (low[d] + high[d])));
    middle[upward] = low[upward] - 0.5;
    let mut up = Vector::ZERO;
    up[upward] = 1.0;
    let width = (0..upward)
        .map(|d| high[d] - low[d] + 1.0)
        .fold(0.0, f64::max);
    let support = scheme.kernel.support() * scheme.smoothing_length;
    let positions = Layers::new(1.0, support, LARGEST_FLOOR).plane(middle, up, width)?;
    let of_floor = |position: Vector<f64, D>| Particle {
        body: FLOOR,
        ..particle(position.0, [0.0; D])
    };
    Ok(positions.into_iter().map(of_floor).collect())
}

/// Particles of a floor, at most.
const LARGEST_FLOOR: usize = 10_000_000;

/// Places and velocities to start from.
#[derive(Clone, Debug)]
pub struct State<const D: usize> {
    /// Which.
    pub arrangement: Arrangement,
    /// Particles, mass 1.
    pub particles: Vec<Particle<D>>,
}

impl<const D: usize> State<D>
where
    Space: Dimension<D>,
{
    /// `count` particles on a lattice.
    pub fn lattice(count: usize) -> Self {
        Self {
            arrangement: Arrangement::Lattice,
            particles: lattice::cube(count),
        }
    }

    /// `count` particles of a splash.
    pub fn splash(tile: &Tile<D>, count: usize) -> Self {
        Self {
            arrangement: Arrangement::Splash,
            particles: tile.0.block(count),
        }
    }

    /// What is measured on it.
    pub fn flows(&self) -> &'static [Flow] {
        match self.arrangement {
            Arrangement::Lattice => &Flow::ALL,
            Arrangement::Splash => &Flow::FREE,
        }
    }

    /// A flow that starts from it; in a box full of liquid from as large a lattice.
    ///
    /// # Errors
    /// None that this crate can cause.
    pub fn simulation(&self, flow: Flow, variant: Variant) -> Result<Simulation<D>, BenchError> {
        let scheme = Scheme {
            precision: variant.precision,
            ..scheme::<D>(flow)
        };
        let mut particles = self.particles.clone();
        let mut domain = Domain::default();
        match flow {
            Flow::Plain | Flow::Csf => {}
            Flow::Wetting => particles.extend(floor(&self.particles, &scheme)?),
            Flow::Summation | Flow::Adaptive => {
                let side;
                (particles, side) = lattice::full(particles.len());
                domain.periodic = [Some((0.0, side)); D];
            }
        }
        let mut simulation = Simulation::new(Setup {
            scheme,
            fluids: vec![fluid(flow)],
            particles,
            spacing: 1.0,
            domain,
        })?;
        simulation.set_instructions(variant.instructions);
        Ok(simulation)
    }
}

/// A periodic piece of a splash, to be laid side by side with itself.
#[derive(Clone, Debug)]
pub struct Tile<const D: usize>(splash::Piece<D>);

impl<const D: usize> Tile<D>
where
    Space: Dimension<D>,
{
    /// Marches one of about `count` particles.
    ///
    /// # Errors
    /// If the flow blows up.
    pub fn march(count: usize) -> Result<Self, BenchError> {
        splash::march(count).map(Tile)
    }

    /// How it came about.
    pub fn story(&self) -> &str {
        &self.0.story
    }
}

fn particle<const D: usize>(position: [f64; D], velocity: [f64; D]) -> Particle<D> {
    Particle {
        position: Vector(position),
        velocity: Vector(velocity),
        mass: 1.0,
        fluid: 0,
        body: 0,
    }
}

/// The `count` particles that are nearest to `centre` by their largest coordinate: a cube.
fn cut<const D: usize>(particles: &mut Vec<Particle<D>>, centre: [f64; D], count: usize) {
    let distance = |p: &Particle<D>| {
        let from_centre = |d: usize| (p.position[d] - centre[d]).abs();
        (0..D).map(from_centre).fold(0.0, f64::max)
    };
    if count < particles.len() {
        particles.select_nth_unstable_by(count, |a, b| distance(a).total_cmp(&distance(b)));
        particles.truncate(count);
    }
}
