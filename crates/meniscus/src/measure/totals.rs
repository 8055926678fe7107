//! Sums and extremes over all particles.

use crate::vector::Vector;

/// Centre of mass, m; `None` without mass.
pub fn centre_of_mass<const D: usize>(
    positions: &[Vector<f64, D>],
    masses: &[f64],
) -> Option<Vector<f64, D>> {
    // About the first particle, so that a body far from the origin loses no digits.
    let origin = *positions.first()?;
    let (mut sum, mut mass) = (Vector::ZERO, 0.0);
    for (&x, &m) in positions.iter().zip(masses) {
        sum += (x - origin) * m;
        mass += m;
    }
    (mass > 0.0).then(|| origin + sum * (1.0 / mass))
}

/// Linear momentum, kg m/s: the sum of m v. Velocities in m/s.
pub fn linear_momentum<const D: usize>(
    velocities: &[Vector<f64, D>],
    masses: &[f64],
) -> Vector<f64, D> {
    let mut sum = Vector::ZERO;
    for (&v, &m) in velocities.iter().zip(masses) {
        sum += v * m;
    }
    sum
}

/// Angular momentum about a point, kg m^2/s: the sum of m (x - point) x v. Velocities
/// in m/s. In 2D only the last component, along the normal of the plane, is not zero.
pub fn angular_momentum<const D: usize>(
    positions: &[Vector<f64, D>],
    velocities: &[Vector<f64, D>],
    masses: &[f64],
    point: Vector<f64, D>,
) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for ((&x, v), &m) in positions.iter().zip(velocities).zip(masses) {
        let (r, v) = ((x - point).to_3d(), v.to_3d());
        for (d, component) in sum.iter_mut().enumerate() {
            let (e, f) = ((d + 1) % 3, (d + 2) % 3);
            *component += m * (r[e] * v[f] - r[f] * v[e]);
        }
    }
    sum
}

/// Kinetic energy, J: the sum of m v^2 / 2. Velocities in m/s.
pub fn kinetic_energy<const D: usize>(velocities: &[Vector<f64, D>], masses: &[f64]) -> f64 {
    velocities
        .iter()
        .zip(masses)
        .map(|(v, m)| 0.5 * m * v.norm_squared())
        .sum()
}

/// Largest speed, m/s; zero without particles.
pub fn maximum_speed<const D: usize>(velocities: &[Vector<f64, D>]) -> f64 {
    velocities
        .iter()
        .map(Vector::norm_squared)
        .fold(0.0, f64::max)
        .sqrt()
}

/// Least and greatest of a column, such as density; `None` if it is empty.
pub fn range(column: &[f64]) -> Option<(f64, f64)> {
    let first = *column.first()?;
    Some(column.iter().fold((first, first), |(low, high), &value| {
        (low.min(value), high.max(value))
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The corners of a square (a cube) of side 2 about `centre`, turning about its
    /// third axis once in 2 pi seconds while drifting.
    fn spinning<const D: usize>(
        centre: Vector<f64, D>,
        drift: Vector<f64, D>,
    ) -> (Vec<Vector<f64, D>>, Vec<Vector<f64, D>>, Vec<f64>) {
        let mut columns = (vec![], vec![], vec![]);
        for corner in 0..1 << D {
            let arm = Vector(std::array::from_fn(|d| {
                if corner >> d & 1 == 1 { 1.0 } else { -1.0 }
            }));
            let mut spin = Vector::ZERO;
            (spin[0], spin[1]) = (-arm[1], arm[0]);
            columns.0.push(centre + arm);
            columns.1.push(drift + spin);
            columns.2.push(0.5);
        }
        columns
    }

    #[test]
    fn a_spinning_drifting_body() {
        // Four masses of 0.5 at distance sqrt(2) from the axis: inertia 4, spin 1.
        let centre = Vector([1e3, -2e3]);
        let (x, v, m) = spinning(centre, Vector([3.0, 0.0]));
        assert_eq!(centre_of_mass(&x, &m), Some(centre));
        assert_eq!(linear_momentum(&v, &m), Vector([6.0, 0.0]));
        assert_eq!(angular_momentum(&x, &v, &m, centre), [0.0, 0.0, 4.0]);
        // Koenig: about another point the drift of the whole mass is added.
        let below = centre - Vector([0.0, 7.0]);
        assert_eq!(
            angular_momentum(&x, &v, &m, below),
            [0.0, 0.0, 4.0 - 7.0 * 6.0]
        );
        assert_eq!(kinetic_energy(&v, &m), 0.5 * 2.0 * 9.0 + 0.5 * 4.0);
        // The fastest corner moves with (3 + 1, +-1).
        assert!((maximum_speed(&v) - 17.0_f64.sqrt()).abs() < 1e-15);

        let centre = Vector([0.0, 0.0, 5.0]);
        let (x, v, m) = spinning(centre, Vector([0.0, 0.0, -1.0]));
        assert_eq!(centre_of_mass(&x, &m), Some(centre));
        assert_eq!(angular_momentum(&x, &v, &m, Vector::ZERO), [0.0, 0.0, 8.0]);
        assert_eq!(kinetic_energy(&v, &m), 0.5 * 4.0 + 0.5 * 8.0);
    }

    #[test]
    fn nothing_is_measured_of_nothing() {
        let none: &[Vector<f64, 3>] = &[];
        assert_eq!(centre_of_mass(none, &[]), None);
        assert_eq!(centre_of_mass(&[Vector([1.0, 2.0])], &[0.0]), None);
        assert_eq!(maximum_speed(none), 0.0);
        assert_eq!(range(&[]), None);
        assert_eq!(range(&[2.0, -1.0, 3.0]), Some((-1.0, 3.0)));
    }
}
