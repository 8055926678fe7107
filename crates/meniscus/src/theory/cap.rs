//! The shape of a small drop at rest on a flat wall: a cap of a circle or sphere.

use std::f64::consts::PI;

/// A circular segment (2D) or spherical cap (3D). Lengths in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cap {
    /// Radius of the circle or sphere that it is cut from.
    pub curvature_radius: f64,
    /// Radius of the wetted base: half of the width in 2D.
    pub base_radius: f64,
    /// Height above the wall.
    pub height: f64,
}

impl Cap {
    /// The cap of this volume (m^3; m^2 in 2D) that meets the wall under this
    /// contact angle (rad, above 0, up to pi), gravity being weak.
    ///
    /// With radius of curvature R: base R sin(theta), height R (1 - cos(theta)),
    /// area R^2 (theta - sin(theta) cos(theta)) in 2D, volume
    /// pi R^3 (2 + cos(theta)) (1 - cos(theta))^2 / 3 in 3D.
    /// De Gennes, Brochard-Wyart and Quere, Capillarity and Wetting Phenomena, ch. 2.
    ///
    /// ```
    /// use meniscus::theory::Cap;
    /// use std::f64::consts::{FRAC_PI_2, PI};
    /// // At 90 degrees a hemisphere, at 180 the whole sphere standing on a point.
    /// let half = Cap::of_volume(2.0 * PI / 3.0, FRAC_PI_2, 3);
    /// assert!((half.base_radius - 1.0).abs() < 1e-15 && (half.height - 1.0).abs() < 1e-15);
    /// let whole = Cap::of_volume(4.0 * PI / 3.0, PI, 3);
    /// assert!(whole.base_radius < 1e-15 && (whole.height - 2.0).abs() < 1e-15);
    /// ```
    pub fn of_volume(volume: f64, contact_angle: f64, dimension: usize) -> Cap {
        let (sin, cos) = contact_angle.sin_cos();
        let curvature_radius = if dimension == 2 {
            (volume / (contact_angle - sin * cos)).sqrt()
        } else {
            (3.0 * volume / (PI * (2.0 + cos) * (1.0 - cos).powi(2))).cbrt()
        };
        Cap {
            curvature_radius,
            base_radius: curvature_radius * sin,
            height: curvature_radius * (1.0 - cos),
        }
    }

    /// The cap with this base radius, m, and contact angle (rad, above 0, below pi).
    pub fn of_base(base_radius: f64, contact_angle: f64) -> Cap {
        let curvature_radius = base_radius / contact_angle.sin();
        Cap {
            curvature_radius,
            base_radius,
            height: base_radius * (0.5 * contact_angle).tan(),
        }
    }

    /// Its volume, m^3; in 2D its area, m^2: with height h and base radius b,
    /// pi h (3 b^2 + h^2) / 6 in 3D; in 2D that of the sector less that of the triangle.
    ///
    /// ```
    /// use meniscus::theory::Cap;
    /// // Half a ball, and half a disc.
    /// let half = Cap::of_base(1.0, std::f64::consts::FRAC_PI_2);
    /// assert!((half.volume(3) - 2.0 / 3.0 * std::f64::consts::PI).abs() < 1e-14);
    /// assert!((half.volume(2) - std::f64::consts::FRAC_PI_2).abs() < 1e-14);
    /// ```
    pub fn volume(&self, dimension: usize) -> f64 {
        let (h, b) = (self.height, self.base_radius);
        if dimension == 2 {
            let angle = contact_angle(h, b);
            self.curvature_radius.powi(2) * angle - b * (self.curvature_radius - h)
        } else {
            PI * h * (3.0 * b * b + h * h) / 6.0
        }
    }
}

/// Contact angle, rad, of a cap of this height and base radius (any one unit):
/// tan(theta / 2) = height / base.
///
/// ```
/// use std::f64::consts::PI;
/// // A unit circle cut half way up its upper radius meets the cut at 60 degrees.
/// let theta = meniscus::theory::contact_angle(1.0 - 0.5, 3.0_f64.sqrt() / 2.0);
/// assert!((theta - PI / 3.0).abs() < 1e-15);
/// ```
pub fn contact_angle(height: f64, base_radius: f64) -> f64 {
    2.0 * height.atan2(base_radius)
}

#[cfg(test)]
mod tests {
    use super::{Cap, contact_angle};

    #[test]
    fn volume_agrees_with_slices_of_the_circle_and_its_angle_comes_back() {
        // Midpoint rule over n slices across a square-root end: error below n^-1.5.
        let n = 100_000;
        for dimension in [2, 3] {
            for degrees in [20.0_f64, 90.0, 150.0] {
                let theta = degrees.to_radians();
                let cap = Cap::of_volume(7.0, theta, dimension);
                let wall = cap.curvature_radius - cap.height;
                let volume: f64 = (0..n)
                    .map(|i| {
                        let y = wall + (f64::from(i) + 0.5) * cap.height / f64::from(n);
                        let half_square = cap.curvature_radius.powi(2) - y * y;
                        let slice = if dimension == 2 {
                            2.0 * half_square.sqrt()
                        } else {
                            std::f64::consts::PI * half_square
                        };
                        slice * cap.height / f64::from(n)
                    })
                    .sum();
                assert!(
                    (volume - 7.0).abs() < 1e-6,
                    "{dimension}D, {degrees} degrees: {volume}"
                );
                assert!((contact_angle(cap.height, cap.base_radius) - theta).abs() < 1e-12);
                let same = Cap::of_base(cap.base_radius, theta);
                assert!((same.volume(dimension) - 7.0).abs() < 1e-11);
                assert!((same.height - cap.height).abs() < 1e-12);
            }
        }
    }
}
