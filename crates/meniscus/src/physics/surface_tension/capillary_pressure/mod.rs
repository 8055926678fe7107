//! Capillary pressure, for one fluid with a free surface and at walls.
//!
//! A free surface asks for the pressure sigma kappa; inside the liquid it can go on in any smooth way q, if
//! the momentum equation is
//!
//! m_i a_i = -sum_j V_i V_j (p_i - q_i + p_j - q_j) grad W_ij - V_i grad q(x_i)
//!
//! The sum knows the condition p - q = 0 of a free surface, and near it there is next to nothing to sum: particles in disorder
//! push each other by what p - q is, not by p, and a liquid under a hollow surface, where p < 0, is not torn apart. The
//! gradient is that of fields on meshes, exact for whatever particles.
//!
//! The field is found in a few passes over a mesh of the particles' spacing, and over another amid its nodes (`nodes`): smoothed colour, curvature of its
//! level sets, the mean of that over the surface, sharpened by what the smoothing took from long ripples; inside it is harmonic (`inward`). At the contact line
//! q feels how far the angle is from that of Young, as in the derivative of an energy, the area of the surface and the wet wall's.
//!
//! Pressure comes by the equation of state as p - q: a drop at rest is not compressed by its surface, and starts at rest.
//!
//! A particle that stands out of the surface is drawn back, since nothing else holds it (`standing_out`); and particles nearer than 0.8 dx push each
//! other (`closeness`). Beside walls they are also put in order (`order`), which their density follows (`shift`); and one that comes nearer to a wall than half a spacing,
//! C_w > 1/3, is pushed off (`push`): by the smooth field of the wall's colour, along which nothing holds it.
//! Forces and moments of each free body are balanced ([`super::bodies`]).
//!
//! Walls take the pressure p - q of the liquid beside them, and bear q as well (`load`), their push and the pull of contact lines
//! (`reaction`). What the gradient on the mesh differs by from sums over pairs is nowhere.
//!
//! Nothing but these holds a contact line: what the pressure p - q of a half wet wall does along it is taken off
//! ([`Edge`](crate::physics::wall::Edge)).
//!
//! - `nodes`: kappa; `normals`: which way the surface faces, beside walls too; `facing`: which way walls do; `even`: means that keep what they mean;
//!   `inward`: kappa inside

mod closeness;
mod even;
#[cfg(test)]
mod exact_drops;
#[cfg(test)]
mod exact_surfaces;
mod facing;
mod inward;
mod load;
mod nodes;
mod normals;
mod order;
mod push;
mod reaction;
mod shift;
mod standing_out;

pub use closeness::Closeness;
pub use load::Load;
pub use order::{Order, STEPS_BETWEEN};
pub use shift::{MeanShift, Shifted, Widening};

use rayon::prelude::*;

use super::bodies::balance;
use super::mesh::{Layered, Mesh, Surroundings};
use super::surface::Surface;
use crate::particles::Particles;
use crate::vector::Vector;
use nodes::{MARGIN, Nodes, PERIODIC_MARGIN, WALLED_MARGIN};
use order::Place;
use reaction::Reaction;

/// The model; it has no parameter.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CapillaryPressure;

/// Spacings beyond which two particles do not know of each other.
pub const REACH: f64 = 12.0;
/// Colour above which a node is inside, and nothing is looked for around it.
const INSIDE: f64 = 0.95;

/// Particles that one task works on at least.
const PARTICLES_PER_TASK: usize = 256;

/// Where nodes of meshes lie beyond whole multiples of the spacing, along each axis, of it. Particles in rows and a mesh of about the
/// same spacing beat: with one mesh, the stiffness of settled drops of 7 dx depended on its place by 2 %, with two, one amid the other, by 0.1 %.
const MESHES: [f64; 2] = [0.0, 0.5];
/// Of each.
const SHARE: f64 = 1.0 / MESHES.len() as f64;

/// Columns that the model needs on its way.
#[derive(Debug, Default)]
pub(super) struct Scratch<const D: usize> {
    rows: Vec<Vec<u32>>,
    liquid: Layered<D>,
    walls: Layered<D>,
    nodes: Nodes<D>,
    felt: Vec<Felt<D>>,
    reaction: Reaction<D>,
    /// Of all rows.
    places: Vec<Place<D>>,
}

/// What a particle feels of the fields on all meshes; values and their gradients, 1/m.
#[derive(Clone, Copy, Debug, Default)]
struct Felt<const D: usize> {
    /// kappa, 1/m
    curvature: f64,
    /// On liquid, per volume, N/m^3.
    force: Vector<f64, D>,
    /// The part of that by which a wall pushes on the last mesh, and the colour of the wall there.
    push: (Vector<f64, D>, f64),
    /// Colour of walls
    wall: f64,
    /// Colour of liquid and walls together, smoothed more.
    deep: (f64, Vector<f64, D>),
    /// Colour, near the surface as the first mesh has it.
    at_surface: Option<(f64, Vector<f64, D>)>,
}

impl CapillaryPressure {
    /// Finds kappa = q / sigma of liquid and walls, into the surface's curvature, and the force per volume by grad q and
    /// on particles that stand out.
    pub(crate) fn find<const D: usize>(
        &self,
        particles: &Particles<D>,
        surroundings: &Surroundings<'_, D>,
        surface: &mut Surface<D>,
    ) {
        let count = particles.len();
        for column in [&mut surface.force, &mut surface.normal, &mut surface.borne] {
            column.clear();
            column.resize(count, Vector::ZERO);
        }
        surface.curvature.clear();
        surface.curvature.resize(count, 0.0);
        surface.colour.clear();
        surface.colour.resize(count, 1.0);
        surface.active = 0;
        let mut scratch = std::mem::take(&mut surface.capillary_pressure);
        surroundings.list_rows(&mut scratch.rows);
        let rows = std::mem::take(&mut scratch.rows);
        scratch.places.clear();
        scratch.places.resize(count, Place::default());
        for rows in &rows {
            scratch.pull(particles, rows, surroundings, surface);
        }
        scratch.rows = rows;
        surface.capillary_pressure = scratch;
        surface.net_force = balance(surroundings.free, particles, |_| None, &mut surface.force);
    }
}

