//! Which particles lie at a free surface.

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_4};

use super::base::Base;
use crate::cells::Cells;
use crate::vector::Vector;

/// How far neighbours are looked for, in spacings: no distance of a lattice.
const REACH: f64 = 2.1;
/// Cosine of the half angle of the cone that holds no neighbour: 45 degrees.
const CONE: f64 = FRAC_1_SQRT_2;
/// How near a wall in the cone hides a void between, in spacings.
const WET: f64 = 1.5;

/// Indices of the particles, `spacing` (m) apart, that see out of the liquid: no neighbour
/// within 2.1 spacings lies in a cone of 45 degrees about the direction away from all
/// of them. Particles along the walls see their mirror images, so that only a free surface counts.
///
/// It is one layer thick; the surface lies about half a spacing outside. After Marrone, Colagrossi,
/// Le Touze and Graziani (2010), J. Comput. Phys. 229, 3652, sec. 2.
pub fn surface_particles<const D: usize>(
    positions: &[Vector<f64, D>],
    spacing: f64,
    walls: &[Base<D>],
) -> Vec<usize> {
    let reach = REACH * spacing;
    let mut seen = positions.to_vec();
    for wall in walls {
        let near = seen.iter().map(|&x| (x, wall.height(x)));
        let images: Vec<_> = near
            .filter(|(_, height)| height.abs() < reach)
            .map(|(x, height)| x - wall.normal(x) * (2.0 * height))
            .collect();
        seen.extend(images);
    }
    let mut cells = Cells::new(reach);
    for (i, &x) in seen.iter().enumerate() {
        cells.add(i, x);
    }
    let mut arms = Vec::new();
    let sees_out = |i: &usize| {
        let x = positions[*i];
        arms.clear();
        cells.near(&x, |_, y| {
            let arm = y - x;
            let distance = arm.norm();
            if distance > 0.0 {
                arms.push((arm, distance));
            }
        });
        let mut away = Vector::ZERO;
        for &(arm, distance) in &arms {
            away -= arm * ((1.0 - distance / reach) / distance);
        }
        let length = away.norm();
        let wet = walls.iter().any(|wall| {
            // Between the cone's edge and the way to the wall.
            let past = (-away.dot(&wall.normal(x)) / length)
                .clamp(-1.0, 1.0)
                .acos()
                - FRAC_PI_4;
            wall.height(x) < WET * spacing * past.max(0.0).cos()
        });
        !wet && (arms.iter()).all(|(arm, distance)| arm.dot(&away) <= CONE * distance * length)
    };
    (0..positions.len()).filter(sees_out).collect()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;
    use crate::measure::base::Plane;
    use crate::measure::samples::cut;

    #[test]
    fn the_outermost_layer_is_found_at_any_angle_of_the_lattice_and_no_wall_counts() {
        for (turn, jitter) in [(0.0, 0.0), (0.4, 0.0), (0.0, 0.2), (1.1, 0.2)] {
            // Half a disc and half a ball on a floor.
            let floor = Base::Plane(Plane::new(Vector::ZERO, Vector([0.0, 1.0])).unwrap());
            let x = cut(12.0, turn, jitter, |x: &Vector<f64, 2>| {
                x.norm() < 12.0 && x[1] > 0.0
            });
            let found = surface_particles(&x, 1.0, &[floor]);
            let deep = found.iter().filter(|&&i| x[i].norm() < 10.4).count();
            assert_eq!(deep, 0, "{turn}, {jitter}");
            // About one to each spacing of the arc, and none missing where it lies outermost.
            assert!(
                (found.len() as f64 / (12.0 * PI) - 1.0).abs() < 0.2,
                "{}",
                found.len()
            );
            assert!(
                (0..x.len()).all(|i| x[i].norm() < 11.6 || x[i][1] < 1.5 || found.contains(&i))
            );

            let floor = Base::Plane(Plane::new(Vector::ZERO, Vector([0.0, 0.0, 1.0])).unwrap());
            let x = cut(8.0, turn, jitter, |x: &Vector<f64, 3>| {
                x.norm() < 8.0 && x[2] > 0.0
            });
            let found = surface_particles(&x, 1.0, &[floor]);
            assert!(found.iter().all(|&i| x[i].norm() > 6.2), "{turn}, {jitter}");
            // Those are on a smaller sphere, and the lowest two layers may count as wet.
            let per_square = found.len() as f64 / (2.0 * PI * 64.0);
            assert!((0.6..1.1).contains(&per_square), "{per_square}");
        }
    }
}
