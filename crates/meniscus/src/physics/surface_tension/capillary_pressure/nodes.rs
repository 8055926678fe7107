//! Curvature of the surface, on the nodes of a mesh of spacing dx. With the volume V0 of a particle in cells, B
//! the cubic B-spline of the mesh, P two passes of (1/4, 1/2, 1/4), S five:
//!
//! - C = P sum_j V0 B(x - x_j), and of the walls C_w; c = C / (1 - C_w)       colour, 1 inside
//! - n = grad c / |grad c|, with the gradient of the cubic spline through c; beside walls as in [`normals`](super::normals)
//! - g = 30/0.6^5 ((c - 0.2)(0.8 - c))^2 |grad c| between 0.2 and 0.8, zero else: of integral one through the surface
//! - k = div(-n) / (1 + div(-n) z(c) / (D - 1))
//! - kappa_0 = T k, T u = S [w u] / S [w], with weights w as in [`even`](super::even), g without walls
//! - kappa_1 = kappa_0 + r (kappa_0 T r - T (r kappa_0)), r^2 = f, falling to 0 beside walls
//! - kappa = kappa_1 / (1 + b kappa_1^2 dx^2 / (D - 1)^2) + the contact line's part
//!
//! The divergence is that of unit vectors, not of second derivatives of c: these are mostly such across the surface, of which one
//! hundredth in the wrong direction is all the curvature there is.
//!
//! A level set at a depth z under the surface has a radius smaller by z. So k is what the level set of c = 1/2 would have, by the
//! depth z(c) that a colour has under a flat surface: it hardly changes across the surface (by 0.4 % over three spacings on a disc of 7 dx,
//! where div(-n) changes by a quarter), so the closest point of a node hardly matters.
//!
//! kappa_1 undoes what spreading, smoothing and differences take: a ripple of wave number k loses k^2 v / 2 by a variance v of all
//! steps, 5.2 dx^2 (spline 1/3, passes 1 and 5/2, gradient 1/3, divergence 1/3, and interpolations 2/3), and
//! one smoothing more, of 5/2 dx^2, tells how much that is: f = 5.2 / 2.5 = 2.07, by count, right to first order in k^2 for any surface. Where a wall
//! cuts a mean off, there is no ripple to undo, and what the contact line pulls, next to what the surface turns, is not sharpened either: r falls to 0 up to a colour of the wall, smoothed
//! more, of 0.1, and kappa_1 has the sum of kappa_0 over the surface whatever r is. Smoothed, the level set of a ball lies
//! deeper than its surface, and is more curved: b = 0.88 in two dimensions and 1.47 in three, by exact discs and balls (by theory of the spread
//! alone 2/3 and 4/3).
//!
//! A mean over more of the surface leaves less of what the disorder of particles makes of k, which drives currents: with S of three passes drops of La = 12000
//! turn twice as fast; a wider colour would do the same, but not see
//! voids of three spacings, which then stay open at walls.
//!
//! The contact line's part is T's of grad s . (n - cos(theta) n_w) over the surface, where s falls from 1 to 0 through the surface of a wall, n_w is the
//! unit vector into it, and n . n_w is corrected on round walls as in [`facing`](super::facing). It is the derivative of the area of the surface and of the
//! wet wall at their edge, and vanishes where n meets the wall at Young's angle, n . n_w = cos(theta). s is wide, or its sum would depend on where nodes
//! lie (by 0.05 sigma on inclined walls with s from C_w = 0.3 to 0.7; 0.01 with 0.1 to 0.9). It is not sharpened, or the pull of a contact line that starts
//! far from its angle tears the liquid.
//!
//! Through the surface and beyond it goes on as in [`inward`](super::inward).

use std::f64::consts::PI;

use rayon::prelude::*;

use super::super::mesh::{Layered, Mesh};
use super::even::Even;
use super::facing::{self, Facing, unit};
use super::inward::{Found, Inward};
use super::normals;
use super::order;
use crate::vector::Vector;