impl<const D: usize> Scratch<D> {
    /// What one group has.
    fn pull(
        &mut self,
        particles: &Particles<D>,
        rows: &[u32],
        surroundings: &Surroundings<'_, D>,
        surface: &mut Surface<D>,
    ) {
        self.felt.clear();
        self.felt.resize(rows.len(), Felt::default());
        for (which, &beyond) in MESHES.iter().enumerate() {
            let found = self.feel(particles, rows, surroundings, (which, beyond), surface);
            if !found {
                return;
            }
        }
        for (&row, felt) in rows.iter().zip(&self.felt) {
            let i = row as usize;
            surface.curvature[i] = felt.curvature;
            surface.force[i] = felt.force;
            self.places[i] = Place::beside_walls(felt.deep, felt.wall);
            if let Some((colour, inward)) = felt.at_surface {
                surface.active += 1;
                surface.colour[i] = colour;
                surface.normal[i] = inward;
            }
        }
    }

    /// What its particles feel of one mesh; false where there is none.
    fn feel(
        &mut self,
        particles: &Particles<D>,
        rows: &[u32],
        surroundings: &Surroundings<'_, D>,
        (which, beyond): (usize, f64),
        surface: &mut Surface<D>,
    ) -> bool {
        let domain = &surroundings.groups.domain;
        let repeats = domain.periodic.iter().any(Option::is_some);
        let of_wall = |&row: &u32| (surroundings.wall)(row as usize).is_some();
        let margin = match repeats {
            true => PERIODIC_MARGIN,
            false if rows.iter().any(of_wall) => WALLED_MARGIN,
            false => MARGIN,
        };
        let (liquid, walls) = (&mut self.liquid, &mut self.walls);
        let Some(mesh) = surroundings.mesh(particles, rows, beyond, margin, liquid, walls) else {
            return false;
        };
        self.nodes.find(&mesh, liquid, walls);
        let (sigma, spacing) = (surroundings.surface_tension, surroundings.spacing);
        let nodes = &self.nodes;
        let feel = |(felt, row): (&mut Felt<D>, &u32)| {
            let i = *row as usize;
            let x = &particles.position[i];
            felt.push = Default::default();
            if !mesh.holds(x) {
                return;
            }
            let (curvature, gradient) = mesh.feel_at(&nodes.curvature, x);
            felt.curvature += SHARE * curvature / spacing;
            if (surroundings.wall)(i).is_some() {
                return;
            }
            let mut force = gradient * (-sigma / spacing);
            if let Some(beside) = nodes.beside_walls() {
                let (wall, towards) = mesh.feel_at(beside.wall, x);
                let (deep, inward) = mesh.feel_at(beside.deep, x);
                felt.wall += SHARE * wall;
                felt.deep.0 += SHARE * deep;
                felt.deep.1 += inward * SHARE;
                let push = push::push(wall, || mesh.feel_at(beside.wide_wall, x).0) * sigma
                    / spacing.powi(2);
                let push = towards * (-push / towards.norm().max(f64::MIN_POSITIVE));
                force += push;
                felt.push = (push * SHARE, wall);
            }
            if which == 0 && nodes.colour[mesh.nearest(x)] < INSIDE {
                felt.at_surface = Some((0.0, Vector::ZERO));
            }
            if let Some((mean, slope)) = &mut felt.at_surface {
                let (colour, inward) = mesh.feel_at(&nodes.colour, x);
                *mean += SHARE * colour;
                *slope += inward * SHARE;
                let out = standing_out::pull(colour, felt.push.1);
                force += inward * (out * sigma / spacing);
            }
            felt.force += force * SHARE;
        };
        (self.felt.par_iter_mut(), rows)
            .into_par_iter()
            .with_min_len(PARTICLES_PER_TASK)
            .for_each(feel);
        self.load_walls(
            &mesh,
            particles,
            rows,
            surroundings,
            margin,
            &mut surface.borne,
        );
        true
    }

    /// Gives walls what they bear of one mesh's forces.
    fn load_walls(
        &mut self,
        mesh: &Mesh<D>,
        particles: &Particles<D>,
        rows: &[u32],
        surroundings: &Surroundings<'_, D>,
        margin: i64,
        borne: &mut [Vector<f64, D>],
    ) {
        let Some(beside) = self.nodes.beside_walls() else {
            return;
        };
        let reaction = &mut self.reaction;
        let tension = surroundings.surface_tension * surroundings.spacing.powi(D as i32 - 2);
        reaction.start(self.nodes.lines(), beside.wall, tension * SHARE);
        let reach = margin as f64 * surroundings.spacing;
        for (&row, felt) in rows.iter().zip(&self.felt) {
            let (push, wall) = felt.push;
            if push != Vector::ZERO {
                let i = row as usize;
                let push = push * particles.volume(i);
                let mut add = |x| {
                    if mesh.holds(&x) {
                        reaction.add(mesh, &x, push, wall);
                    }
                };
                (surroundings.groups.domain).for_each_image(particles.position[i], reach, &mut add);
            }
        }
        if !reaction.finish(mesh) {
            return;
        }
        for &row in rows {
            let i = row as usize;
            if (surroundings.wall)(i).is_some() && mesh.holds(&particles.position[i]) {
                borne[i] += reaction.on_wall(mesh, &particles.position[i]);
            }
        }
    }
}
