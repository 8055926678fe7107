//! The neck between two drops that merge, or of a thread that thins.

use crate::vector::Vector;

/// Radius of the cut through a body by a plane, m: that of the disc (in 2D half the strip) with
/// the second moment of the particles within `thickness` / 2 of it. `None` where there are fewer than two.
///
/// The particles stand for their neighbourhood, so in a slab of one spacing of a cubic lattice
/// a disc of eight spacings comes out within 4 % (tested, jittered too).
pub fn waist<const D: usize>(
    position: &[Vector<f64, D>],
    at: Vector<f64, D>,
    normal: Vector<f64, D>,
    thickness: f64,
) -> Option<f64> {
    let unit = normal * (1.0 / normal.norm());
    let across: Vec<Vector<f64, D>> = (position.iter())
        .map(|x| *x - at)
        .filter(|offset| (offset.dot(&unit)).abs() <= 0.5 * thickness)
        .map(|offset| offset - unit * offset.dot(&unit))
        .collect();
    if across.len() < 2 {
        return None;
    }
    let count = across.len() as f64;
    let centre = across.iter().fold(Vector::ZERO, |sum, x| sum + *x) * (1.0 / count);
    let moment: f64 = across.iter().map(|x| (*x - centre).norm_squared()).sum();
    // <r^2> is R^2 (D - 1) / (D + 1).
    let factor = (D as f64 + 1.0) / (D as f64 - 1.0);
    Some((factor * moment / count).sqrt())
}

#[cfg(test)]
mod tests {
    use super::waist;
    use crate::measure::samples::cut;
    use crate::vector::Vector;

    #[test]
    fn a_ball_cut_off_centre_has_the_radius_of_that_circle() {
        for (jitter, height) in [(0.0, 0.0), (0.2, 0.0), (0.2, 6.0)] {
            let centre = Vector([0.3, -0.2, 0.1]);
            let points = cut(12.0, 0.3, jitter, |x| (*x - centre).norm() < 10.0);
            let at = centre + Vector([0.0, 0.0, height]);
            let found = waist(&points, at, Vector([0.0, 0.0, 2.0]), 1.0).unwrap();
            let exact = f64::sqrt(100.0 - height * height);
            // Two hundred points: a quarter of a spacing in eight.
            assert!((found / exact - 1.0).abs() < 0.04, "{found} for {exact}");
        }
    }

    #[test]
    fn nothing_in_the_plane_is_no_waist() {
        let x = [Vector([0.0, 5.0]), Vector([0.0, 6.0])];
        assert_eq!(waist(&x, Vector::ZERO, Vector([0.0, 1.0]), 1.0), None);
    }
}
