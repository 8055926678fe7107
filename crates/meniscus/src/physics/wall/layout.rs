//! Where the particles of a wall lie: in layers, the first half a spacing behind the wall's
//! surface, the last as deep as the kernel reaches for a particle that touches the surface.
//!
//! Along the surface they are a spacing apart, up to what makes a whole number of them fit.

mod mesh;
mod revolved;

use std::f64::consts::{PI, TAU};

use crate::shape::{FillError, perpendiculars};
use crate::vector::Vector;

/// The distance between particles, and how many layers a wall has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layers {
    spacing: f64,
    count: usize,
    /// Most particles of a wall.
    limit: usize,
}

/// A face of a tank: an axis, and whether it is the one with the highest coordinate.
pub type Face = (usize, bool);

/// On which side of a closed curve the wall is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// An obstacle.
    Inside,
    /// A vessel.
    Outside,
}

impl Layers {
    /// For particles `spacing` apart and a kernel that reaches `support`, both in m; at most
    /// `limit` particles to a wall.
    ///
    /// ```
    /// use meniscus::physics::wall::layout::Layers;
    /// assert_eq!(Layers::new(0.1, 0.4, 1000).count(), 4);
    /// assert_eq!(Layers::new(0.1, 0.36, 1000).count(), 4);
    /// ```
    pub fn new(spacing: f64, support: f64, limit: usize) -> Self {
        let count = (support / spacing - 1e-9).ceil().max(1.0) as usize;
        Self {
            spacing,
            count,
            limit,
        }
    }

    /// Number of layers.
    pub fn count(&self) -> usize {
        self.count
    }

    /// How far the layers reach from the surface, m.
    pub fn thickness(&self) -> f64 {
        self.count as f64 * self.spacing
    }

    fn depths(&self) -> impl DoubleEndedIterator<Item = f64> {
        (0..self.count).map(|k| (k as f64 + 0.5) * self.spacing)
    }

    /// Refuses what would be more particles than there is room for.
    fn allow(&self, estimate: f64) -> Result<(), FillError> {
        if !(self.spacing > 0.0 && self.spacing.is_finite()) {
            return Err(FillError::Spacing(self.spacing));
        }
        if !estimate.is_finite() {
            return Err(FillError::Unbounded);
        }
        if estimate > self.limit as f64 {
            let limit = self.limit;
            return Err(FillError::TooMany { estimate, limit });
        }
        Ok(())
    }

    /// Coordinates that divide a length evenly, from the middle of its first part.
    fn along(&self, length: f64) -> impl Iterator<Item = f64> {
        let parts = (length / self.spacing).round().max(1.0);
        (0..parts as usize).map(move |k| (k as f64 + 0.5) * length / parts)
    }

    /// A box from `low` to `high` with walls around it, but for the `open` faces.
    ///
    /// # Errors
    /// As [`Arrangement::fill`](crate::shape::Arrangement::fill).
    pub fn tank<const D: usize>(
        &self,
        low: Vector<f64, D>,
        high: Vector<f64, D>,
        open: &[Face],
    ) -> Result<Vec<Vector<f64, D>>, FillError> {
        if (0..D).any(|d| low[d] >= high[d]) {
            return Err(FillError::Empty);
        }
        let (mut outer, mut inner) = (1.0, 1.0);
        for d in 0..D {
            inner *= (high[d] - low[d]) / self.spacing;
            outer *= (high[d] - low[d]) / self.spacing + 2.0 * self.count as f64;
        }
        self.allow(outer - inner)?;
        // Coordinates along each axis, and which of them are of the inside.
        let axes: [Vec<(f64, bool)>; D] = std::array::from_fn(|d| {
            let mut axis = Vec::new();
            if !open.contains(&(d, false)) {
                axis.extend(self.depths().rev().map(|depth| (low[d] - depth, false)));
            }
            let inside = self.along(high[d] - low[d]);
            axis.extend(inside.map(|x| (low[d] + x, true)));
            if !open.contains(&(d, true)) {
                axis.extend(self.depths().map(|depth| (high[d] + depth, false)));
            }
            axis
        });
        let mut positions = Vec::new();
        let total: usize = axes.iter().map(Vec::len).product();
        for site in 0..total {
            let mut rest = site;
            let mut inside = true;
            let position = Vector(std::array::from_fn(|d| {
                let (x, within) = axes[d][rest % axes[d].len()];
                rest /= axes[d].len();
                inside &= within;
                x
            }));
            if !inside {
                positions.push(position);
            }
        }
        some(positions)
    }

    /// A flat wall through `point`, behind the side that `normal` points to, `width` wide
    /// about the point.
    ///
    /// # Errors
    /// As [`Arrangement::fill`](crate::shape::Arrangement::fill).
    pub fn plane<const D: usize>(
        &self,
        point: Vector<f64, D>,
        normal: Vector<f64, D>,
        width: f64,
    ) -> Result<Vec<Vector<f64, D>>, FillError> {
        let length = normal.norm();
        if !(length > 0.0 && width > 0.0) {
            return Err(FillError::Empty);
        }
        let across = (width / self.spacing).round().max(1.0).powi(D as i32 - 1);
        self.allow(across * self.count as f64)?;
        let normal = normal * (1.0 / length);
        let tangents = perpendiculars(&normal);
        let mut positions = Vec::new();
        for depth in self.depths() {
            let base = point - normal * depth;
            for x in self.along(width) {
                let row = base + tangents[0] * (x - 0.5 * width);
                if D == 2 {
                    positions.push(row);
                    continue;
                }
                let turned = |y: f64| row + tangents[1] * (y - 0.5 * width);
                positions.extend(self.along(width).map(turned));
            }
        }
        some(positions)
    }

