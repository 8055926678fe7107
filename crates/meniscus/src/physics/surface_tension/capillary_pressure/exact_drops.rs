//! q of exact drops on walls, filled by points much finer than particles.
//!
//! At rest q is the same all over a surface. Where it is not, what it comes to along the wall, sum (kappa - 2 H) dz over the height of
//! the surface, is a pull on the contact line that would move it, to where cos(phi) has changed by as much.

use super::nodes::{MARGIN, Nodes, WALLED_MARGIN};
use crate::physics::surface_tension::mesh::{Layered, Mesh};
use crate::theory::{Cap, CapOnBall};
use crate::vector::Vector;

/// A drop on a plane, or on a disc of this radius (2D). Lengths in spacings.
#[derive(Clone, Copy)]
struct Drop {
    volume: f64,
    degrees: f64,
    wall: Option<f64>,
}

impl Drop {
    fn angle(&self) -> f64 {
        self.degrees.to_radians()
    }

    /// Radius of the surface, and how high its centre lies over the top of the wall.
    fn sphere(&self, dimension: usize) -> (f64, f64) {
        let (radius, height) = match self.wall {
            None => {
                let cap = Cap::of_volume(self.volume, self.angle(), dimension);
                (cap.base_radius / self.angle().sin(), cap.height)
            }
            Some(wall) => {
                let lens = CapOnBall::of_volume(self.volume, self.angle(), wall, dimension);
                (lens.curvature_radius, lens.height)
            }
        };
        (radius, height - radius)
    }

    /// Height over the wall.
    fn above<const D: usize>(&self, x: Vector<f64, D>) -> f64 {
        self.wall.map_or(x[D - 1], |wall| {
            let mut from_centre = x;
            from_centre[D - 1] += wall;
            from_centre.norm() - wall
        })
    }

    /// The pull on the contact line, of sigma.
    fn pull<const D: usize>(&self, fineness: usize, shift: Vector<f64, D>) -> f64 {
        let (radius, centre) = self.sphere(D);
        let from_centre = |x: Vector<f64, D>| {
            let mut from_centre = x;
            from_centre[D - 1] -= centre;
            from_centre.norm()
        };
        let half = (2.0 * radius.min(26.0)).ceil() + 10.0;
        let cell = 1.0 / fineness as f64;
        let inside = |x: &Vector<f64, D>| from_centre(*x) < radius && self.above(*x) > 0.0;
        let fine: Vec<Vector<f64, D>> = grid(half, cell).filter(inside).collect();
        let coarse: Vec<Vector<f64, D>> = match self.wall {
            Some(wall) => rings(wall),
            None => {
                let in_wall = |x: &Vector<f64, D>| (-4.0..0.0).contains(&self.above(*x));
                grid(half, 1.0).filter(in_wall).collect()
            }
        };
        let volume = cell.powi(D as i32);
        let liquid: Vec<_> = fine.iter().map(|x| (*x + shift, volume)).collect();
        let walls = coarse.iter().map(|x| (*x + shift, self.angle().cos()));
        let (mesh, nodes) = found(&liquid, walls);
        let curvature = (D as f64 - 1.0) / radius;
        // Down the surface in the plane of the first and the last axis, on either side.
        const STEPS: usize = 4000;
        let mut pull = 0.0;
        for side in [-1.0, 1.0] {
            let place = |step: usize| {
                let turn = std::f64::consts::PI * step as f64 / STEPS as f64;
                let mut x = Vector::ZERO;
                x[0] = side * radius * turn.sin();
                x[D - 1] = centre + radius * turn.cos();
                x
            };
            for step in 0..STEPS {
                let (x, next) = (place(step), place(step + 1));
                if self.above(next) < 0.0 {
                    break;
                }
                let found = mesh.feel_at(&nodes.curvature, &(x + shift)).0;
                pull += 0.5 * (found - curvature) * (self.above(x) - self.above(next));
            }
        }
        pull
    }
}

/// What the nodes find around liquid of these volumes; walls have the cosines of their angles.
pub(super) fn found<const D: usize>(
    liquid: &[(Vector<f64, D>, f64)],
    walls: impl Iterator<Item = (Vector<f64, D>, f64)>,
) -> (Mesh<D>, Nodes<D>) {
    let mut nodes = Nodes::default();
    (find_by(&mut nodes, liquid, walls), nodes)
}

/// The same by nodes that may have been used before.
pub(super) fn find_by<const D: usize>(
    nodes: &mut Nodes<D>,
    liquid: &[(Vector<f64, D>, f64)],
    walls: impl Iterator<Item = (Vector<f64, D>, f64)>,
) -> Mesh<D> {
    let (mut of_walls, mut of_liquid) = (Layered::default(), Layered::default());
    of_walls.clear();
    of_liquid.clear();
    let walls: Vec<_> = walls.collect();
    let margin = if walls.is_empty() {
        MARGIN
    } else {
        WALLED_MARGIN
    };
    let places = liquid.iter().map(|(x, _)| *x);
    let mesh = Mesh::around(places, 1.0, 0.0, margin).expect("liquid");
    for (x, volume) in liquid {
        of_liquid.push(*x, [*volume, 0.0]);
    }
    for (x, cosine) in walls.into_iter().filter(|(x, _)| mesh.holds(x)) {
        of_walls.push(x, [1.0, cosine]);
    }
    nodes.find(&mesh, &mut of_liquid, &mut of_walls);
    mesh
}

