//! A surface of triangles, closed or open, and how far a point is from it.
//!
//! The side of a point follows from the normal where it is nearest: of a face, the mean of two
//! faces at an edge, or that of all faces at a corner weighted by their angles, which is right
//! for any closed surface (Baerentzen and Aanaes 2005, IEEE Trans. Vis. Comput. Graph. 11, 243).

use std::collections::HashMap;
use std::fmt;

use super::stl;
use crate::vector::Vector;

/// A triangle is degenerate if its height is less than this part of its longest side.
const THINNEST: f64 = 1e-9;

/// Triangles, anticlockwise seen from outside.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    triangles: Vec<Facet>,
}

/// Why a mesh cannot be used. Triangles are counted from 1, in the order of the file.
#[derive(Clone, Debug, PartialEq)]
pub enum MeshError {
    /// It is no STL file: why not.
    NotStl(String),
    /// It has no triangle.
    Empty,
    /// A triangle has a corner that is no finite number.
    NotFinite(usize),
    /// A triangle has no area.
    Degenerate(usize),
    /// Two triangles that share a side face opposite ways.
    Flipped(usize, usize),
}

impl fmt::Display for MeshError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            MeshError::NotStl(why) => write!(f, "this is no STL file: {why}"),
            MeshError::Empty => write!(f, "the mesh has no triangle"),
            MeshError::NotFinite(which) => {
                write!(f, "a corner of triangle {which} is no finite number")
            }
            MeshError::Degenerate(which) => write!(f, "triangle {which} has no area"),
            MeshError::Flipped(first, second) => write!(
                f,
                "triangles {first} and {second} share a side and face opposite ways"
            ),
        }
    }
}

impl std::error::Error for MeshError {}

/// A normal, and whether the surface ends there.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Feature {
    normal: Vector<f64, 3>,
    rim: bool,
}

/// A triangle with the normals of its parts.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Facet {
    pub corners: [Vector<f64, 3>; 3],
    normal: Vector<f64, 3>,
    /// Of the side from corner k to the next.
    sides: [Feature; 3],
    at_corners: [Feature; 3],
}

/// The point of a facet that is nearest to another.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Nearest {
    /// Square of the distance, m^2.
    pub distance_squared: f64,
    /// The distance, m, above zero outside.
    pub height: f64,
    /// How far, m, the point lies beyond the rim of an open mesh.
    pub beyond: f64,
}

impl Mesh {
    /// From the bytes of an STL file whose unit of length is `unit` m.
    ///
    /// ```
    /// use meniscus::shape::{Mesh, MeshError};
    /// let text = "solid s facet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 2 0 endloop endfacet endsolid s";
    /// assert_eq!(Mesh::from_stl(text.as_bytes(), 1e-3).unwrap().area(), 1e-6);
    /// assert_eq!(Mesh::from_stl(b"solid nothing", 1.0), Err(MeshError::Empty));
    /// ```
    ///
    /// # Errors
    /// If it is no STL file, holds no triangle, or one that is of no use.
    pub fn from_stl(bytes: &[u8], unit: f64) -> Result<Self, MeshError> {
        let mut triangles = stl::read(bytes)?;
        for corner in triangles.iter_mut().flatten() {
            *corner = *corner * unit;
        }
        Self::new(&triangles)
    }

    /// From the corners of its triangles, m.
    ///
    /// # Errors
    /// If there is none, or one that is of no use.
    pub fn new(triangles: &[[Vector<f64, 3>; 3]]) -> Result<Self, MeshError> {
        if triangles.is_empty() {
            return Err(MeshError::Empty);
        }
        let mut sides: HashMap<(Place, Place), usize> = HashMap::new();
        let mut normals = Vec::new();
        let mut at_corners: HashMap<Place, Feature> = HashMap::new();
        for (k, corners) in triangles.iter().enumerate() {
            let normal = normal_of(corners, k + 1)?;
            normals.push(normal);
            for c in 0..3 {
                let side = (place(corners[c]), place(corners[(c + 1) % 3]));
                if let Some(other) = sides.insert(side, k) {
                    return Err(MeshError::Flipped(other + 1, k + 1));
                }
                let (a, b) = (
                    corners[(c + 1) % 3] - corners[c],
                    corners[(c + 2) % 3] - corners[c],
                );
                let angle = (a.dot(&b) / (a.norm() * b.norm())).clamp(-1.0, 1.0).acos();
                let none = Feature {
                    normal: Vector::ZERO,
                    rim: false,
                };
                at_corners.entry(side.0).or_insert(none).normal += normal * angle;
            }
        }
        for &(from, to) in sides.keys() {
            if !sides.contains_key(&(to, from)) {
                for end in [from, to] {
                    if let Some(corner) = at_corners.get_mut(&end) {
                        corner.rim = true;
                    }
                }
            }
        }
        let facet = |(k, corners): (usize, &[Vector<f64, 3>; 3])| Facet {
            corners: *corners,
            normal: normals[k],
            sides: std::array::from_fn(|c| {
                let other = sides.get(&(place(corners[(c + 1) % 3]), place(corners[c])));
                Feature {
                    normal: normals[k] + other.map_or(Vector::ZERO, |&other| normals[other]),
                    rim: other.is_none(),
                }
            }),
            at_corners: corners.map(|corner| at_corners[&place(corner)]),
        };
        Ok(Self {
            triangles: triangles.iter().enumerate().map(facet).collect(),
        })
    }

