//! Surface tension as the derivative of an energy, for one fluid with a free surface and at walls:
//! the total variation of a smoothed colour (Rudin, Osher and Fatemi 1992, for pictures), on a mesh. With the
//! volume V0 = m / rho_0 of a particle, B the cubic B-spline of the mesh, S passes of (1/4, 1/2, 1/4), a the
//! distance of nodes, D differences of neighbouring nodes:
//!
//! - c = S sum_j V0 B(x - x_j) / a^D                          colour, 1 inside
//! - E = sigma sum_nodes a^(D-1) [(1 - mu) k_T f(c) (sqrt(|Dc|^2 + eps^2) - eps) + mu k_G c (1 - c)^2]
//! - f = 30 c^2 (1 - c)^2                                      of integral one
//! - phi = S (dE/dc - D . dE/dDc)                              on the nodes
//! - m_i a_i = -V0 sum_nodes phi grad B                        so that a = -grad phi / rho_0
//!
//! The first term costs sigma for each area of a flat surface, however the colour falls off through it:
//! particles gain nothing by their order. The second, weaker, does not: it keeps the outermost from
//! spreading. k_T and k_G make either right on a flat surface (`calibration`). What a curved surface pulls is that
//! of the smoothed one, so that mode n of a drop swings slower by about (n^2 - 3/2) v / (2 R^2), v the
//! variance of the smoothing, 2.8 dx^2.
//!
//! At walls, which are spread likewise into C_w, c is C / (1 - C_w), and a wall gains sigma cos(theta) for each area
//! that is wet: Young's law is a property of the energy, and no contact line is looked for.
//!
//! The force is a gradient, and bodies of liquid that do not touch a wall feel none on the whole,
//! once a remainder of the mesh is taken off ([`super::bodies`]). The pull of a contact line on its wall is not
//! part of the wall's load.
//!
//! - `energy`: of a node
//! - `calibration`: by a flat surface

mod calibration;
mod energy;

use rayon::prelude::*;

use super::bodies::balance;
use super::mesh::{Layered, Mesh, Surroundings};
use super::surface::Surface;
use crate::particles::Particles;
use crate::vector::Vector;
use energy::{Calibrated, Node, Slopes};

/// The model; it has no parameter.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TotalVariation;

/// Passes of smoothing.
const PASSES: usize = 5;
/// Nodes that a mesh reaches beyond its particles: colour reaches 2 + 5, phi is smoothed from there.
const MARGIN: i64 = 2 * PASSES as i64 + 5;
/// Spacings beyond which two particles know nothing of each other.
pub const REACH: f64 = 2.0 * (PASSES as f64 + 2.0) + 2.0;

/// Columns that the model needs on its way.
#[derive(Debug, Default)]
pub(super) struct Scratch<const D: usize> {
    calibrated: Option<Calibrated>,
    rows: Vec<Vec<u32>>,
    liquid: Layered<D>,
    walls: Layered<D>,
    colour: Vec<f64>,
    wall: Vec<f64>,
    wetting: Vec<f64>,
    potential: Vec<f64>,
    slopes: Vec<Vector<f64, D>>,
    spare: Vec<f64>,
    points: Vec<Vector<f64, D>>,
    felt: Vec<(f64, Vector<f64, D>)>,
}

impl TotalVariation {
    /// Adds the acceleration, m/s^2.
    pub(crate) fn accelerate<const D: usize>(
        &self,
        particles: &Particles<D>,
        surroundings: &Surroundings<'_, D>,
        surface: &mut Surface<D>,
        acceleration: &mut [Vector<f64, D>],
    ) {
        let mut scratch = std::mem::take(&mut surface.total_variation);
        surface.force.clear();
        surface.force.resize(particles.len(), Vector::ZERO);
        surroundings.list_rows(&mut scratch.rows);
        let rows = std::mem::take(&mut scratch.rows);
        for rows in &rows {
            scratch.pull(particles, rows, surroundings, &mut surface.force);
        }
        scratch.rows = rows;
        surface.total_variation = scratch;
        surface.net_force = balance(surroundings.free, particles, |_| None, &mut surface.force);
        surface.add_to(&particles.density, acceleration);
    }
}

