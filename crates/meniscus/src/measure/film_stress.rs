//! The stress in a flat film, from the forces between its particles.

use crate::domain::Domain;
use crate::vector::Vector;

/// Pieces that the line between two particles is cut into.
const PIECES: usize = 16;

/// Pressure across a flat film and along it, in layers of equal thickness. The film lies across the last
/// axis, and repeats along the others.
///
/// By Irving and Kirkwood (1950), J. Chem. Phys. 18, 817: a pair's force acts along the straight line
/// between the two, and a layer of volume V has the share 1/V sum f_n dl_n of it as pressure across the
/// film. The integral over all layers is that of Kirkwood and Buff (1949), J. Chem. Phys. 17, 338.
#[derive(Clone, Debug, PartialEq)]
pub struct FilmStress {
    /// Where the lowest layer begins, m.
    pub low: f64,
    /// Thickness of a layer, m.
    pub width: f64,
    /// Pressure across the film in each layer, Pa.
    pub normal: Vec<f64>,
    /// Pressure along it, Pa.
    pub tangential: Vec<f64>,
}

impl FilmStress {
    /// Measures the film of all `positions` in layers of about `width` metres. `force(i, j, x)` is the force
    /// on i, N, that an image of j exerts which i is x metres from; none beyond `range` metres. None
    /// where there is no film, or where an axis along it does not repeat.
    pub fn measure<const D: usize>(
        positions: &[Vector<f64, D>],
        domain: &Domain<D>,
        range: f64,
        width: f64,
        force: impl Fn(usize, usize, Vector<f64, D>) -> Vector<f64, D>,
    ) -> Option<Self> {
        let across = D - 1;
        let mut area = 1.0;
        for axis in &domain.periodic[..across] {
            let (low, high) = (*axis)?;
            area *= high - low;
        }
        let heights = || positions.iter().map(|x| x[across]);
        let low = heights().fold(f64::INFINITY, f64::min);
        let thickness = heights().fold(f64::NEG_INFINITY, f64::max) - low;
        if !(thickness > 0.0 && thickness.is_finite() && width > 0.0) {
            return None;
        }
        let layers = (thickness / width).ceil();
        let width = thickness / layers;
        let mut normal = vec![0.0; layers as usize];
        let mut tangential = normal.clone();
        for i in 0..positions.len() {
            for j in i..positions.len() {
                let apart = positions[i] - positions[j];
                // Two particles have all their images at once, one with itself has each twice.
                let times = if i == j { 0.5 } else { 1.0 };
                if apart[across].abs() >= range {
                    continue;
                }
                domain.for_each_image(apart, range, &mut |line| {
                    let square = line.norm_squared();
                    if !(square < range * range && square > 0.0) {
                        return;
                    }
                    let pull = force(i, j, line);
                    let share = times / (area * width * PIECES as f64);
                    let along_normal = pull[across] * line[across];
                    let along_film = pull.dot(&line) - along_normal;
                    for piece in 0..PIECES {
                        let place = (piece as f64 + 0.5) / PIECES as f64;
                        let height = positions[i][across] - line[across] * place - low;
                        let layer = ((height / width) as usize).min(normal.len() - 1);
                        normal[layer] += share * along_normal;
                        tangential[layer] += share * along_film / across as f64;
                    }
                });
            }
        }
        Some(Self {
            low,
            width,
            normal,
            tangential,
        })
    }

    /// The tension of the whole film, N/m: the integral of normal less tangential pressure. Twice the
    /// surface tension, where both of its surfaces are free.
    pub fn tension(&self) -> f64 {
        let difference = self.normal.iter().zip(&self.tangential);
        difference.map(|(n, t)| n - t).sum::<f64>() * self.width
    }

    /// The integral of tangential pressure with the sign of a tension, N/m: what a force of walls across the film
    /// has no part in.
    pub fn pull_along(&self) -> f64 {
        -self.tangential.iter().sum::<f64>() * self.width
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Springs of 2 N between neighbours on a square lattice of 6 layers, half a metre apart: each of the
    /// layers is a string of 2 N, and what lies between them is pressed, or drawn, by 2 N for half a metre.
    #[test]
    fn a_lattice_of_springs_has_the_tension_of_its_strings() {
        let film: Vec<Vector<f64, 2>> = (0..10)
            .flat_map(|i| (0..6).map(move |j| Vector([f64::from(i), f64::from(j)]) * 0.5))
            .collect();
        let domain = Domain {
            periodic: [Some((0.0, 5.0)), None],
        };
        let spring = |_, _, line: Vector<f64, 2>| line * (-2.0 / line.norm());
        let found = FilmStress::measure(&film, &domain, 0.6, 0.25, spring).expect("a film");
        // 6 strings along; across, 2 N on each half metre in 2.5 m of height.
        assert!((found.pull_along() - 12.0).abs() < 1e-9, "{found:?}");
        assert!((found.tension() - (12.0 - 4.0 * 2.5)).abs() < 1e-9);
        // In equal layers, within the film, the same pressure across.
        for pressure in &found.normal {
            assert!((pressure + 4.0).abs() < 1e-9, "{found:?}");
        }
    }

    /// In space forces that fall off evenly, f = 1 - r, on a simple cubic film: the work that parts two half
    /// spaces of a lattice is what the pairs across the cut bear, (r_n^2 - r_t^2 / 2) / r f each.
    #[test]
    fn any_central_force_adds_up_over_the_pairs() {
        let film: Vec<Vector<f64, 3>> = (0..64)
            .map(|k| Vector([f64::from(k % 4), f64::from(k / 4 % 4), f64::from(k / 16)]) * 0.3)
            .collect();
        let periodic = Some((0.0, 1.2));
        let domain = Domain {
            periodic: [periodic, periodic, None],
        };
        let pull = |_, _, line: Vector<f64, 3>| line * ((line.norm() - 1.0) / line.norm());
        let found = FilmStress::measure(&film, &domain, 1.0, 0.1, pull).expect("a film");
        // Layers l apart, of which there are 4 - l pairs, each with a particle on every 0.3 m by 0.3 m.
        let mut tension = 0.0;
        for l in 0..4_i32 {
            let pairs = if l == 0 { 2.0 } else { f64::from(4 - l) };
            for a in -4..=4_i32 {
                for b in -4..=4_i32 {
                    let (n, t) = (f64::from(l * l) * 0.09, f64::from(a * a + b * b) * 0.09);
                    let r = (n + t).sqrt();
                    if r > 0.0 && r < 1.0 {
                        tension += pairs * (r - 1.0) * (n - 0.5 * t) / r / 0.09;
                    }
                }
            }
        }
        assert!((found.tension() / tension - 1.0).abs() < 1e-9, "{found:?}");
    }
}
