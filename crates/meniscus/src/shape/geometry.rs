//! Shapes, and whether a point is inside.
//!
//! Shapes are open: a point on the surface, up to rounding (1e-9 of the
//! shape's size), is outside. So a lattice that touches the surface gives the
//! same particles on every machine, and "a ball of 15 spacings" means just
//! under 15.

use super::polygon;
use super::revolved::Revolved;
use super::rotation::Rotation;
use crate::vector::Vector;

/// How near the surface, over the shape's size, a point counts as on it:
/// far above the rounding of coordinates, far below any spacing.
pub(super) const ROUNDING: f64 = 1e-9;

/// A region of space. Lengths in metres.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape<const D: usize> {
    /// Sides along the axes, between two opposite corners.
    Block {
        /// The corner with the lowest coordinates.
        low: Vector<f64, D>,
        /// The corner with the highest coordinates.
        high: Vector<f64, D>,
    },
    /// A disc in 2D, a ball in 3D.
    Ball {
        /// Centre.
        centre: Vector<f64, D>,
        /// Radius.
        radius: f64,
    },
    /// An ellipse in 2D, an ellipsoid in 3D.
    Ellipsoid {
        /// Centre.
        centre: Vector<f64, D>,
        /// Semi-axes along x, y (and z) before it is turned.
        semi_axes: Vector<f64, D>,
        /// How it is turned about its centre.
        rotation: Rotation<D>,
    },
    /// Everything within a distance of the line between two points, cut flat
    /// at its ends. In 2D a rectangle at any angle.
    Cylinder {
        /// Middle of one end.
        start: Vector<f64, D>,
        /// Middle of the other end.
        end: Vector<f64, D>,
        /// Radius.
        radius: f64,
    },
    /// The corners in order, the last joined to the first. In 3D the endless
    /// prism over it along z.
    Polygon(Vec<Vector<f64, 2>>),
    /// A polygon turned about an axis; in 2D the cut through it by the plane z = 0.
    Revolved(Revolved),
    /// Everything on the far side of a plane from where its normal points.
    HalfSpace {
        /// A point of the plane.
        point: Vector<f64, D>,
        /// Outward normal, of any length.
        normal: Vector<f64, D>,
    },
    /// What is in any of these.
    Union(Vec<Shape<D>>),
    /// What is in all of these.
    Intersection(Vec<Shape<D>>),
    /// What is in the first and in none of the others.
    Difference(Box<Shape<D>>, Vec<Shape<D>>),
}

impl<const D: usize> Shape<D> {
    /// Whether a point is inside. Anything with a NaN in it contains nothing.
    pub fn contains(&self, x: &Vector<f64, D>) -> bool {
        match self {
            Shape::Block { low, high } => (0..D).all(|d| {
                let edge = ROUNDING * (high[d] - low[d]);
                low[d] + edge < x[d] && x[d] < high[d] - edge
            }),
            Shape::Ball { centre, radius } => (*x - *centre).norm() < radius * (1.0 - ROUNDING),
            Shape::Ellipsoid {
                centre,
                semi_axes,
                rotation,
            } => {
                let r = rotation.undo(&(*x - *centre));
                let level: f64 = (0..D).map(|d| (r[d] / semi_axes[d]).powi(2)).sum();
                semi_axes.0.iter().all(|&a| a > 0.0) && level.sqrt() < 1.0 - ROUNDING
            }
            Shape::Cylinder { start, end, radius } => {
                let axis = *end - *start;
                let along = (*x - *start).dot(&axis) / axis.norm_squared();
                let away = (*x - *start - axis * along).norm();
                ROUNDING < along && along < 1.0 - ROUNDING && away < radius * (1.0 - ROUNDING)
            }
            Shape::Polygon(corners) => polygon::contains(corners, Vector([x[0], x[1]])),
            Shape::Revolved(shape) => shape.contains(&Vector(x.to_3d())),
            Shape::HalfSpace { point, normal } => {
                let r = *x - *point;
                r.dot(normal) < -ROUNDING * r.norm() * normal.norm()
            }
            Shape::Union(shapes) => shapes.iter().any(|shape| shape.contains(x)),
            Shape::Intersection(shapes) => {
                !shapes.is_empty() && shapes.iter().all(|shape| shape.contains(x))
            }
            Shape::Difference(shape, less) => {
                shape.contains(x) && !less.iter().any(|other| other.contains(x))
            }
        }
    }

