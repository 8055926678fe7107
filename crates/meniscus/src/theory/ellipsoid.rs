//! Boundaries of ellipses and ellipsoids, and the circle or sphere of a volume.

use std::f64::consts::PI;

/// Radius, m, of the circle of this area (2D, m^2) or the sphere of this volume (3D, m^3).
///
/// ```
/// use meniscus::theory::equivalent_radius;
/// assert!((equivalent_radius(std::f64::consts::PI * 9.0, 2) - 3.0).abs() < 1e-15);
/// assert!((equivalent_radius(36.0 * std::f64::consts::PI, 3) - 3.0).abs() < 1e-15);
/// ```
pub fn equivalent_radius(volume: f64, dimension: usize) -> f64 {
    if dimension == 2 {
        (volume / PI).sqrt()
    } else {
        (volume * 0.75 / PI).cbrt()
    }
}

/// Perimeter of the ellipse with semi-axes `a` and `b`, in their unit.
///
/// By the arithmetic-geometric mean: 2 pi (a^2 - sum 2^(n-1) c_n^2) / M(a, b) with
/// c_0^2 = a^2 - b^2 and c_(n+1) = (a_n - b_n) / 2. Abramowitz and Stegun, 17.6.
/// Relative error a few times 1e-16.
///
/// ```
/// use meniscus::theory::ellipse_perimeter;
/// assert!((ellipse_perimeter(2.0, 1.0) - 9.688_448_220_547_675).abs() < 1e-14);
/// // Flattened to a line, there and back.
/// assert_eq!(ellipse_perimeter(0.0, 3.0), 12.0);
/// ```
pub fn ellipse_perimeter(a: f64, b: f64) -> f64 {
    let (mut a, mut b) = (a.max(b), a.min(b));
    // Thinner than this, the perimeter is 4 a to rounding, and the mean tends to zero.
    if b <= a * 1e-9 {
        return 4.0 * a;
    }
    let mut sum = a * a - 0.5 * (a * a - b * b);
    let mut power = 1.0;
    // Convergence is quadratic; the bound only keeps NaN from looping for ever.
    for _ in 0..16 {
        let c = 0.5 * (a - b);
        sum -= power * c * c;
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
        power *= 2.0;
    }
    2.0 * PI * sum / a
}

/// Area of the ellipsoid with these semi-axes, in the square of their unit.
///
/// 4 pi R_G(a^2 b^2, a^2 c^2, b^2 c^2), with Carlson's symmetric integral R_G
/// found from R_F and R_D by duplication. Carlson (1995), Numer. Algorithms 10, 13;
/// DLMF 19.33.1, 19.21.10, 19.36. Relative error about 1e-14 for axes within a
/// factor of 1e4; every axis must be above zero.
///
/// ```
/// use meniscus::theory::ellipsoid_area;
/// assert!((ellipsoid_area(1.0, 2.0, 3.0) - 48.882_146_302_5).abs() < 1e-9);
/// ```
pub fn ellipsoid_area(a: f64, b: f64, c: f64) -> f64 {
    let scale = a.max(b).max(c);
    let squares = [a, b, c].map(|axis| (axis / scale).powi(2));
    let mut arguments = [
        squares[0] * squares[1],
        squares[0] * squares[2],
        squares[1] * squares[2],
    ];
    arguments.sort_by(f64::total_cmp);
    // With the middle one last, every term of the sum is positive.
    let [x, z, y] = arguments;
    let (first, second) = carlson_f_and_d(x, y, z);
    let twice = z * first - (x - z) * (y - z) * second / 3.0 + (x * y / z).sqrt();
    2.0 * PI * twice * scale * scale
}

/// Carlson's R_F(x, y, z) and R_D(x, y, z), by duplication until the arguments agree to 1e-4.
fn carlson_f_and_d(mut x: f64, mut y: f64, mut z: f64) -> (f64, f64) {
    let (mut tail, mut power) = (0.0, 1.0);
    // Each turn brings the arguments four times nearer to each other.
    for _ in 0..40 {
        let mean = (x + y + z) / 3.0;
        if (x - mean).abs().max((y - mean).abs()).max((z - mean).abs()) < 1e-4 * mean {
            break;
        }
        let lambda = (x * y).sqrt() + (x * z).sqrt() + (y * z).sqrt();
        tail += power / (z.sqrt() * (z + lambda));
        power *= 0.25;
        (x, y, z) = (
            0.25 * (x + lambda),
            0.25 * (y + lambda),
            0.25 * (z + lambda),
        );
    }
    let mean = (x + y + z) / 3.0;
    let (dx, dy) = (1.0 - x / mean, 1.0 - y / mean);
    let dz = -dx - dy;
    let (e2, e3) = (dx * dy - dz * dz, dx * dy * dz);
    let first = (1.0 - e2 / 10.0 + e3 / 14.0 + e2 * e2 / 24.0) / mean.sqrt();

    let mean = (x + y + 3.0 * z) / 5.0;
    let (dx, dy) = (1.0 - x / mean, 1.0 - y / mean);
    let dz = -(dx + dy) / 3.0;
    let e2 = dx * dy - 6.0 * dz * dz;
    let e3 = (3.0 * dx * dy - 8.0 * dz * dz) * dz;
    let e4 = 3.0 * (dx * dy - dz * dz) * dz * dz;
    let series = 1.0 - 3.0 * e2 / 14.0 + e3 / 6.0 + 9.0 * e2 * e2 / 88.0 - 3.0 * e4 / 22.0;
    (first, 3.0 * tail + power * series / (mean * mean.sqrt()))
}

#[cfg(test)]
mod tests {
    use super::{ellipse_perimeter, ellipsoid_area};
    use std::f64::consts::PI;

    #[test]
    fn perimeter_agrees_with_a_walk_around() {
        // The trapezium rule converges geometrically on a periodic integrand.
        for (a, b) in [(1.0_f64, 1.0_f64), (1.25, 1.0), (0.3, 2.0), (1.0, 0.05)] {
            let n = 4000;
            let walk: f64 = (0..n)
                .map(|i| {
                    let (sin, cos) = (2.0 * PI * f64::from(i) / f64::from(n)).sin_cos();
                    (a * sin).hypot(b * cos) * 2.0 * PI / f64::from(n)
                })
                .sum();
            assert!(
                (ellipse_perimeter(a, b) / walk - 1.0).abs() < 1e-13,
                "{a}, {b}"
            );
        }
    }

    #[test]
    fn area_of_spheroids_and_scaling() {
        assert!((ellipsoid_area(2.0, 2.0, 2.0) / (16.0 * PI) - 1.0).abs() < 1e-14);
        // Prolate, a = 1, c = 2: 2 pi (1 + 2 asin(e) / e), e^2 = 3/4.
        let e = 0.75_f64.sqrt();
        let prolate = 2.0 * PI * (1.0 + 2.0 * e.asin() / e);
        // Oblate, a = 2, c = 1: 2 pi (4 + atanh(e) / e).
        let oblate = 2.0 * PI * (4.0 + e.atanh() / e);
        for order in [[0, 1, 2], [1, 2, 0], [2, 0, 1]] {
            let pick =
                |axes: [f64; 3]| ellipsoid_area(axes[order[0]], axes[order[1]], axes[order[2]]);
            assert!((pick([1.0, 1.0, 2.0]) / prolate - 1.0).abs() < 1e-14);
            assert!((pick([2.0, 2.0, 1.0]) / oblate - 1.0).abs() < 1e-14);
            assert!((pick([2e-3, 2e-3, 1e-3]) / (oblate * 1e-6) - 1.0).abs() < 1e-14);
        }
    }
}
