//! The shape of a liquid's surface beside vertical walls, in two dimensions.
//!
//! With z above the level where the pressure is the surroundings', a the capillary length and
//! psi the angle of slope, Young and Laplace have d psi / ds = z / a^2; so z^2 / 2 a^2 + cos(psi) is
//! the same along the surface. De Gennes, Brochard-Wyart and Quere, Capillarity and
//! Wetting Phenomena, ch. 2; Landau and Lifshitz, Fluid Mechanics, sec. 61.

use std::f64::consts::FRAC_PI_2;

/// How far above the level far away a liquid meets a vertical wall, m; below zero above
/// 90 degrees: +-a sqrt(2 (1 - sin(theta))).
///
/// Contact angle theta in rad, capillary length a in m.
///
/// ```
/// use meniscus::theory::{capillary_length, meniscus_rise};
/// // Water on clean glass climbs 3.9 mm.
/// let a = capillary_length(0.0728, 998.0, 9.81);
/// assert!((meniscus_rise(0.0, a) - 3.857e-3).abs() < 1e-6);
/// // Mercury (140 degrees) stands lower by 1.6 mm.
/// let a = capillary_length(0.485, 13534.0, 9.81);
/// assert!((meniscus_rise(140.0_f64.to_radians(), a) + 1.616e-3).abs() < 1e-6);
/// ```
pub fn meniscus_rise(contact_angle: f64, capillary_length: f64) -> f64 {
    // sqrt(2 (1 - cos(psi))) = 2 sin(psi / 2), with its sign.
    2.0 * capillary_length * (0.5 * (FRAC_PI_2 - contact_angle)).sin()
}

/// Height above the level far away at a distance from a vertical wall, m: z = 2 a sin(psi / 2),
/// where x = a (X(psi) - X(psi_wall)), X(psi) = -ln tan(psi / 4) - 2 cos(psi / 2).
///
/// Distance in m, not below zero; contact angle in rad, capillary length in m.
///
/// ```
/// use meniscus::theory::{meniscus_height, meniscus_rise};
/// let (angle, a) = (0.6, 2.7e-3);
/// assert!((meniscus_height(0.0, angle, a) - meniscus_rise(angle, a)).abs() < 1e-12);
/// // Far away it falls by a factor of e on each capillary length.
/// let (near, far) = (meniscus_height(6.0 * a, angle, a), meniscus_height(7.0 * a, angle, a));
/// assert!((near / far - 1.0_f64.exp()).abs() < 1e-4);
/// ```
pub fn meniscus_height(distance: f64, contact_angle: f64, capillary_length: f64) -> f64 {
    let wall = FRAC_PI_2 - contact_angle;
    let place = |psi: f64| -(0.25 * psi).tan().ln() - 2.0 * (0.5 * psi).cos();
    let wanted = distance / capillary_length + place(wall.abs());
    // place falls from infinity at psi = 0, where its logarithm alone counts: bisection in ln psi.
    let (mut low, mut high) = (-wanted - 1.0, wall.abs().ln());
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if place(middle.exp()) > wanted {
            low = middle;
        } else {
            high = middle;
        }
    }
    2.0 * capillary_length * (0.5 * high.exp()).sin() * wall.signum()
}

/// The surface between two vertical plates that stand in a wide bath.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlateMeniscus {
    /// Distance between the plates, m.
    pub gap: f64,
    /// Contact angle, rad.
    pub contact_angle: f64,
    /// Capillary length, m.
    pub capillary_length: f64,
    /// Height half way between the plates above the level of the bath, m.
    pub centre: f64,
    /// Height at the plates above the level of the bath, m.
    pub wall: f64,
}

