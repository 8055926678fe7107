//! Filling the bodies of a case with particles.

use std::ops::Range;

use meniscus::scheme::Wall;
use meniscus::shape::{Arrangement, FillError, Shape};
use meniscus::{Particle, Vector};

use crate::case::Body;
use crate::diagnostic::{Diagnostic, Severity};
use crate::grammar::{Draft, DraftBody, Geometry};
use crate::memory::{self, BYTES_PER_PARTICLE};
use crate::overlap::closest_of_two_bodies;
use crate::walls::{WallBody, lay_all};

/// What a case is filled with.
pub(crate) struct Filled {
    /// Particles of the bodies, then of the walls.
    pub particles: Vec<Particle<3>>,
    pub bodies: Vec<Body>,
    pub walls: Vec<(WallBody, Wall)>,
}

/// All particles, and what each body and wall is made of; none if one cannot be filled.
pub(crate) fn fill_all(draft: &Draft, problems: &mut Vec<Diagnostic>) -> Option<Filled> {
    let before = problems.len();
    let mut particles: Vec<Particle<3>> = Vec::new();
    let mut bodies = Vec::new();
    for (index, body) in draft.bodies.iter().enumerate() {
        let density = draft.fluids.get(body.fluid)?.fluid.density;
        match fill_one(draft, body, particles.len()) {
            Ok((positions, particle_volume)) => {
                let mass = density * particle_volume;
                let count = positions.len();
                bodies.push(Body {
                    name: body.name.clone(),
                    fluid: body.fluid,
                    particles: count,
                    volume: particle_volume * count as f64,
                    mass: mass * count as f64,
                });
                particles.extend(moving(body, &positions, mass, index as u16));
            }
            Err(problem) => problems.push(problem),
        }
    }
    let walls = lay_all(draft, &mut particles, problems);
    if problems.len() == before && draft.bodies.len() + walls.len() > 1 {
        problems.extend(overlap(draft, &particles));
    }
    (problems.len() == before).then_some(Filled {
        particles,
        bodies,
        walls,
    })
}

pub(crate) fn error(
    span: &Range<usize>,
    message: String,
    label: String,
    help: String,
) -> Diagnostic {
    Diagnostic {
        severity: Severity::Error,
        message,
        label,
        help: Some(help),
        span: Some(span.clone()),
    }
}

/// Positions of a body's particles, and the volume of one.
fn fill_one(
    draft: &Draft,
    body: &DraftBody,
    so_far: usize,
) -> Result<(Vec<[f64; 3]>, f64), Diagnostic> {
    let fail = |what: &str, label: String, help: String| {
        Err(error(
            &body.shape_span,
            format!("\"{}\" {what}", body.name),
            label,
            help,
        ))
    };
    let (room, free) = memory::room();
    let room = room.saturating_sub(so_far);
    let filled = match &body.geometry {
        Geometry::Plane(shape, arrangement) => fill(shape, arrangement, room),
        Geometry::Space(shape, arrangement) => fill(shape, arrangement, room),
    };
    match filled {
        Ok((positions, volume)) => match outside(&positions, &draft.periodic) {
            None => Ok((positions, volume)),
            Some((axis, x)) => fail(
                "reaches outside the periodic box",
                format!("a particle at {axis} = {x:.4e} m"),
                format!("keep it within [periodic] {axis}, or widen the box"),
            ),
        },
        Err(FillError::TooMany { estimate, .. }) => Err(too_large(
            draft,
            (&body.name, &body.shape_span),
            estimate,
            free,
        )),
        Err(FillError::Empty) => fail(
            "holds no particle",
            "no point of the arrangement is inside".into(),
            format!(
                "enlarge the shape, or use a spacing well below {} m",
                draft.spacing
            ),
        ),
        Err(FillError::Unbounded) => fail(
            "has no end",
            "endless".into(),
            "intersect it with a shape that has an end".into(),
        ),
        Err(FillError::Spacing(spacing)) => fail(
            "cannot be filled",
            format!("the spacing is {spacing} m"),
            "give a positive spacing".into(),
        ),
    }
}

