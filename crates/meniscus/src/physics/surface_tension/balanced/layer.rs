//! Which particles make the surface, and where it is.
//!
//! The layer is of the particles with c_i < C(1.5 dx) and |n_i| > 0.6 W_1(1.5 dx) that have one
//! with c_j < C(0.75 dx) within 2 dx: without the last, noise inside the liquid would become a
//! surface. Deeper ones, with c_i < C(2.5 dx), carry the layer's curvature where they have
//! neighbours in it.

use super::coverage::{Coverage, Covered, Facing, Inward};
use super::half_space::HalfSpace;
use super::regression::Point;
use super::wedge::Wedge;
use super::wetting::{WallCoverage, WallCovered, Wetting, mirrored};
use crate::particles::Particles;
use crate::physics::surface_tension::gradient::LEAST_MATRIX;
use crate::term::Sweep;
use crate::vector::Vector;

/// Depths in spacings: of the layer, of what lies at the surface itself, of what carries its
/// curvature.
const LAYER: f64 = 1.5;
const OPEN: f64 = 0.75;
const DEEPEST: f64 = 2.5;
/// Part of W_1 at the depth of the layer that a normal has at least.
const SHORTEST: f64 = 0.6;
/// How near a particle of the layer has one at the surface, spacings.
const NEAR: f64 = 2.0;

/// What a kernel and a spacing make of these depths.
#[derive(Clone, Debug)]
pub(super) struct Thresholds {
    layer: f64,
    open: f64,
    deepest: f64,
    shortest: f64,
    near: f64,
}

impl Thresholds {
    pub(super) fn new(half_space: &HalfSpace, spacing: f64) -> Self {
        Self {
            layer: half_space.filled(LAYER * spacing),
            open: half_space.filled(OPEN * spacing),
            deepest: half_space.filled(DEEPEST * spacing),
            shortest: SHORTEST * half_space.plane(LAYER * spacing),
            near: NEAR * spacing,
        }
    }
}

/// Least part of a wall that counts.
const LEAST_WALL: f64 = 1e-3;

/// The wedge of the wall that a particle is nearest to, if it is within reach.
fn wedge_of<'a, const D: usize>(
    wall: &WallCovered<f64, D>,
    wedges: &'a [Wedge],
) -> Option<&'a Wedge> {
    let angle = wall.angle / wall.filled;
    let off = |wedge: &Wedge| (wedge.angle - angle).abs();
    (wedges.iter())
        .filter(|_| wall.filled > LEAST_WALL)
        .min_by(|a, b| off(a).total_cmp(&off(b)))
}

/// The particles at the surface: columns of one row per particle.
#[derive(Debug, Default)]
pub(super) struct Layer<const D: usize> {
    pub(super) covered: Vec<Covered<f64, D>>,
    pub(super) facing: Vec<Facing<f64, D>>,
    /// Depth under the surface, m, of the layer's particles.
    pub(super) depth: Vec<f64>,
    /// The points of the surface above them; of weight zero for all others.
    pub(super) points: Vec<Point<f64, D>>,
    /// Whether a row is near enough to the surface to carry its curvature.
    pub(super) shallow: Vec<bool>,
    /// c, as it were without walls; 1 for a wall.
    pub(super) filled: Vec<f64>,
    /// What is seen of walls, the liquid's own n, and the images of points in the contact line;
    /// empty without walls.
    pub(super) walls: Vec<WallCovered<f64, D>>,
    pub(super) own_normal: Vec<Vector<f64, D>>,
    pub(super) images: Vec<Point<f64, D>>,
}

impl<const D: usize> Layer<D> {
    /// Finds c, n and the directions of the surface.
    pub(super) fn look(
        &mut self,
        sweep: &mut impl Sweep<D>,
        particles: &Particles<D>,
        (half_space, thresholds): (&HalfSpace, &Thresholds),
        wetting: &Wetting,
        wedges: &[Wedge],
    ) {
        sweep.sweep(&Coverage, particles, |_| true, &mut self.covered);
        self.filled.clear();
        (self.filled).extend(self.covered.iter().map(|sum| sum.filled));
        if !wetting.volume.is_empty() {
            self.look_at_walls(sweep, particles, half_space, wetting, wedges);
        }
        self.shallow.clear();
        let deepest = thresholds.deepest;
        (self.shallow).extend(self.filled.iter().map(|&filled| filled < deepest));
        let term = Inward {
            filled: &self.filled,
            open: thresholds.open,
            near: thresholds.near,
        };
        let shallow = &self.shallow;
        let near_surface = |rows: std::ops::Range<usize>| shallow[rows].contains(&true);
        sweep.sweep(&term, particles, near_surface, &mut self.facing);
    }

