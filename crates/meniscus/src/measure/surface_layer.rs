//! How the density of a round drop ends.

use crate::kernel::Kernel;
use crate::vector::Vector;

/// Directions that the density is averaged over.
const DIRECTIONS: usize = 48;
/// Points to a smoothing length along each.
const POINTS: usize = 24;

/// The layer in which the density of a drop in a void falls to nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceLayer {
    /// Where the density is half of that inside, m.
    pub radius: f64,
    /// From 90 to 10 % of the density inside, m.
    pub thickness: f64,
}

impl SurfaceLayer {
    /// Measures the field sum_j m_j W(x - x_j, h_j), averaged over directions from `centre`,
    /// against a density inside (kg/m^3); `None` if it does not fall from 90 to 10 % of that. The
    /// kernel smooths the step of a perfect drop as well: Lucy's makes it 0.78 of its support in 2D.
    pub fn measure<const D: usize>(
        positions: &[Vector<f64, D>],
        masses: &[f64],
        smoothing_length: impl Fn(usize) -> f64,
        kernel: Kernel,
        centre: Vector<f64, D>,
        density: f64,
    ) -> Option<Self> {
        let outermost = (positions.iter())
            .map(|x| (*x - centre).norm())
            .fold(0.0, f64::max);
        let reach = |j: usize| kernel.support() * smoothing_length(j);
        let longest = (0..positions.len()).map(reach).fold(0.0, f64::max);
        let step = longest / kernel.support() / POINTS as f64;
        let begin = (outermost - 3.0 * longest).max(0.0);
        let count = ((outermost + longest - begin) / step).ceil() as usize;
        let mut field = vec![0.0; count];
        for direction in directions::<D>() {
            for (j, &x) in positions.iter().enumerate() {
                // Only the points of the ray within the kernel of j.
                let offset = x - centre;
                let along = offset.dot(&direction);
                let aside = offset.norm_squared() - along * along;
                let half = reach(j).powi(2) - aside;
                if half <= 0.0 {
                    continue;
                }
                let first = ((along - half.sqrt() - begin) / step).ceil().max(0.0) as usize;
                let last = (along + half.sqrt() - begin) / step;
                for (k, value) in field.iter_mut().enumerate().skip(first) {
                    if k as f64 > last {
                        break;
                    }
                    let ahead = begin + k as f64 * step - along;
                    let r = (ahead * ahead + aside).sqrt();
                    *value += masses[j] * kernel.value(r, smoothing_length(j), D);
                }
            }
        }
        // From outside inwards: where the field first reaches a share of the density.
        let reaches = |share: f64| {
            let wanted = share * density * DIRECTIONS as f64;
            let k = (0..count).rev().find(|&k| field[k] >= wanted)?;
            let next = field.get(k + 1)?;
            Some(begin + (k as f64 + (field[k] - wanted) / (field[k] - next)) * step)
        };
        Some(Self {
            radius: reaches(0.5)?,
            thickness: reaches(0.1)? - reaches(0.9)?,
        })
    }
}

/// Directions spread evenly over the circle or the sphere.
fn directions<const D: usize>() -> impl Iterator<Item = Vector<f64, D>> {
    let golden = std::f64::consts::PI * (3.0 - 5.0_f64.sqrt());
    (0..DIRECTIONS).map(move |k| {
        let share = (k as f64 + 0.5) / DIRECTIONS as f64;
        if D == 2 {
            let (sin, cos) = (std::f64::consts::TAU * share).sin_cos();
            return Vector::from_3d([cos, sin, 0.0]);
        }
        let z = 1.0 - 2.0 * share;
        let (sin, cos) = (golden * k as f64).sin_cos();
        let across = (1.0 - z * z).sqrt();
        Vector::from_3d([across * cos, across * sin, z])
    })
}

/// How many rings (shells in three dimensions) of particles stand clear of one another from the
/// surface of a drop inwards, `spacing` (m) being that of its particles: a ring ends where no
/// particle is found for 0.3 spacings inwards, and counts while it is thinner than 0.6.
///
/// ```
/// use meniscus::{Vector, measure::outer_rings};
/// // Three rings about a square heap.
/// let ring = |radius: f64, n: usize| (0..n).map(move |k| {
///     let (sin, cos) = (std::f64::consts::TAU * k as f64 / n as f64).sin_cos();
///     Vector([radius * cos, radius * sin])
/// });
/// let heap = (0..900).map(|k| Vector([(k % 30) as f64 - 14.5, (k / 30) as f64 - 14.5]));
/// let heap = heap.filter(|x| x.norm() < 12.0);
/// let drop: Vec<_> = heap.chain(ring(13.0, 80)).chain(ring(14.0, 86)).chain(ring(15.0, 92)).collect();
/// assert_eq!(outer_rings(&drop, Vector::ZERO, 1.0), 3);
/// ```
pub fn outer_rings<const D: usize>(
    positions: &[Vector<f64, D>],
    centre: Vector<f64, D>,
    spacing: f64,
) -> usize {
    let mut radii: Vec<f64> = positions.iter().map(|x| (*x - centre).norm()).collect();
    radii.sort_by(|a, b| b.total_cmp(a));
    let (mut rings, mut outer) = (0, 0);
    for k in 1..radii.len() {
        if radii[outer] - radii[k - 1] > 0.6 * spacing {
            break;
        }
        if radii[k - 1] - radii[k] > 0.3 * spacing {
            rings += 1;
            outer = k;
        }
    }
    rings
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sharp_disc_is_as_wide_as_its_kernel_makes_it() {
        // On a fine lattice the field is the disc smoothed: half its density at its edge. Across that
        // Lucy's kernel in 2D has a standard deviation of 0.299 h; 2.56 of them, as of a Gaussian, are 0.766 h,
        // a little more since it ends. The lattice's edge is ragged by 0.1.
        let disc: Vec<Vector<f64, 2>> = (-100_i32..=100)
            .flat_map(|i| (-100..=100).map(move |j| Vector([f64::from(i), f64::from(j)]) * 0.1))
            .filter(|x| x.norm() < 9.0)
            .collect();
        let masses = vec![0.01; disc.len()];
        let found = SurfaceLayer::measure(
            &disc,
            &masses,
            |_| 2.0,
            Kernel::LucyQuartic,
            Vector::ZERO,
            1.0,
        )
        .unwrap();
        assert!((found.radius / 9.0 - 1.0).abs() < 0.01, "{found:?}");
        assert!((1.5..1.62).contains(&found.thickness), "{found:?}");
        let none =
            SurfaceLayer::measure::<2>(&[], &[], |_| 2.0, Kernel::LucyQuartic, Vector::ZERO, 1.0);
        assert_eq!(none, None);
    }
}