/// What is said of a body or wall of more particles than fit into `free` bytes.
pub(crate) fn too_large(
    draft: &Draft,
    (name, span): (&str, &Range<usize>),
    estimate: f64,
    free: f64,
) -> Diagnostic {
    let bytes = estimate * BYTES_PER_PARTICLE;
    let coarser = draft.spacing * (1.1 * bytes / free).powf(1.0 / draft.dimension as f64);
    error(
        span,
        format!("\"{name}\" is too large for this machine's memory"),
        format!(
            "up to {estimate:.1e} particles, {}; {} is free",
            size(bytes),
            size(free)
        ),
        format!("use a spacing of at least {coarser:.2e} m"),
    )
}

fn fill<const D: usize>(
    shape: &Shape<D>,
    arrangement: &Arrangement<D>,
    room: usize,
) -> Result<(Vec<[f64; 3]>, f64), FillError> {
    let positions = arrangement.fill(shape, room)?;
    Ok((
        positions.iter().map(Vector::to_3d).collect(),
        arrangement.particle_volume(),
    ))
}

/// A coordinate that is not in the periodic box.
pub(crate) fn outside(
    positions: &[[f64; 3]],
    periodic: &[Option<(f64, f64)>; 3],
) -> Option<(char, f64)> {
    ['x', 'y', 'z']
        .into_iter()
        .zip(periodic)
        .enumerate()
        .find_map(|(d, (axis, interval))| {
            let (low, high) = (*interval)?;
            let out = positions.iter().find(|x| !(low..high).contains(&x[d]))?;
            Some((axis, out[d]))
        })
}

/// A body's particles, each with its share of the body's motion.
fn moving(
    body: &DraftBody,
    positions: &[[f64; 3]],
    mass: f64,
    index: u16,
) -> impl Iterator<Item = Particle<3>> {
    let mut centre = Vector::<f64, 3>::ZERO;
    for position in positions {
        centre += Vector(*position) * (1.0 / positions.len() as f64);
    }
    let (velocity, omega, fluid) = (
        Vector(body.velocity),
        body.angular_velocity,
        body.fluid as u16,
    );
    positions.iter().map(move |&position| {
        let position = Vector(position);
        let r = position - centre;
        let turning = Vector([
            omega[1] * r[2] - omega[2] * r[1],
            omega[2] * r[0] - omega[0] * r[2],
            omega[0] * r[1] - omega[1] * r[0],
        ]);
        Particle {
            position,
            velocity: velocity + turning,
            mass,
            fluid,
            body: index,
        }
    })
}

fn overlap(draft: &Draft, particles: &[Particle<3>]) -> Option<Diagnostic> {
    let (i, j) = closest_of_two_bodies(particles, &draft.periodic, 0.5 * draft.spacing)?;
    let of = |k: usize| {
        let index = usize::from(particles[k].body);
        match draft.bodies.get(index) {
            Some(body) => (&body.name, &body.shape_span),
            None => {
                let wall = &draft.walls[index - draft.bodies.len()];
                (&wall.name, &wall.shape_span)
            }
        }
    };
    let place: Vec<String> = (0..draft.dimension)
        .map(|d| format!("{:.4e}", particles[j].position[d]))
        .collect();
    Some(error(
        of(j).1,
        format!("\"{}\" and \"{}\" overlap", of(i).0, of(j).0),
        format!(
            "two particles less than half a spacing apart near {} m",
            place.join(", ")
        ),
        "move one of them, or cut one out of the other with a difference".into(),
    ))
}

/// Bytes as people say them.
fn size(bytes: f64) -> String {
    let units = ["B", "kB", "MB", "GB", "TB", "PB", "EB"];
    let power = ((bytes.max(1.0).log10() / 3.0) as usize).min(units.len() - 1);
    format!(
        "{:.1} {}",
        bytes / 1000_f64.powi(power as i32),
        units[power]
    )
}