    /// A disc, or in 3D a ball; or all around it.
    ///
    /// # Errors
    /// As [`Arrangement::fill`](crate::shape::Arrangement::fill).
    pub fn ball<const D: usize>(
        &self,
        centre: Vector<f64, D>,
        radius: f64,
        side: Side,
    ) -> Result<Vec<Vector<f64, D>>, FillError> {
        let outer = match side {
            Side::Inside => radius,
            Side::Outside => radius + self.thickness(),
        };
        let circumference = TAU * outer / self.spacing;
        let shell = circumference
            * if D == 2 {
                1.0
            } else {
                2.0 * outer / self.spacing
            };
        self.allow(shell * self.count as f64)?;
        let mut positions = Vec::new();
        for depth in self.depths() {
            let r = match side {
                Side::Inside => radius - depth,
                Side::Outside => radius + depth,
            };
            if r < 0.25 * self.spacing {
                // What is left in the middle is the place of one particle.
                if r > -0.25 * self.spacing {
                    positions.push(centre);
                }
                break;
            }
            let arms = shell_of::<D>(r / self.spacing);
            positions.extend(arms.into_iter().map(|arm| centre + arm * r));
        }
        some(positions)
    }

    /// A polygon with these corners in 2D; or all around it.
    ///
    /// # Errors
    /// As [`Arrangement::fill`](crate::shape::Arrangement::fill).
    pub fn polygon(
        &self,
        corners: &[Vector<f64, 2>],
        side: Side,
    ) -> Result<Vec<Vector<f64, 2>>, FillError> {
        let n = corners.len();
        let edge = |k: usize| corners[(k + 1) % n] - corners[k % n];
        let area: f64 = (0..n)
            .map(|k| cross(corners[k], corners[(k + 1) % n]))
            .sum();
        if n < 3 || area == 0.0 || (0..n).any(|k| edge(k).norm() == 0.0) {
            return Err(FillError::Empty);
        }
        let length: f64 = (0..n).map(|k| edge(k).norm()).sum();
        let around = length + 8.0 * self.thickness();
        self.allow(around / self.spacing * self.count as f64)?;
        // Normals into the wall.
        let sign = area.signum() * if side == Side::Inside { 1.0 } else { -1.0 };
        let into = |k: usize| {
            let e = edge(k) * (sign / edge(k).norm());
            Vector([-e[1], e[0]])
        };
        let mut positions = Vec::new();
        for depth in self.depths() {
            // Edges moved into the wall, cut where they meet their neighbours.
            let corner = |k: usize| {
                let (a, b) = (into(k + n - 1), into(k));
                let between = a + b;
                let square = between.norm_squared();
                // A needle's corner would lie far away.
                let reach = if square > 0.1 { 2.0 / square } else { 0.5 };
                corners[k % n] + between * (depth * reach)
            };
            for k in 0..n {
                let (start, end) = (corner(k), corner(k + 1));
                let direction = edge(k) * (1.0 / edge(k).norm());
                let length = (end - start).dot(&direction);
                if length <= 0.0 {
                    continue;
                }
                for x in self.along(length) {
                    let position = start + direction * x;
                    let clear = (0..n).all(|m| {
                        let distance =
                            distance_to_segment(position, corners[m], corners[(m + 1) % n]);
                        distance >= depth - 1e-6 * self.spacing
                    });
                    let crowded = positions.iter().rev().any(|other: &Vector<f64, 2>| {
                        (*other - position).norm_squared() < (0.5 * self.spacing).powi(2)
                    });
                    if clear && !crowded {
                        positions.push(position);
                    }
                }
            }
        }
        some(positions)
    }
}

fn some<const D: usize>(positions: Vec<Vector<f64, D>>) -> Result<Vec<Vector<f64, D>>, FillError> {
    if positions.is_empty() {
        Err(FillError::Empty)
    } else {
        Ok(positions)
    }
}

/// Evenly spread unit vectors, a spacing apart on a circle or sphere of a radius in spacings.
fn shell_of<const D: usize>(radius: f64) -> Vec<Vector<f64, D>> {
    if D == 2 {
        let count = (TAU * radius).round().max(3.0);
        return (0..count as usize)
            .map(|k| {
                let (sin, cos) = (TAU * k as f64 / count).sin_cos();
                Vector::from_3d([cos, sin, 0.0])
            })
            .collect();
    }
    // The spiral of equal areas, as for spherical shells of fluid.
    let count = (4.0 * PI * radius * radius).round().max(4.0);
    let golden_angle = PI * (3.0 - 5.0_f64.sqrt());
    (0..count as usize)
        .map(|k| {
            let height = 1.0 - (2.0 * k as f64 + 1.0) / count;
            let across = (1.0 - height * height).sqrt();
            let (sin, cos) = (golden_angle * k as f64).sin_cos();
            Vector::from_3d([across * cos, across * sin, height])
        })
        .collect()
}

fn cross(a: Vector<f64, 2>, b: Vector<f64, 2>) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

fn distance_to_segment(point: Vector<f64, 2>, start: Vector<f64, 2>, end: Vector<f64, 2>) -> f64 {
    let along = end - start;
    let part = (point - start).dot(&along) / along.norm_squared();
    (point - start - along * part.clamp(0.0, 1.0)).norm()
}
