//! The stress in a round drop, from the forces between its particles.

use crate::vector::Vector;

/// Pieces that the line between two particles is cut into.
const PIECES: usize = 16;

/// Pressure along the radius and across it, in shells about the centre of a drop.
///
/// By Irving and Kirkwood (1950), J. Chem. Phys. 18, 817: a pair's force acts along the straight
/// line between the two, and a shell of volume V has the share
/// 1/V sum f (e . r)^2 dl of it as pressure along r, with e the direction of the line.
#[derive(Clone, Debug, PartialEq)]
pub struct StressProfile {
    /// Thickness of a shell, m.
    pub width: f64,
    /// Pressure along the radius in each shell from the centre outwards, Pa.
    pub normal: Vec<f64>,
    /// Pressure across it, Pa.
    pub tangential: Vec<f64>,
}

impl StressProfile {
    /// Measures `shells` shells of `width` metres about `centre`; `force(i, j)` is the force
    /// between two particles at rest, N, positive where they repel each other, none beyond `range` metres.
    pub fn measure<const D: usize>(
        positions: &[Vector<f64, D>],
        centre: Vector<f64, D>,
        range: f64,
        width: f64,
        shells: usize,
        force: impl Fn(usize, usize) -> f64,
    ) -> Self {
        let mut normal = vec![0.0; shells];
        let mut tangential = vec![0.0; shells];
        for i in 0..positions.len() {
            for j in 0..i {
                let line = positions[i] - positions[j];
                let square = line.norm_squared();
                if !(square < range * range && square > 0.0) {
                    continue;
                }
                // f dl, in pieces; e e^T is line line^T / square.
                let weight = force(i, j) * square.sqrt() / PIECES as f64;
                for piece in 0..PIECES {
                    let share = (piece as f64 + 0.5) / PIECES as f64;
                    let x = positions[j] + line * share - centre;
                    let r2 = x.norm_squared();
                    let shell = (r2.sqrt() / width) as usize;
                    if shell < shells && r2 > 0.0 {
                        let along = line.dot(&x).powi(2) / (square * r2);
                        normal[shell] += weight * along;
                        tangential[shell] += weight * (1.0 - along) / (D as f64 - 1.0);
                    }
                }
            }
        }
        for k in 0..shells {
            let (inner, outer) = (k as f64 * width, (k + 1) as f64 * width);
            let unit = if D == 2 { 1.0 } else { 4.0 / 3.0 } * std::f64::consts::PI;
            let volume = unit * (outer.powi(D as i32) - inner.powi(D as i32));
            normal[k] /= volume;
            tangential[k] /= volume;
        }
        Self {
            width,
            normal,
            tangential,
        }
    }

    /// Mean pressure along and across the radius out to `radius` metres, Pa.
    pub fn inner_pressure<const D: usize>(&self, radius: f64) -> f64 {
        let (mut sum, mut volume) = (0.0, 0.0);
        let inside = (radius / self.width) as usize;
        for k in 0..inside.min(self.normal.len()) {
            let share = ((k + 1) as f64).powi(D as i32) - (k as f64).powi(D as i32);
            let isotropic = self.normal[k] + self.tangential[k] * (D as f64 - 1.0);
            sum += share * isotropic / D as f64;
            volume += share;
        }
        sum / volume
    }

    /// The surface tension, N/m: the integral of normal less tangential pressure along the radius,
    /// from `from` metres outwards.
    pub fn surface_tension(&self, from: f64) -> f64 {
        let first = (from / self.width) as usize;
        let difference = |k: usize| self.normal[k] - self.tangential[k];
        (first..self.normal.len()).map(difference).sum::<f64>() * self.width
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A ring of 400 particles, each pulled by its two neighbours with 3 N, of 5 m radius.
    #[test]
    fn a_stretched_ring_has_the_tension_of_its_string() {
        let n = 400;
        let ring: Vec<Vector<f64, 2>> = (0..n)
            .map(|k| {
                let (sin, cos) = (std::f64::consts::TAU * f64::from(k) / f64::from(n)).sin_cos();
                Vector([5.0 * cos, 5.0 * sin])
            })
            .collect();
        let found = StressProfile::measure(&ring, Vector::ZERO, 0.1, 0.4, 15, |_, _| -3.0);
        // The ring lies in the middle of a shell. Its chords are shorter than the arc by a part in 10^4.
        assert!((found.surface_tension(0.0) - 3.0).abs() < 1e-2, "{found:?}");
        // Nothing but the string bears it: no pressure inside.
        assert_eq!(found.inner_pressure::<2>(4.0), 0.0);
    }

    /// Springs of 1 N between all neighbours of a square lattice: a pressure f dx / dx^2.
    #[test]
    fn springs_on_a_lattice_have_their_pressure() {
        let lattice: Vec<Vector<f64, 2>> = (-20..=20)
            .flat_map(|i| (-20..=20).map(move |j| Vector([f64::from(i), f64::from(j)]) * 0.5))
            .collect();
        let found = StressProfile::measure(&lattice, Vector::ZERO, 0.6, 0.25, 32, |_, _| 1.0);
        let pressure = found.inner_pressure::<2>(8.0);
        // Lines that are cut by the edge of the shells: pieces of 1/32.
        assert!((pressure / 2.0 - 1.0).abs() < 0.01, "{pressure}");
    }
}