/// The centres of the cells of a cube of this half width.
pub(super) fn grid<const D: usize>(half: f64, cell: f64) -> impl Iterator<Item = Vector<f64, D>> {
    let along = (2.0 * half / cell) as usize;
    (0..along.pow(D as u32)).map(move |k| {
        Vector(std::array::from_fn(|d| {
            (k / along.pow(d as u32) % along) as f64 * cell + 0.5 * cell - half
        }))
    })
}

/// Four layers of a disc's particles.
fn rings<const D: usize>(wall: f64) -> Vec<Vector<f64, D>> {
    let radii = (0..4).map(|layer| wall - 0.5 - f64::from(layer));
    let ring = |radius: f64| {
        let count = (std::f64::consts::TAU * radius).round();
        (0..count as usize).map(move |k| {
            let (sine, cosine) = (std::f64::consts::TAU * (k as f64 + 0.3) / count).sin_cos();
            let mut x = Vector::ZERO;
            x[0] = radius * sine;
            x[D - 1] = radius * cosine - wall;
            x
        })
    };
    radii.flat_map(ring).collect()
}

/// What cos(phi) may be off: two degrees at 90, four at 30 and 150, about the three that drops on walls are to keep.
const MOST: f64 = 0.035;

/// Mean over places of the mesh's nodes, which a contact line passes by.
fn mean<const D: usize>(drop: Drop, fineness: usize) -> f64 {
    const PLACES: usize = 6;
    let pulls = (0..PLACES).map(|k| {
        // Multiples of irrational numbers fill the cell evenly.
        let turns = [0.618_034, 0.414_214, 0.732_051].map(|turn| (k as f64 * turn).fract());
        drop.pull::<D>(fineness, Vector(std::array::from_fn(|d| turns[d])))
    });
    pulls.sum::<f64>() / PLACES as f64
}

#[test]
fn exact_drops_on_a_plane_and_on_a_disc_stay_as_they_are() {
    let volume = 0.5 * std::f64::consts::PI * 144.0;
    for wall in [None, Some(12.5), Some(18.5)] {
        for degrees in [30.0, 60.0, 90.0, 120.0, 150.0] {
            let drop = Drop {
                volume,
                degrees,
                wall,
            };
            let pull = mean::<2>(drop, 8);
            assert!(pull.abs() < MOST, "{wall:?} {degrees}: {pull}");
        }
    }
}

#[test]
fn exact_drops_on_a_plane_in_three_dimensions_stay_as_they_are() {
    for degrees in [60.0, 90.0, 120.0, 150.0] {
        let drop = Drop {
            volume: 2.0 / 3.0 * std::f64::consts::PI * 512.0,
            degrees,
            wall: None,
        };
        let pull = mean::<3>(drop, 3);
        assert!(pull.abs() < MOST, "{degrees}: {pull}");
    }
}

/// Nodes that found a drop on a wall before find a free one as new ones do, to the bit.
#[test]
fn walls_leave_nothing_behind() {
    let disc: Vec<_> = (grid::<2>(8.0, 1.0).filter(|x| x.norm() < 7.0))
        .map(|x| (x, 1.0))
        .collect();
    let below = |x: &Vector<f64, 2>| (-4.0..0.0).contains(&x[1]);
    let on_wall: Vec<_> = (disc.iter().filter(|(x, _)| x[1] > 0.0)).copied().collect();
    let mut used = Nodes::default();
    find_by(
        &mut used,
        &on_wall,
        grid(20.0, 1.0).filter(below).map(|x| (x, 0.5)),
    );
    find_by(&mut used, &disc, std::iter::empty());
    let (_, new) = found(&disc, std::iter::empty());
    assert_eq!(used.curvature, new.curvature);
}

/// A plate that hangs into a liquid whose particles keep a little more than half a spacing from it: deep in the plate the colour falls as if there
/// were a surface.
#[test]
fn a_plate_that_is_wet_all_over_has_no_contact_line() {
    for more in [0.0, 0.1, 0.15, 0.2] {
        let of_plate = |x: &Vector<f64, 2>| x[0].abs() < 5.0 && x[1] > 0.0;
        let off = |x: Vector<f64, 2>| match x[1] > 0.0 {
            true => x + Vector([more * x[0].signum(), 0.0]),
            false => x - Vector([0.0, more]),
        };
        let liquid: Vec<_> = (grid(30.0, 1.0).filter(|x| !of_plate(x)))
            .map(|x| (off(x), 1.0))
            .collect();
        let plate = grid(30.0, 1.0).filter(of_plate).map(|x| (x, -0.5));
        let (mesh, nodes) = found(&liquid, plate);
        let of_end = |node: &usize| mesh.place(*node).norm() < 12.0;
        let lines = (0..mesh.len())
            .filter(of_end)
            .map(|node| nodes.lines()[node].norm());
        assert!(lines.sum::<f64>() < 1e-12, "{more}");
    }
}