    /// Finds what c would be without walls, and n with them.
    fn look_at_walls(
        &mut self,
        sweep: &mut impl Sweep<D>,
        particles: &Particles<D>,
        half_space: &HalfSpace,
        wetting: &Wetting,
        wedges: &[Wedge],
    ) {
        sweep.sweep(&WallCoverage(wetting), particles, |_| true, &mut self.walls);
        self.own_normal.clear();
        (self.own_normal).extend(self.covered.iter().map(|sum| sum.normal));
        for (i, wall) in self.walls.iter().enumerate() {
            if wetting.volume[i] > 0.0 {
                self.filled[i] = 1.0;
            } else if let Some(wedge) = wedge_of(wall, wedges) {
                let covered = &mut self.covered[i];
                let depth = wedge.depth(half_space, covered.filled, wall.filled);
                self.filled[i] = half_space.filled(depth);
                covered.normal += wall.normal;
            }
        }
    }

    /// Whether a particle is within reach of a wall.
    pub(super) fn touches(&self, i: usize) -> bool {
        self.walls
            .get(i)
            .is_some_and(|wall| wall.filled > LEAST_WALL)
    }

    /// n of the liquid alone, 1/m.
    pub(super) fn own_normal(&self, i: usize) -> Vector<f64, D> {
        let own = self.own_normal.get(i);
        own.copied().unwrap_or(self.covered[i].normal)
    }

    /// Finds the images of the points near walls.
    fn mirror(&mut self, half_space: &HalfSpace, wedges: &[Wedge]) {
        self.images.clear();
        let find = |(point, wall): (&Point<f64, D>, &WallCovered<f64, D>)| {
            let wedge = wedge_of(wall, wedges).filter(|_| point.weight > 0.0)?;
            let away = wall.normal * (-1.0 / wall.normal.norm());
            let distance = half_space.depth(1.0 - wall.filled, 0.0) - point.inset.dot(&away);
            mirrored(point, &away, distance, wedge.angle)
        };
        let pairs = self.points.iter().zip(&self.walls);
        (self.images).extend(pairs.map(|pair| find(pair).unwrap_or_default()));
    }

    /// Finds the depth of the layer's particles under a surface of this `curvature`, 1/m, and its
    /// points above them.
    pub(super) fn locate(
        &mut self,
        particles: &Particles<D>,
        half_space: &HalfSpace,
        thresholds: &Thresholds,
        wedges: &[Wedge],
        curvature: &[f64],
    ) {
        self.points.clear();
        self.points.resize(particles.len(), Point::default());
        self.depth.clear();
        self.depth.resize(particles.len(), 0.0);
        for (i, &curvature) in curvature.iter().enumerate() {
            let length = self.covered[i].normal.norm();
            if self.filled[i] >= thresholds.layer
                || length <= thresholds.shortest
                || self.facing[i].open == 0.0
            {
                continue;
            }
            let sum = &self.facing[i].inward;
            let inward = sum.matrix.inverse(LEAST_MATRIX).times(&sum.gradient);
            let slope = inward.norm();
            if slope == 0.0 {
                continue;
            }
            let direction: Vector<f64, D> = inward * (1.0 / slope);
            self.depth[i] = half_space.depth(self.filled[i], curvature);
            self.points[i] = Point {
                inset: direction * self.depth[i],
                direction,
                weight: particles.volume(i) * length,
            };
        }
        if !self.walls.is_empty() {
            self.mirror(half_space, wedges);
        }
    }

    /// Whether a row belongs to the layer.
    pub(super) fn holds(&self, i: usize) -> bool {
        self.points[i].weight > 0.0
    }
}