/// Passes of smoothing of the colour.
pub(super) const PASSES: usize = 2;
/// Those of the curvature.
const MEAN: usize = 5;
/// Nodes that a mesh reaches beyond its particles: the surface lies within two of them, and is smoothed over five more. The colour of a wall goes on beyond a contact line, and
/// is to be right up to four nodes from there. Beyond a periodic face there are more of them,
/// whose curvature is smoothed into that of the last.
pub(super) const MARGIN: i64 = 7;
pub(super) const WALLED_MARGIN: i64 = 9;
pub(super) const PERIODIC_MARGIN: i64 = 18;
/// Colours between which the surface lies.
const SURFACE: [f64; 2] = [0.2, 0.8];
/// Colour down to which it has a direction.
pub(super) const OUTERMOST: f64 = 0.02;
/// What colour at a node and its spline may differ by.
const LEEWAY: f64 = 0.05;
/// Slope of the colour below which it has no direction, 1/dx.
pub(super) const LEAST_SLOPE: f64 = 0.02;
/// Colours of a wall between which s ends, about that of its surface.
const WALL: [f64; 2] = [0.1, 0.9];
/// Colour of a wall from which on nothing is divided by what it leaves.
const SOLID: f64 = 0.995;
/// Variance of the mean of curvature, dx^2, and of all other steps: spline and passes of the colour, gradient, divergence, and
/// two interpolations.
pub(super) const SMOOTHED: f64 = 0.5 * MEAN as f64;
pub(super) const OTHERWISE: f64 = VARIANCE + 4.0 / 3.0;
/// f
pub(super) const SHARPENING: f64 = (SMOOTHED + OTHERWISE) / SMOOTHED;
/// Colour of a wall, smoothed more, from which on nothing is sharpened.
const CUT_OFF: f64 = 0.1;

/// Variance of the colour's profile along each axis, dx^2: spline 1/3, passes 1/2 each.
pub(super) const VARIANCE: f64 = 1.0 / 3.0 + 0.5 * PASSES as f64;
/// b
const fn deeper(dimension: usize) -> f64 {
    if dimension == 3 { 1.47 } else { 0.88 }
}
/// Least of what curvatures are divided by.
const SHALLOWEST: f64 = 0.3;
/// Weights of the surface between which it begins to have contact lines. Those of drops have more than 0.02 around them; deep in a wall that is
/// wet all over, where colour is a ratio of small numbers, it may look as if there were a surface, of less than 0.001.
const SEEN: [f64; 2] = [0.002, 0.01];
/// Weight of the surface below which the contact line's part is not divided by it, and the most of that part, 1/dx.
const LEAST_SURFACE: f64 = 0.05;
const MOST_PULLED: f64 = 0.5;
/// Up to which squared curvature, 1/dx^2, that is taken to be so.
const MOST_CURVED: f64 = 0.04;

/// Fields on the nodes, lengths in distances of nodes.
#[derive(Debug, Default)]
pub(super) struct Nodes<const D: usize> {
    /// c
    pub colour: Vec<f64>,
    /// kappa
    pub curvature: Vec<f64>,
    /// Of liquid and walls together, smoothed more, where there are walls.
    deep: Vec<f64>,
    wall: Vec<f64>,
    /// The same, smoothed as much as `deep`.
    wide_wall: Vec<f64>,
    wetting: Vec<f64>,
    /// s
    open: Vec<f64>,
    facing: Facing<D>,
    normals: normals::Normals<D>,
    /// g s, and what it comes to where it is evened out beside walls
    weight: Vec<f64>,
    pull: Vec<f64>,
    /// Where there are walls.
    line: Vec<f64>,
    lines: Vec<Vector<f64, D>>,
    /// S [g s], and of w
    surface: Vec<f64>,
    smooth_weight: Vec<f64>,
    /// S [w r]
    sharpness: Vec<f64>,
    even: Even,
    spare: Vec<f64>,
    inward: Inward<D>,
}

/// Colours beside walls.
pub(super) struct BesideWalls<'a> {
    /// Of walls.
    pub wall: &'a [f64],
    /// Of walls, smoothed more.
    pub wide_wall: &'a [f64],
    /// Of liquid and walls together, smoothed as much.
    pub deep: &'a [f64],
}

/// How far inside of c = 1/2 a flat surface has this colour, dx: that of a step smoothed by a normal distribution.
pub(super) fn depth(colour: f64) -> f64 {
    let u = 2.0 * colour - 1.0;
    let v = u * u;
    // The inverse of the error function.
    let series = 1.0 + v * (0.261_80 + v * (0.143_93 + v * 0.097_66));
    (0.5 * PI * VARIANCE).sqrt() * u * series
}

fn ratio(sum: f64, weight: f64) -> f64 {
    if weight > 1e-9 { sum / weight } else { 0.0 }
}