impl<const D: usize> Scratch<D> {
    /// The force per volume, N/m^3, on the liquid of one group.
    fn pull(
        &mut self,
        particles: &Particles<D>,
        rows: &[u32],
        surroundings: &Surroundings<'_, D>,
        force: &mut [Vector<f64, D>],
    ) {
        let &Surroundings {
            surface_tension,
            density,
            spacing,
            wall,
            ..
        } = surroundings;
        let (liquid, walls) = (&mut self.liquid, &mut self.walls);
        let Some(mesh) = surroundings.mesh(particles, rows, 0.0, MARGIN, liquid, walls) else {
            return;
        };
        self.find_potential(&mesh);
        let liquid = || rows.iter().filter(|row| wall(**row as usize).is_none());
        self.points.clear();
        (self.points).extend(liquid().map(|&row| particles.position[row as usize]));
        mesh.feel(&self.potential, &self.points, &mut self.felt);
        let scale = surface_tension / (density * spacing);
        for (&row, (_, gradient)) in liquid().zip(&self.felt) {
            let i = row as usize;
            force[i] = *gradient * (-scale * particles.density[i]);
        }
    }

    /// phi, over sigma a^(D-1), from what liquid and walls spread.
    fn find_potential(&mut self, mesh: &Mesh<D>) {
        let Self {
            liquid,
            walls,
            colour,
            wall,
            wetting,
            potential,
            slopes,
            spare,
            ..
        } = self;
        let calibrated =
            *(self.calibrated).get_or_insert_with(|| calibration::flat_surface(PASSES));
        let walled = !walls.is_empty();
        let of_walls = if walled { mesh.len() } else { 0 };
        for (column, length) in [
            (&mut *colour, mesh.len()),
            (&mut *potential, mesh.len()),
            (&mut *spare, mesh.len()),
            (&mut *wall, of_walls),
            (&mut *wetting, of_walls),
        ] {
            column.clear();
            column.resize(length, 0.0);
        }
        slopes.clear();
        slopes.resize(mesh.len(), Vector::ZERO);
        mesh.spread(liquid, [colour, &mut []]);
        mesh.smooth(colour, spare, PASSES);
        if walled {
            mesh.spread(walls, [wall, wetting]);
            mesh.smooth(wall, spare, PASSES);
            mesh.smooth(wetting, spare, PASSES);
        }
        let (nodes, inner) = (mesh.nodes_per_task(), mesh.inner());
        let parts = (potential.par_chunks_mut(nodes)).zip(slopes.par_chunks_mut(nodes));
        parts.enumerate().for_each(|(task, (potential, slopes))| {
            for k in 0..potential.len() {
                let i = task * nodes + k;
                if !inner.contains(&i) || colour[i] <= 0.0 {
                    continue;
                }
                let difference = |of: &[f64]| match of {
                    [] => Vector::ZERO,
                    of => mesh.difference(of, i),
                };
                let node = Node {
                    liquid: colour[i],
                    liquid_gradient: difference(colour),
                    wall: wall.get(i).copied().unwrap_or(0.0),
                    wall_gradient: difference(wall),
                    wetting_gradient: difference(wetting),
                };
                if let Some(found) = node.slopes(calibrated) {
                    let Slopes {
                        by_colour,
                        by_gradient,
                    } = found;
                    potential[k] = by_colour;
                    slopes[k] = by_gradient;
                }
            }
        });
        (potential.par_chunks_mut(nodes).enumerate()).for_each(|(task, potential)| {
            for (k, phi) in potential.iter_mut().enumerate() {
                let i = task * nodes + k;
                if inner.contains(&i) {
                    *phi -= mesh.divergence(slopes, i);
                }
            }
        });
        mesh.smooth(potential, spare, PASSES);
    }
}
