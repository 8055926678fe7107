//! Laying the particles of a case's walls.

use meniscus::physics::wall::layout::Layers;
use meniscus::scheme::{Motion, Wall};
use meniscus::shape::FillError;
use meniscus::{Particle, Vector};

use crate::bodies::{error, outside, too_large};
use crate::diagnostic::Diagnostic;
use crate::grammar::{Draft, DraftWall, Surface, WallShape};
use crate::memory;

/// A wall of a case.
#[derive(Clone, Debug, PartialEq)]
pub struct WallBody {
    /// Its name.
    pub name: String,
    /// Index of the fluid that lies against it.
    pub fluid: usize,
    /// Number of its particles.
    pub particles: usize,
}

/// Adds the particles of all walls to those of the fluid, as bodies of their own after
/// the fluid's; what each is made of, and what the library is to know of it.
pub(crate) fn lay_all(
    draft: &Draft,
    particles: &mut Vec<Particle<3>>,
    problems: &mut Vec<Diagnostic>,
) -> Vec<(WallBody, Wall)> {
    let mut walls = Vec::new();
    for (wall, index) in draft.walls.iter().zip(draft.bodies.len() as u16..) {
        let Some(fluid) = draft.fluids.get(wall.fluid) else {
            continue;
        };
        match lay_one(draft, wall, particles.len()) {
            Ok(positions) => {
                let mass = fluid.fluid.density * draft.spacing.powi(draft.dimension as i32);
                walls.push((
                    WallBody {
                        name: wall.name.clone(),
                        fluid: wall.fluid,
                        particles: positions.len(),
                    },
                    Wall {
                        body: index,
                        slip: wall.slip,
                        motion: wall.motion.clone(),
                        adhesion: wall.adhesion,
                        adhesion_factor: wall.adhesion_factor,
                        bearing: wall.bearing,
                    },
                ));
                particles.extend(positions.into_iter().map(|position| Particle {
                    position: Vector(position),
                    velocity: wall.motion.at(Vector(position), 0.0).velocity,
                    mass,
                    fluid: wall.fluid as u16,
                    body: index,
                }));
            }
            Err(problem) => problems.push(problem),
        }
    }
    walls
}

fn lay_one(draft: &Draft, wall: &DraftWall, so_far: usize) -> Result<Vec<[f64; 3]>, Diagnostic> {
    let (room, free) = memory::room();
    let support = draft.kernel.support() * draft.smoothing_length;
    let layers = Layers::new(draft.spacing, support, room.saturating_sub(so_far));
    let fail = |what: &str, label: String, help: &str| {
        let message = format!("\"{}\" {what}", wall.name);
        Err(error(&wall.shape_span, message, label, help.into()))
    };
    let laid = match &wall.surface {
        Surface::Plane(shape) => lay(shape, layers, draft),
        Surface::Space(shape) => lay(shape, layers, draft),
    };
    match laid {
        Ok(positions) => match outside(&positions, &draft.periodic) {
            None => Ok(positions),
            Some((axis, x)) => fail(
                "reaches outside the periodic box",
                format!("a particle at {axis} = {x:.4e} m"),
                "keep it within [periodic]; a tank must be open where the flow repeats itself",
            ),
        },
        Err(FillError::Unbounded) => fail(
            "has no end",
            "nothing bounds it".into(),
            "give its width; only a plane along the axes of a periodic box goes without",
        ),
        Err(FillError::TooMany { estimate, .. }) => Err(too_large(
            draft,
            (&wall.name, &wall.shape_span),
            estimate,
            free,
        )),
        Err(FillError::Empty | FillError::Spacing(_)) => fail(
            "holds no particle",
            "no particle fits".into(),
            "enlarge the shape, or use a finer spacing",
        ),
    }
}

fn lay<const D: usize>(
    shape: &WallShape<D>,
    layers: Layers,
    draft: &Draft,
) -> Result<Vec<[f64; 3]>, FillError> {
    let positions = match shape {
        WallShape::Tank { low, high, open } => layers.tank(*low, *high, open),
        WallShape::Plane {
            point,
            normal,
            width: Some(width),
        } => layers.plane(*point, *normal, *width),
        WallShape::Plane { point, normal, .. } => across_the_box(layers, draft, *point, *normal),
        WallShape::Ball {
            centre,
            radius,
            side,
        } => layers.ball(*centre, *radius, *side),
        WallShape::Polygon { corners, side } => {
            let positions = layers.polygon(corners, *side)?;
            return Ok(positions.iter().map(Vector::to_3d).collect());
        }
        WallShape::Revolved { profile, side } => {
            let positions = layers.revolved(profile, *side)?;
            return Ok(positions.iter().map(Vector::to_3d).collect());
        }
        WallShape::Mesh { mesh, side } => {
            let mesh = mesh.as_ref().ok_or(FillError::Empty)?;
            let positions = layers.mesh(mesh, *side)?;
            return Ok(positions.iter().map(Vector::to_3d).collect());
        }
    };
    Ok(positions?.iter().map(Vector::to_3d).collect())
}

/// A plane from one end of the periodic box to the other: one face of a tank.
fn across_the_box<const D: usize>(
    layers: Layers,
    draft: &Draft,
    point: Vector<f64, D>,
    normal: Vector<f64, D>,
) -> Result<Vec<Vector<f64, D>>, FillError> {
    let axis = (0..D).find(|&d| normal[d] != 0.0).ok_or(FillError::Empty)?;
    let upward = normal[axis] > 0.0;
    let (mut low, mut high) = (point, point);
    let mut open = Vec::new();
    for d in 0..D {
        if d == axis {
            open.push((d, upward));
            if upward {
                high[d] += draft.spacing;
            } else {
                low[d] -= draft.spacing;
            }
            continue;
        }
        let (Some((from, to)), true) = (draft.periodic[d], normal[d] == 0.0) else {
            return Err(FillError::Unbounded);
        };
        (low[d], high[d]) = (from, to);
        open.extend([(d, false), (d, true)]);
    }
    layers.tank(low, high, &open)
}

/// The largest speed of any wall, m/s.
pub(crate) fn largest_speed(walls: &[(WallBody, Wall)], particles: &[Particle<3>]) -> f64 {
    let speed = |wall: &Wall| match wall.motion {
        Motion::Oscillation {
            velocity,
            amplitude,
            frequency,
            ..
        } => {
            let swing = std::f64::consts::TAU * frequency * Vector(amplitude).norm();
            Vector(velocity).norm() + swing
        }
        _ => (particles.iter().filter(|p| p.body == wall.body))
            .map(|p| p.velocity.norm())
            .fold(0.0, f64::max),
    };
    walls
        .iter()
        .map(|(_, wall)| speed(wall))
        .fold(0.0, f64::max)
}
