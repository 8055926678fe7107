//! What forces add up to, and that they know no place.

use meniscus::measure::{angular_momentum, centre_of_mass, linear_momentum};
use meniscus::rates::{Dimension, Space};
use meniscus::{Domain, Simulation, Vector};

use crate::common::ten_steps;
use crate::liquid;

/// Of some hundred particles' sums.
const ROUNDING: f64 = 1e-12;

fn conserves<const D: usize>(radius: f64)
where
    Space: Dimension<D>,
{
    let mut offset = Vector::ZERO;
    offset[0] = 3.0 * radius + 12.0;
    // Two drops that know nothing of each other, and one that is all spray.
    let setup = liquid::<D>(offset[0] + radius, 0.3, 0.0, |x| {
        let apart = (x - offset).norm();
        x.norm() < radius || (apart < radius && x[1] > -0.3 * radius)
    });
    let mut simulation = Simulation::new(setup).expect("a sound setup");
    let (forces, torques) = ten_steps(&mut simulation);
    let p = simulation.particles();
    for near in [true, false] {
        let rows: Vec<usize> = (0..p.len())
            .filter(|&i| (p.position[i][0] < 0.5 * offset[0]) == near)
            .collect();
        let of =
            |column: &[Vector<f64, D>]| -> Vec<_> { rows.iter().map(|&i| column[i]).collect() };
        let (x, v) = (of(&p.position), of(&p.velocity));
        let mass = vec![1.0; rows.len()];
        let linear = linear_momentum(&v, &mass).norm();
        let middle = centre_of_mass(&x, &mass).expect("particles");
        let angular = Vector(angular_momentum(&x, &v, &mass, middle)).norm();
        assert!(linear < ROUNDING * forces, "{D}D: {linear:e} of {forces}");
        assert!(
            angular < ROUNDING * torques,
            "{D}D: {angular:e} of {torques}"
        );
    }
}

#[test]
fn each_body_keeps_its_momentum() {
    conserves::<2>(7.0);
    conserves::<3>(4.0);
}

/// A drop across a periodic face, moved by whole spacings as the mesh is, feels what it does elsewhere.
#[test]
fn a_periodic_face_is_no_place() {
    let acceleration = |shift: f64| {
        let mut setup = liquid::<2>(6.0, 0.2, 0.0, |x| x.norm() < 6.0);
        setup.domain = Domain {
            periodic: [Some((-20.0, 20.0)), None],
        };
        for particle in &mut setup.particles {
            particle.position[0] += shift;
            if particle.position[0] >= 20.0 {
                particle.position[0] -= 40.0;
            }
        }
        let simulation = Simulation::new(setup).expect("a sound setup");
        let p = simulation.particles();
        let mut by_id = vec![Vector::ZERO; p.len()];
        for (id, a) in p.id.iter().zip(&p.acceleration) {
            by_id[*id as usize] = *a;
        }
        by_id
    };
    let (middle, face) = (acceleration(0.0), acceleration(18.0));
    let largest = middle.iter().map(Vector::norm).fold(0.0, f64::max);
    for (a, b) in middle.iter().zip(&face) {
        assert!((*a - *b).norm() < 1e-11 * largest, "{a:?}, {b:?}");
    }
}