    /// Area, m^2.
    pub fn area(&self) -> f64 {
        let doubled = |facet: &Facet| {
            let [a, b, c] = facet.corners;
            cross(b - a, c - a).norm()
        };
        0.5 * self.triangles.iter().map(doubled).sum::<f64>()
    }

    /// The lowest and the highest coordinates, m.
    pub fn bounding_box(&self) -> (Vector<f64, 3>, Vector<f64, 3>) {
        let corners = self.triangles.iter().flat_map(|facet| facet.corners);
        bounds(corners)
    }

    pub(crate) fn facets(&self) -> &[Facet] {
        &self.triangles
    }
}

/// The lowest and the highest coordinates of points.
pub(crate) fn bounds(
    points: impl IntoIterator<Item = Vector<f64, 3>>,
) -> (Vector<f64, 3>, Vector<f64, 3>) {
    let mut low = Vector([f64::INFINITY; 3]);
    let mut high = Vector([f64::NEG_INFINITY; 3]);
    for point in points {
        for d in 0..3 {
            low[d] = low[d].min(point[d]);
            high[d] = high[d].max(point[d]);
        }
    }
    (low, high)
}

/// Corners are one where their coordinates are the same numbers.
type Place = [u64; 3];

fn place(corner: Vector<f64, 3>) -> Place {
    // Minus zero is zero.
    corner.0.map(|x| (x + 0.0).to_bits())
}

fn normal_of(corners: &[Vector<f64, 3>; 3], which: usize) -> Result<Vector<f64, 3>, MeshError> {
    let [a, b, c] = *corners;
    let (ab, ac) = (b - a, c - a);
    let longest = ab.norm().max(ac.norm()).max((c - b).norm());
    let doubled = cross(ab, ac);
    if !doubled.norm().is_finite() || !longest.is_finite() {
        return Err(MeshError::NotFinite(which));
    }
    if doubled.norm() <= THINNEST * longest * longest {
        return Err(MeshError::Degenerate(which));
    }
    Ok(doubled * (1.0 / doubled.norm()))
}

fn cross(a: Vector<f64, 3>, b: Vector<f64, 3>) -> Vector<f64, 3> {
    Vector([
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ])
}

impl Facet {
    /// Where it is nearest to a point.
    pub(crate) fn nearest(&self, point: Vector<f64, 3>) -> Nearest {
        let (on, feature) = self.projected(point);
        let arm = point - on;
        let distance_squared = arm.norm_squared();
        let upright = arm.dot(&self.normal);
        let side = arm.dot(&feature.normal);
        let beyond = if feature.rim {
            (distance_squared - upright * upright).max(0.0).sqrt()
        } else {
            0.0
        };
        Nearest {
            distance_squared,
            height: distance_squared.sqrt().copysign(side),
            beyond,
        }
    }

    /// The nearest point, and the part of the triangle that it is on: inside, if the point's
    /// foot is; otherwise on the nearest side, or a corner at the end of it.
    fn projected(&self, point: Vector<f64, 3>) -> (Vector<f64, 3>, Feature) {
        let [a, b, c] = self.corners;
        let within = [(a, b), (b, c), (c, a)]
            .iter()
            .all(|(from, to)| cross(*to - *from, point - *from).dot(&self.normal) >= 0.0);
        if within {
            let foot = point - self.normal * (point - a).dot(&self.normal);
            let inner = Feature {
                normal: self.normal,
                rim: false,
            };
            return (foot, inner);
        }
        let mut best = (f64::INFINITY, a, self.sides[0]);
        for k in 0..3 {
            let (from, to) = (self.corners[k], self.corners[(k + 1) % 3]);
            let along = to - from;
            let part = (point - from).dot(&along) / along.norm_squared();
            let feature = if part <= 0.0 {
                self.at_corners[k]
            } else if part >= 1.0 {
                self.at_corners[(k + 1) % 3]
            } else {
                self.sides[k]
            };
            let on = from + along * part.clamp(0.0, 1.0);
            let distance = (point - on).norm_squared();
            if distance < best.0 {
                best = (distance, on, feature);
            }
        }
        (best.1, best.2)
    }
}