impl PlateMeniscus {
    /// The solution of Young and Laplace's equation for this gap and capillary length (m) and
    /// contact angle (rad, 0 to pi), by bisection in the height of the middle. In a closed tank
    /// the same surface stands lower by the [`mean`](Self::mean).
    ///
    /// ```
    /// use meniscus::theory::{PlateMeniscus, meniscus_rise};
    /// let a = 2.7e-3;
    /// // Far apart each plate has a meniscus of its own.
    /// let wide = PlateMeniscus::new(20.0 * a, 0.5, a);
    /// assert!((wide.wall - meniscus_rise(0.5, a)).abs() < 1e-6 * a && wide.centre < 1e-3 * a);
    /// // Close together the surface is an arc, high up.
    /// let narrow = PlateMeniscus::new(0.02 * a, 0.5, a);
    /// assert!((narrow.centre / (2.0 * 0.5_f64.cos() * a / 0.02) - 1.0).abs() < 1e-3);
    /// ```
    pub fn new(gap: f64, contact_angle: f64, capillary_length: f64) -> Self {
        let psi = (FRAC_PI_2 - contact_angle).abs();
        let sign = (FRAC_PI_2 - contact_angle).signum();
        // In capillary lengths; the narrower the higher, and no higher than an arc's mean.
        let half = 0.5 * gap / capillary_length;
        let (mut low, mut high) = (-700.0_f64, (2.0 / half + 2.0).ln());
        for _ in 0..200 {
            let middle = 0.5 * (low + high);
            if half_gap(middle.exp(), psi) > half {
                low = middle;
            } else {
                high = middle;
            }
        }
        let centre = if psi == 0.0 { 0.0 } else { high.exp() };
        Self {
            gap,
            contact_angle,
            capillary_length,
            centre: sign * centre * capillary_length,
            wall: sign * height(centre, psi) * capillary_length,
        }
    }

    /// Mean height between the plates above the level of the bath, m: 2 a^2 cos(theta) / gap,
    /// the weight that the plates carry.
    pub fn mean(&self) -> f64 {
        2.0 * self.capillary_length.powi(2) * self.contact_angle.cos() / self.gap
    }

    /// Height above the level of the bath, m, at a distance from the middle (m, up to half the gap).
    pub fn height(&self, from_middle: f64) -> f64 {
        let wall = (FRAC_PI_2 - self.contact_angle).abs();
        let centre = (self.centre / self.capillary_length).abs();
        if centre == 0.0 {
            return 0.0;
        }
        let wanted = from_middle.abs() / self.capillary_length;
        let (mut low, mut high) = (0.0, wall);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if half_gap(centre, middle) < wanted {
                low = middle;
            } else {
                high = middle;
            }
        }
        self.centre.signum() * height(centre, high) * self.capillary_length
    }
}

/// Height where the slope is psi, of a surface that is level at height `centre`; a = 1.
fn height(centre: f64, psi: f64) -> f64 {
    (2.0 * (0.5 * psi).sin()).hypot(centre)
}

/// How far from its level middle that surface has the slope psi: the integral of
/// cos(psi) / z over psi; a = 1.
fn half_gap(centre: f64, psi: f64) -> f64 {
    // In u, psi = centre sinh(u), the integrand is smooth however low the middle. Simpson's rule.
    let end = (psi / centre).asinh();
    let steps = 200;
    let width = end / f64::from(steps);
    let value = |u: f64| {
        let psi = centre * u.sinh();
        psi.cos() / height(centre, psi) * centre * u.cosh()
    };
    let sum: f64 = (0..steps)
        .map(|i| {
            let u = f64::from(i) * width;
            value(u) + 4.0 * value(u + 0.5 * width) + value(u + width)
        })
        .sum();
    sum * width / 6.0
}

/// How far a liquid rises between plates a distance `width` apart (2D) or in a tube of that
/// diameter (3D), both much narrower than the capillary length a, m: 2 a^2 cos(theta) / width in 2D,
/// 4 a^2 cos(theta) / width in 3D.
///
/// Jurin (1718), Phil. Trans. 30, 739. Contact angle in rad, lengths in m.
///
/// ```
/// use meniscus::theory::{capillary_length, jurin_rise};
/// // Water in a glass tube 1 mm across: 30 mm.
/// let a = capillary_length(0.0728, 998.0, 9.81);
/// assert!((jurin_rise(0.0, a, 1e-3, 3) - 29.74e-3).abs() < 1e-5);
/// assert_eq!(jurin_rise(0.0, a, 1e-3, 2), jurin_rise(0.0, a, 1e-3, 3) / 2.0);
/// ```
pub fn jurin_rise(contact_angle: f64, capillary_length: f64, width: f64, dimension: usize) -> f64 {
    let factor = 2.0 * (dimension as f64 - 1.0);
    factor * capillary_length.powi(2) * contact_angle.cos() / width
}

