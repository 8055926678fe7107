//! A virtual pressure sensor.

use crate::kernel::Kernel;
use crate::vector::Vector;

/// A point at which a field of the particles is read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sensor<const D: usize> {
    /// Where it sits, m.
    pub position: Vector<f64, D>,
    /// Kernel that weighs the particles around.
    pub kernel: Kernel,
    /// Smoothing length of that kernel, m.
    pub smoothing_length: f64,
}

/// What a sensor shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// The mean of the field over the particles in reach, weighted by V W:
    /// sum V a W / sum V W (Shepard), in the field's unit.
    pub value: f64,
    /// sum V W: about one inside the liquid, one half at a flat surface, towards
    /// zero where the last particle is about to leave the kernel.
    pub filling: f64,
}

impl<const D: usize> Sensor<D> {
    /// Reads one field, such as pressure, of particles with these masses and
    /// densities; `None` where no particle is in reach.
    ///
    /// Being normalised, the value does not fall with the filling: at a free
    /// surface it is that of the particles within. Jancik and Hyhlik (2019), EPJ Web
    /// Conf. 213, 02030.
    pub fn read(
        &self,
        positions: &[Vector<f64, D>],
        masses: &[f64],
        densities: &[f64],
        field: &[f64],
    ) -> Option<Reading> {
        let reach = (self.kernel.support() * self.smoothing_length).powi(2);
        let (mut sum, mut filling) = (0.0, 0.0);
        for (((&x, m), density), a) in positions.iter().zip(masses).zip(densities).zip(field) {
            let r2 = (x - self.position).norm_squared();
            if r2 < reach {
                let weight = m / density * self.kernel.value(r2.sqrt(), self.smoothing_length, D);
                sum += weight * a;
                filling += weight;
            }
        }
        (filling > 0.0).then(|| Reading {
            value: sum / filling,
            filling,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A block of 41 x 41 particles, spacing 1, centred on the origin.
    fn block() -> Vec<Vector<f64, 2>> {
        (-20..=20)
            .flat_map(|i| (-20..=20).map(move |j| Vector([f64::from(i), f64::from(j)])))
            .collect()
    }

    fn sensor(x: f64, y: f64) -> Sensor<2> {
        Sensor {
            position: Vector([x, y]),
            kernel: Kernel::WendlandC2,
            smoothing_length: 2.0,
        }
    }

    #[test]
    fn reads_a_uniform_field_exactly_wherever_a_particle_is_in_reach() {
        let x = block();
        let n = x.len();
        for (place, reach) in [(0.3, true), (20.0, true), (23.9, true), (24.1, false)] {
            let reading = sensor(place, 0.7).read(&x, &vec![3.0; n], &vec![3.0; n], &vec![50.0; n]);
            assert_eq!(reading.is_some(), reach, "at {place}");
            if let Some(reading) = reading {
                // Only the division's rounding.
                assert!((reading.value - 50.0).abs() < 1e-12, "at {place}");
            }
        }
    }

    #[test]
    fn reads_a_linear_field_at_points_of_symmetry_and_tells_how_full_it_is_there() {
        let x = block();
        let n = x.len();
        let field: Vec<f64> = x.iter().map(|x| 2.0 * x[0] - x[1]).collect();
        let inside = sensor(3.5, -4.0)
            .read(&x, &vec![1.0; n], &vec![1.0; n], &field)
            .unwrap();
        assert!((inside.value - 11.0).abs() < 1e-12);
        // A sum over a lattice in place of the integral: better than 1 % at h = 2 spacings.
        assert!((inside.filling - 1.0).abs() < 1e-2);
        // The last row's particles stand for the half spacing beyond them.
        let edge = sensor(20.5, 0.0)
            .read(&x, &vec![1.0; n], &vec![1.0; n], &field)
            .unwrap();
        assert!((edge.filling - 0.5).abs() < 1e-2, "{}", edge.filling);
    }
}