impl<const D: usize> Nodes<D> {
    /// Finds colour and curvature.
    pub fn find(&mut self, mesh: &Mesh<D>, liquid: &mut Layered<D>, walls: &mut Layered<D>) {
        let walled = !walls.is_empty();
        let of_walls = if walled { mesh.len() } else { 0 };
        for (column, length) in [
            (&mut self.colour, mesh.len()),
            (&mut self.weight, mesh.len()),
            (&mut self.pull, mesh.len()),
            (&mut self.line, of_walls),
            (&mut self.deep, of_walls),
            (&mut self.wall, of_walls),
            (&mut self.wetting, of_walls),
        ] {
            column.clear();
            column.resize(length, 0.0);
        }
        let spare = &mut self.spare;
        mesh.spread(liquid, [&mut self.colour, &mut []]);
        mesh.smooth(&mut self.colour, spare, PASSES);
        if walled {
            mesh.spread(walls, [&mut self.wall, &mut self.wetting]);
            mesh.smooth(&mut self.wall, spare, PASSES);
            mesh.smooth(&mut self.wetting, spare, PASSES);
            let both = self.colour.iter().zip(&self.wall);
            for (deep, (colour, wall)) in self.deep.iter_mut().zip(both) {
                *deep = colour + wall;
            }
            mesh.smooth(&mut self.deep, spare, order::PASSES);
            self.wide_wall.clone_from(&self.wall);
            mesh.smooth(&mut self.wide_wall, spare, order::PASSES);
            for (colour, wall) in self.colour.iter_mut().zip(&self.wall) {
                *colour /= 1.0 - wall.min(SOLID);
            }
        }
        self.facing.find(mesh, &self.wall);
        let bounds = [OUTERMOST, SURFACE[1] + LEEWAY];
        let (colour, wall) = (&self.colour, &self.wall);
        self.normals.find(mesh, colour, wall, &self.facing, bounds);
        self.weigh(mesh);
        self.average(mesh);
    }