    /// The lowest and the highest coordinates; infinite where the shape is
    /// endless, low above high where it holds nothing.
    pub fn bounding_box(&self) -> (Vector<f64, D>, Vector<f64, D>) {
        let around =
            |centre: &Vector<f64, D>, reach: Vector<f64, D>| (*centre - reach, *centre + reach);
        match self {
            Shape::Block { low, high } => (*low, *high),
            Shape::Ball { centre, radius } => around(centre, Vector([*radius; D])),
            Shape::Ellipsoid {
                centre,
                semi_axes,
                rotation,
            } => {
                let mut reach = Vector::ZERO;
                for d in 0..D {
                    let mut axis = Vector::ZERO;
                    axis[d] = semi_axes[d];
                    let axis = rotation.apply(&axis);
                    for e in 0..D {
                        reach[e] = f64::hypot(reach[e], axis[e]);
                    }
                }
                around(centre, reach)
            }
            Shape::Cylinder { start, end, radius } => {
                let axis = *end - *start;
                let square = axis.norm_squared();
                let reach = Vector(
                    axis.0
                        .map(|a| radius * (1.0 - a * a / square).max(0.0).sqrt()),
                );
                hull(around(start, reach), around(end, reach))
            }
            Shape::Polygon(corners) => {
                let (low, high) = polygon::bounding_box(corners);
                let endless = (Vector([f64::NEG_INFINITY; D]), Vector([f64::INFINITY; D]));
                let fill = |v: Vector<f64, 2>, rest: Vector<f64, D>| {
                    Vector(std::array::from_fn(|d| if d < 2 { v[d] } else { rest[d] }))
                };
                (fill(low, endless.0), fill(high, endless.1))
            }
            Shape::Revolved(shape) => {
                let (low, high) = shape.bounding_box();
                (Vector::from_3d(low.0), Vector::from_3d(high.0))
            }
            Shape::HalfSpace { .. } => (Vector([f64::NEG_INFINITY; D]), Vector([f64::INFINITY; D])),
            Shape::Union(shapes) => {
                let nothing = (Vector([f64::INFINITY; D]), Vector([f64::NEG_INFINITY; D]));
                shapes
                    .iter()
                    .fold(nothing, |all, shape| hull(all, shape.bounding_box()))
            }
            Shape::Intersection(shapes) => {
                let everything = (Vector([f64::NEG_INFINITY; D]), Vector([f64::INFINITY; D]));
                shapes.iter().fold(everything, |all, shape| {
                    let (low, high) = shape.bounding_box();
                    (zip(all.0, low, f64::max), zip(all.1, high, f64::min))
                })
            }
            Shape::Difference(shape, _) => shape.bounding_box(),
        }
    }

    /// Flat faces that half spaces may cut: a point of each, and its outward unit normal.
    pub fn cuts(&self) -> Vec<(Vector<f64, D>, Vector<f64, D>)> {
        let of = |shape: &Shape<D>, sign: f64| match shape {
            Shape::HalfSpace { point, normal } if normal.norm() > 0.0 => {
                Some((*point, *normal * (sign / normal.norm())))
            }
            _ => None,
        };
        match self {
            Shape::Intersection(shapes) => (shapes.iter())
                .flat_map(|shape| of(shape, 1.0).into_iter().chain(shape.cuts()))
                .collect(),
            Shape::Difference(shape, less) => {
                let cut = less.iter().filter_map(|less| of(less, -1.0));
                shape.cuts().into_iter().chain(cut).collect()
            }
            _ => Vec::new(),
        }
    }

    /// The centre of a shape that has one. A shape made of others takes that of the first part, an intersection of the
    /// first part that has one.
    pub fn centre(&self) -> Option<Vector<f64, D>> {
        match self {
            Shape::Ball { centre, .. } | Shape::Ellipsoid { centre, .. } => Some(*centre),
            Shape::Cylinder { start, end, .. } => Some((*start + *end) * 0.5),
            Shape::Block { .. }
            | Shape::Polygon(_)
            | Shape::Revolved(_)
            | Shape::HalfSpace { .. } => None,
            Shape::Union(shapes) => shapes.first().and_then(Shape::centre),
            Shape::Intersection(shapes) => shapes.iter().find_map(Shape::centre),
            Shape::Difference(shape, _) => shape.centre(),
        }
    }
}

type Bounds<const D: usize> = (Vector<f64, D>, Vector<f64, D>);

fn hull<const D: usize>(a: Bounds<D>, b: Bounds<D>) -> Bounds<D> {
    (zip(a.0, b.0, f64::min), zip(a.1, b.1, f64::max))
}

