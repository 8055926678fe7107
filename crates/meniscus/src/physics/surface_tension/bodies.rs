//! The forces on a free body add up to nothing, and neither do their moments. Those of a
//! curvature that is estimated particle by particle do not quite: what is left is taken off as
//! a uniform acceleration and a rotation about the centre of mass. Taken off the surface
//! alone, it would drive a circulation.
//!
//! A body on a plane wall of one contact angle is pulled along it by nothing either: what pulls at
//! its contact line adds up to sigma cos(theta) times the integral of the line's normal
//! in the wall. There the part along the wall is taken off; on other walls, nothing.

use super::matrix::Matrix;
use crate::domain::Domain;
use crate::particles::Particles;
use crate::vector::Vector;

/// Which particles move freely together.
#[derive(Clone, Copy, Debug)]
pub struct Bodies<'a, const D: usize> {
    /// The body of each row, those of none beyond `count`.
    pub of_row: &'a [u32],
    /// Number of bodies.
    pub count: usize,
    /// Periodic axes.
    pub domain: Domain<D>,
}

#[derive(Clone, Copy, Default)]
struct Balance {
    mass: f64,
    moment_of_mass: [f64; 3],
    force: [f64; 3],
    moment: [f64; 3],
    inertia: [[f64; 3]; 3],
    /// Of the unit normals of walls within reach, and their number.
    wall: [f64; 3],
    walled: f64,
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|d| {
        let (e, f) = ((d + 1) % 3, (d + 2) % 3);
        a[e] * b[f] - a[f] * b[e]
    })
}

/// Takes what forces per volume (N/m^3) add up to, and their moments, off each body.
/// `wall` gives the normal of a wall within reach of a row, of any length. Returns the sum of
/// all forces before, N (N/m in 2D).
pub(crate) fn balance<const D: usize>(
    bodies: Bodies<'_, D>,
    particles: &Particles<D>,
    wall: impl Fn(usize) -> Option<Vector<f64, D>>,
    force: &mut [Vector<f64, D>],
) -> Vector<f64, D> {
    let mut balances = vec![Balance::default(); bodies.count];
    let mut net = Vector::ZERO;
    // Where each body is not torn by a periodic face.
    let mut firsts: Vec<Option<Vector<f64, D>>> = vec![None; bodies.count];
    let mut place = |i: usize, body: u32| {
        let x = particles.position[i];
        let Some(first) = firsts.get_mut(body as usize) else {
            return x.to_3d();
        };
        let mut arm = x - *first.get_or_insert(x);
        for (arm, axis) in arm.0.iter_mut().zip(bodies.domain.periodic) {
            if let Some((low, high)) = axis {
                *arm -= (*arm / (high - low)).round() * (high - low);
            }
        }
        arm.to_3d()
    };
    for (i, &body) in bodies.of_row.iter().enumerate() {
        let pull = force[i] * particles.volume(i);
        net += pull;
        if let Some(balance) = balances.get_mut(body as usize) {
            let (x, pull) = (place(i, body), pull.to_3d());
            balance.mass += particles.mass[i];
            for d in 0..3 {
                balance.moment_of_mass[d] += particles.mass[i] * x[d];
                balance.force[d] += pull[d];
            }
            if let Some(normal) = wall(i) {
                let normal = (normal * (1.0 / normal.norm())).to_3d();
                balance.walled += 1.0;
                for (sum, normal) in balance.wall.iter_mut().zip(normal) {
                    *sum += normal;
                }
            }
        }
    }
    let centre = |balance: &Balance| balance.moment_of_mass.map(|moment| moment / balance.mass);
    for (i, &body) in bodies.of_row.iter().enumerate() {
        let Some(balance) = balances.get_mut(body as usize) else {
            continue;
        };
        let (x, middle) = (place(i, body), centre(balance));
        let arm: [f64; 3] = std::array::from_fn(|d| x[d] - middle[d]);
        let moment = cross(arm, (force[i] * particles.volume(i)).to_3d());
        let square: f64 = arm.iter().map(|x| x * x).sum();
        for d in 0..3 {
            balance.moment[d] += moment[d];
            for e in 0..3 {
                let diagonal = if d == e { square } else { 0.0 };
                balance.inertia[d][e] += particles.mass[i] * (diagonal - arm[d] * arm[e]);
            }
        }
    }
    let turns: Vec<[f64; 3]> = balances.iter().map(Balance::turning).collect();
    balances.iter_mut().for_each(Balance::keep_along_wall);
    for (i, &body) in bodies.of_row.iter().enumerate() {
        let Some(balance) = balances.get(body as usize) else {
            continue;
        };
        let (x, middle) = (place(i, body), centre(balance));
        let arm = std::array::from_fn(|d| x[d] - middle[d]);
        let turn = cross(turns[body as usize], arm);
        let acceleration = std::array::from_fn(|d| balance.force[d] / balance.mass + turn[d]);
        force[i] -= Vector::from_3d(acceleration) * particles.density[i];
    }
    net
}

impl Balance {
    /// Leaves of the force what walls allow to take off.
    fn keep_along_wall(&mut self) {
        /// Length of the mean of unit normals of a plane wall, but for the lattice of its particles.
        const PLANE: f64 = 0.999;
        if self.walled == 0.0 {
            return;
        }
        let square: f64 = self.wall.iter().map(|x| x * x).sum();
        if square.sqrt() < PLANE * self.walled {
            self.force = [0.0; 3];
            return;
        }
        let across: f64 = (0..3).map(|d| self.wall[d] * self.force[d]).sum();
        for d in 0..3 {
            self.force[d] -= self.wall[d] * across / square;
        }
    }

    /// Angular acceleration, 1/s^2. Of particles on a line, whose inertia cannot be inverted,
    /// a half.
    fn turning(&self) -> [f64; 3] {
        /// How round the moments of inertia must be, see [`Matrix::inverse`].
        const LEAST: f64 = 1e-3;
        if self.walled > 0.0 {
            return [0.0; 3];
        }
        let inverse = Matrix(self.inertia.map(Vector)).inverse(LEAST);
        inverse.times(&Vector(self.moment)).0
    }
}