    /// What there is beside walls; none without.
    pub fn beside_walls(&self) -> Option<BesideWalls<'_>> {
        (!self.wall.is_empty()).then_some(BesideWalls {
            wall: &self.wall,
            wide_wall: &self.wide_wall,
            deep: &self.deep,
        })
    }

    /// The force on contact lines, of sigma: as in [`reaction`](super::reaction).
    pub fn lines(&self) -> &[Vector<f64, D>] {
        &self.lines
    }

    /// The surface, its curvature times that, and the contact line.
    fn weigh(&mut self, mesh: &Mesh<D>) {
        self.open.clear();
        self.open
            .extend(self.wall.iter().map(|&wall| facing::fading(wall, WALL)));
        let Self {
            colour,
            facing,
            normals,
            wall,
            wetting,
            open,
            weight,
            pull,
            line,
            lines,
            ..
        } = self;
        let (colour, facing, normals) = (&*colour, &*facing, &*normals);
        let (wall, wetting) = (&*wall, &*wetting);
        let open = &*open;
        let (nodes, inner) = (mesh.nodes_per_task(), mesh.inner());
        let sharpest = D as f64 - 1.0;
        let surface = |i: usize| {
            let c = colour[i];
            let slope = normals.slope(i);
            if !inner.contains(&i) || c <= SURFACE[0] || c >= SURFACE[1] || slope < LEAST_SLOPE {
                return None;
            }
            let bell = ((c - SURFACE[0]) * (SURFACE[1] - c)).powi(2);
            let steep = 30.0 / (SURFACE[1] - SURFACE[0]).powi(5) * bell * slope;
            Some(steep * normals.rise(facing, i))
        };
        let curvature = |i: usize| {
            let curvature = -normals.divergence(mesh, facing, i);
            let curvature = curvature.clamp(-sharpest, sharpest);
            curvature / (1.0 + curvature * depth(colour[i]) / sharpest).max(SHALLOWEST)
        };
        let parts = weight.par_chunks_mut(nodes).zip(pull.par_chunks_mut(nodes));
        parts.enumerate().for_each(|(task, (weight, pull))| {
            for (k, (weight, pull)) in weight.iter_mut().zip(pull).enumerate() {
                let i = task * nodes + k;
                if let Some(surface) = surface(i) {
                    *weight = surface * open.get(i).unwrap_or(&1.0);
                    *pull = *weight * curvature(i);
                }
            }
        });
        lines.clear();
        lines.resize(line.len(), Vector::ZERO);
        let parts = line.par_chunks_mut(nodes).zip(lines.par_chunks_mut(nodes));
        // Differences of s as those of n, or their sum would depend on where nodes lie.
        parts.enumerate().for_each(|(task, (line, lines))| {
            for (k, (line, pull)) in line.iter_mut().zip(lines).enumerate() {
                let i = task * nodes + k;
                let Some(surface) = surface(i) else {
                    continue;
                };
                let towards = mesh.difference(open, i) * -1.0;
                if towards != Vector::ZERO {
                    let (n, into) = (normals.unit(i), facing.into(i));
                    let met = n.dot(&into);
                    let bend = facing.bend(mesh, wall, i, unit(n - into * met));
                    let more = facing::before(wall[i], VARIANCE) * bend * met;
                    let cosine = wetting[i] / wall[i].max(f64::MIN_POSITIVE);
                    let across = n.dot(&towards);
                    let own = across + into.dot(&towards) * (more - cosine);
                    *line = surface * own;
                    let true_area = surface / normals::sine(met);
                    *pull = (towards + n * (own - across)) * true_area;
                }
            }
        });
    }

    /// kappa, everywhere.
    fn average(&mut self, mesh: &Mesh<D>) {
        let walled = !self.line.is_empty();
        let spare = &mut self.spare;
        self.surface.clone_from(&self.weight);
        mesh.smooth(&mut self.surface, spare, MEAN);
        self.smooth_weight.clone_from(&self.surface);
        if walled {
            let lines = self.line.iter_mut().zip(&mut self.lines);
            for ((line, pull), surface) in lines.zip(&self.surface) {
                let there = 1.0 - facing::fading(*surface, SEEN);
                *line *= there;
                *pull = *pull * there;
            }
            let (weight, smooth) = (&mut self.weight, &mut self.smooth_weight);
            let along = [&mut self.pull, &mut self.line];
            self.even.out(mesh, MEAN, weight, smooth, along, spare);
        }
        mesh.smooth(&mut self.pull, spare, MEAN);
        let weights = self.weight.iter().zip(&self.smooth_weight);
        self.curvature.clear();
        (self.curvature)
            .extend((self.pull.iter().zip(weights)).map(|(sum, (_, weight))| ratio(*sum, *weight)));
        let wide_wall = &self.wide_wall;
        let sharp = |i: usize| {
            let away = if walled {
                1.0 - wide_wall[i] / CUT_OFF
            } else {
                1.0
            };
            (SHARPENING * away.max(0.0)).sqrt()
        };
        self.sharpness.clear();
        (self.sharpness).extend((0..mesh.len()).map(|i| sharp(i) * self.weight[i]));
        let sharpened = self.sharpness.iter().zip(&self.curvature);
        self.pull.clear();
        (self.pull).extend(sharpened.map(|(sharpness, curvature)| sharpness * curvature));
        mesh.smooth(&mut self.pull, spare, MEAN);
        if walled {
            mesh.smooth(&mut self.sharpness, spare, MEAN);
        } else {
            // r is the same all over.
            self.sharpness.clear();
            (self.sharpness).extend(self.smooth_weight.iter().map(|weight| sharp(0) * weight));
        }
        for (i, curvature) in self.curvature.iter_mut().enumerate() {
            let rough = *curvature * self.sharpness[i] - self.pull[i];
            *curvature += sharp(i) * ratio(rough, self.smooth_weight[i]);
            let of_each = (*curvature / (D as f64 - 1.0)).powi(2);
            *curvature /= 1.0 + deeper(D) * of_each.min(MOST_CURVED);
        }
        if walled {
            mesh.smooth(&mut self.line, spare, MEAN);
            let lines = self.line.iter().zip(&self.smooth_weight);
            for (curvature, (sum, weight)) in self.curvature.iter_mut().zip(lines) {
                let pulled = sum / weight.max(LEAST_SURFACE);
                *curvature += pulled.clamp(-MOST_PULLED, MOST_PULLED);
            }
        }
        let found = Found {
            colour: &self.colour,
            normals: &self.normals,
            wall: &self.wall,
            surface: &self.surface,
        };
        self.inward.go_on(mesh, &found, &mut self.curvature);
    }
}