fn zip<const D: usize>(
    a: Vector<f64, D>,
    b: Vector<f64, D>,
    f: fn(f64, f64) -> f64,
) -> Vector<f64, D> {
    Vector(std::array::from_fn(|d| f(a[d], b[d])))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Share of a fine grid over the bounding box that is inside, times the box: the volume.
    fn volume<const D: usize>(shape: &Shape<D>, cells: usize) -> f64 {
        let (low, high) = shape.bounding_box();
        let size = high - low;
        let total = cells.pow(D as u32);
        let inside = (0..total)
            .filter(|&site| {
                let mut rest = site;
                let x = Vector(std::array::from_fn(|d| {
                    let i = rest % cells;
                    rest /= cells;
                    low[d] + size[d] * (i as f64 + 0.5) / cells as f64
                }));
                shape.contains(&x)
            })
            .count();
        size.0.iter().product::<f64>() * inside as f64 / total as f64
    }

    #[test]
    fn volumes_are_the_textbook_ones() {
        use std::f64::consts::PI;
        let turned = Rotation::<3>::about(Vector([1.0, 2.0, -1.0]), 0.7);
        let ellipsoid = Shape::Ellipsoid {
            centre: Vector([3.0, 0.0, -1.0]),
            semi_axes: Vector([3.0, 2.0, 1.0]),
            rotation: turned,
        };
        let cylinder = Shape::Cylinder {
            start: Vector([0.0, 0.0, 0.0]),
            end: Vector([2.0, 1.0, 2.0]),
            radius: 1.0,
        };
        // A cone beside its axis, its foot a disc of radius 2.
        let cone = Shape::<3>::Revolved(Revolved {
            corners: [[0.0, 0.0], [0.0, 2.0], [3.0, 0.0]].map(Vector).to_vec(),
            point: Vector([1.0, 0.0, -1.0]),
            axis: Vector([1.0, 1.0, 0.5]),
        });
        let ring = Shape::<3>::Revolved(Revolved {
            corners: [[0.0, 2.0], [1.0, 2.0], [1.0, 3.0], [0.0, 3.0]]
                .map(Vector)
                .to_vec(),
            point: Vector::ZERO,
            axis: Vector([0.0, 0.0, -3.0]),
        });
        let ell = Shape::Polygon::<2>(vec![
            Vector([0.0, 0.0]),
            Vector([2.0, 0.0]),
            Vector([2.0, 1.0]),
            Vector([1.0, 1.0]),
            Vector([1.0, 3.0]),
            Vector([0.0, 3.0]),
        ]);
        let disc = |x: f64| Shape::Ball {
            centre: Vector([x, 0.0]),
            radius: 1.0,
        };
        // Two unit discs a unit apart: the lens is 2 pi/3 - sqrt(3)/2.
        let lens = 2.0 * PI / 3.0 - 0.75_f64.sqrt();
        // Counting cell centres errs by a fraction of the surface's cells: 0.5 % is ample.
        let near = |found: f64, exact: f64| {
            assert!((found / exact - 1.0).abs() < 5e-3, "{found} for {exact}")
        };
        near(volume(&ellipsoid, 100), 4.0 / 3.0 * PI * 6.0);
        near(volume(&cylinder, 100), PI * 3.0);
        near(volume(&cone, 100), PI * 4.0);
        near(volume(&ring, 100), PI * 5.0);
        near(volume(&ell, 300), 4.0);
        near(
            volume(&Shape::Union(vec![disc(0.0), disc(1.0)]), 500),
            2.0 * PI - lens,
        );
        near(
            volume(&Shape::Intersection(vec![disc(0.0), disc(1.0)]), 500),
            lens,
        );
        near(
            volume(
                &Shape::Difference(Box::new(disc(0.0)), vec![disc(1.0)]),
                500,
            ),
            PI - lens,
        );
        let half = Shape::HalfSpace {
            point: Vector([0.0, 0.0]),
            normal: Vector([1.0, 2.0]),
        };
        near(
            volume(&Shape::Intersection(vec![disc(0.0), half]), 500),
            PI / 2.0,
        );
    }

    #[test]
    fn a_difference_and_its_cutter_share_no_point_and_lose_none() {
        let block = |low: f64, high: f64| Shape::Block {
            low: Vector([low; 2]),
            high: Vector([high; 2]),
        };
        let whole = block(0.0, 4.0);
        let rest = Shape::Difference(Box::new(whole.clone()), vec![block(1.0, 3.0)]);
        for i in 1..16 {
            for j in 1..16 {
                // Quarters hit every edge of the cutter exactly.
                let x = Vector([f64::from(i) * 0.25, f64::from(j) * 0.25]);
                assert!(rest.contains(&x) != block(1.0, 3.0).contains(&x));
            }
        }
    }

    #[test]
    fn senseless_shapes_hold_nothing() {
        let x = Vector([0.0, 0.0]);
        assert!(
            !Shape::Ball {
                centre: x,
                radius: f64::NAN
            }
            .contains(&x)
        );
        assert!(
            !Shape::Ball {
                centre: x,
                radius: -1.0
            }
            .contains(&x)
        );
        let flat = Shape::Ellipsoid {
            centre: x,
            semi_axes: Vector([1.0, 0.0]),
            rotation: Rotation::none(),
        };
        assert!(!flat.contains(&x));
        assert!(!Shape::Polygon::<2>(vec![]).contains(&x));
        assert!(!Shape::Intersection::<2>(vec![]).contains(&x));
        assert!(
            !Shape::Cylinder {
                start: x,
                end: x,
                radius: 1.0
            }
            .contains(&x)
        );
        assert!(
            !Shape::HalfSpace {
                point: x,
                normal: x
            }
            .contains(&Vector([1.0, 0.0]))
        );
    }
}