/// Height, m, of a puddle much wider than the capillary length a, of a liquid that
/// meets its floor at theta: 2 a sin(theta / 2), in two and three dimensions.
///
/// De Gennes, Brochard-Wyart and Quere, sec. 2.2. Contact angle in rad, capillary length in m.
///
/// ```
/// use meniscus::theory::{capillary_length, puddle_height};
/// // Water where it does not wet at all: 5.45 mm.
/// let a = capillary_length(0.0728, 998.0, 9.81);
/// assert!((puddle_height(std::f64::consts::PI, a) - 5.454e-3).abs() < 1e-6);
/// ```
pub fn puddle_height(contact_angle: f64, capillary_length: f64) -> f64 {
    2.0 * capillary_length * (0.5 * contact_angle).sin()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Curvature of a profile z(x) by differences, upwards positive.
    fn curvature(z: impl Fn(f64) -> f64, x: f64, d: f64) -> f64 {
        let slope = (z(x + d) - z(x - d)) / (2.0 * d);
        let bend = (z(x + d) - 2.0 * z(x) + z(x - d)) / (d * d);
        bend / (1.0 + slope * slope).powf(1.5)
    }

    #[test]
    fn curvature_of_the_surface_carries_its_height() {
        let a = 2.0;
        for degrees in [10.0_f64, 60.0, 120.0] {
            let theta = degrees.to_radians();
            let one = |x: f64| meniscus_height(x, theta, a);
            let plates = PlateMeniscus::new(5.0, theta, a);
            for x in [0.2, 0.9, 2.0] {
                // Differences over 1e-3 err by 1e-6 of the curvature.
                let (z, bend) = (one(x), curvature(one, x, 1e-3));
                assert!((bend * a * a / z - 1.0).abs() < 1e-5, "{degrees}, {x}");
                let (z, bend) = (plates.height(x), curvature(|x| plates.height(x), x, 1e-3));
                assert!((bend * a * a / z - 1.0).abs() < 1e-5, "{degrees}, {x}");
            }
        }
    }

    #[test]
    fn surfaces_meet_their_walls_at_the_contact_angle_and_the_walls_carry_what_was_drawn_up() {
        let a = 2.0;
        for degrees in [20.0_f64, 75.0, 140.0] {
            let theta = degrees.to_radians();
            let d = 1e-6;
            let slope = (meniscus_height(0.0, theta, a) - meniscus_height(d, theta, a)) / d;
            assert!(
                (slope * theta.tan() - 1.0).abs() < 1e-4,
                "{degrees}: {slope}"
            );
            let plates = PlateMeniscus::new(5.0, theta, a);
            let slope = (plates.height(2.5) - plates.height(2.5 - d)) / d;
            assert!(
                (slope * theta.tan() - 1.0).abs() < 1e-4,
                "{degrees}: {slope}"
            );
            // The midpoint rule on 100 parts errs by less than 1e-4.
            let n = 100;
            let middles = (0..n).map(|i| 2.5 * (f64::from(i) + 0.5) / f64::from(n));
            let mean = middles.map(|x| plates.height(x)).sum::<f64>() / f64::from(n);
            assert!(
                (mean / plates.mean() - 1.0).abs() < 1e-4,
                "{degrees}: {mean}"
            );
        }
    }

    #[test]
    fn at_a_right_angle_the_surface_is_level() {
        let level = PlateMeniscus::new(1.0, FRAC_PI_2, 1.0);
        assert_eq!(
            (level.centre, level.wall, level.height(0.3)),
            (0.0, 0.0, 0.0)
        );
        assert_eq!(meniscus_height(0.4, FRAC_PI_2, 1.0), 0.0);
    }
}
