//! A drop at rest on a flat plate that its weight flattens.

use std::f64::consts::PI;

/// Steps along the profile; the error of the classical Runge-Kutta rule falls with their fourth power.
const STEPS: usize = 400;

/// A drop that sits on a plate, in two dimensions (per metre) or round, in three. Lengths in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SessileDrop {
    /// Radius of the wetted base: half of the width in 2D.
    pub base_radius: f64,
    /// Height above the plate.
    pub height: f64,
    /// (D - 1) / R at the top, 1/m: the pressure there over sigma.
    pub top_curvature: f64,
    /// Angle at which the plate is met by the circle or sphere through its surface, rad: of least squares (algebraic) over all
    /// of it, what one finds who takes the drop for a cap.
    pub circle_angle: f64,
    /// Radius of the base of that circle or sphere, m; NaN where it does not meet the plate.
    pub circle_base_radius: f64,
}

impl SessileDrop {
    /// The solution of Young and Laplace's equation (Bashforth and Adams 1883) for a volume (m^3; m^2 in
    /// 2D), a contact angle (rad, above 0, up to pi) and a capillary length (m; infinite without weight), by
    /// bisection in the curvature of the top. From there, with z the depth below it and psi the slope,
    /// d psi / ds = kappa_0 + z / a^2 - sin(psi) / r, the last term in 3D alone. For drops up to some
    /// capillary lengths wide; larger ones are puddles.
    ///
    /// ```
    /// use meniscus::theory::{Cap, SessileDrop};
    /// // Two microlitres of water at 60 degrees: a tenth lower than without weight.
    /// let (angle, a) = (60.0_f64.to_radians(), 2.727e-3);
    /// let (drop, cap) = (SessileDrop::of_volume(2e-9, angle, a, 3), Cap::of_volume(2e-9, angle, 3));
    /// assert!(drop.height / cap.height > 0.9 && drop.height < cap.height);
    /// ```
    pub fn of_volume(
        volume: f64,
        contact_angle: f64,
        capillary_length: f64,
        dimension: usize,
    ) -> Self {
        let size = volume.powf(1.0 / dimension as f64);
        // The flatter the top, the larger the drop.
        let (mut flat, mut sharp) = (-40.0_f64, 10.0_f64);
        for _ in 0..100 {
            let middle = 0.5 * (flat + sharp);
            let curvature = middle.exp() / size;
            let (_, found) = descend(curvature, contact_angle, capillary_length, dimension);
            if found > volume {
                flat = middle;
            } else {
                sharp = middle;
            }
        }
        descend(
            sharp.exp() / size,
            contact_angle,
            capillary_length,
            dimension,
        )
        .0
    }
}

/// The drop whose top has this curvature, and its volume.
fn descend(curvature: f64, angle: f64, length: f64, dimension: usize) -> (SessileDrop, f64) {
    let weight = 1.0 / (length * length);
    let solid = dimension == 3;
    // r, z and volume, each by psi.
    let slope = |psi: f64, [r, z, _]: [f64; 3]| {
        let around = match solid {
            true if r > 0.0 => psi.sin() / r,
            true => 0.5 * curvature,
            false => 0.0,
        };
        let bend = curvature + z * weight - around;
        let (sin, cos) = psi.sin_cos();
        let area = if solid { PI * r * r } else { 2.0 * r };
        [cos / bend, sin / bend, area * sin / bend]
    };
    let step = angle / STEPS as f64;
    let mut y = [0.0; 3];
    let mut circle = Circle::default();
    for k in 0..STEPS {
        let psi = step * k as f64;
        let ahead = |by: [f64; 3], share: f64| [0, 1, 2].map(|d| y[d] + share * step * by[d]);
        let a = slope(psi, y);
        let b = slope(psi + 0.5 * step, ahead(a, 0.5));
        let c = slope(psi + 0.5 * step, ahead(b, 0.5));
        let d = slope(psi + step, ahead(c, 1.0));
        let [r, z] = [0, 1].map(|i| y[i] + 0.25 * step * (a[i] + b[i]));
        let length = step * b[0].hypot(b[1]);
        circle.add(r, z, if solid { r * length } else { length });
        y = [0, 1, 2].map(|i| y[i] + step / 6.0 * (a[i] + 2.0 * (b[i] + c[i]) + d[i]));
    }
    let [base_radius, height, volume] = y;
    let (depth, radius) = circle.fitted();
    let drop = SessileDrop {
        circle_angle: ((depth - height) / radius).clamp(-1.0, 1.0).acos(),
        circle_base_radius: (radius.powi(2) - (depth - height).powi(2)).sqrt(),
        base_radius,
        height,
        top_curvature: curvature,
    };
    (drop, volume)
}

/// Sums over a surface, to the circle about its axis with the least squares of r^2 + z^2 - 2 z z_c - (R^2 - z_c^2).
#[derive(Default)]
struct Circle {
    weight: f64,
    z: f64,
    zz: f64,
    square: f64,
    square_z: f64,
}

impl Circle {
    fn add(&mut self, r: f64, z: f64, weight: f64) {
        let square = r * r + z * z;
        self.weight += weight;
        self.z += weight * z;
        self.zz += weight * z * z;
        self.square += weight * square;
        self.square_z += weight * square * z;
    }

    /// z_c and R.
    fn fitted(&self) -> (f64, f64) {
        let [z, zz, square, square_z] =
            [self.z, self.zz, self.square, self.square_z].map(|sum| sum / self.weight);
        let centre = 0.5 * (square_z - square * z) / (zz - z * z);
        let rest = square - 2.0 * centre * z;
        (centre, (rest + centre * centre).sqrt())
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::SessileDrop;
    use crate::theory::{Cap, puddle_height};

    #[test]
    fn without_weight_it_is_a_cap() {
        for dimension in [2, 3] {
            for degrees in [30.0_f64, 90.0, 150.0] {
                let angle = degrees.to_radians();
                let drop = SessileDrop::of_volume(2.0, angle, f64::INFINITY, dimension);
                let cap = Cap::of_volume(2.0, angle, dimension);
                assert!((drop.base_radius - cap.base_radius).abs() < 1e-6);
                assert!((drop.height - cap.height).abs() < 1e-6);
                // The midpoint rule's error.
                assert!((drop.circle_angle - angle).abs() < 1e-4);
                assert!((drop.circle_base_radius - cap.base_radius).abs() < 1e-4);
            }
        }
    }

    #[test]
    fn the_plate_carries_the_weight() {
        // Pressure on the base, less the pull of the contact line upwards.
        for (dimension, degrees) in [(2, 60.0_f64), (3, 60.0), (2, 120.0), (3, 120.0)] {
            let (angle, volume, a) = (degrees.to_radians(), 3.0, 0.8);
            let drop = SessileDrop::of_volume(volume, angle, a, dimension);
            let pressure = drop.top_curvature + drop.height / (a * a);
            let (area, edge) = match dimension {
                2 => (2.0 * drop.base_radius, 2.0),
                _ => (PI * drop.base_radius.powi(2), 2.0 * PI * drop.base_radius),
            };
            let carried = pressure * area - edge * angle.sin();
            // The rule's error at 400 steps.
            assert!(
                (carried / (volume / (a * a)) - 1.0).abs() < 1e-5,
                "{carried}"
            );
        }
    }

    #[test]
    fn a_wide_one_is_as_high_as_a_puddle() {
        let angle = 2.0;
        let drop = SessileDrop::of_volume(18.0, angle, 1.0, 2);
        // Its top has a curvature of e^-(half its width) left.
        assert!((drop.height / puddle_height(angle, 1.0) - 1.0).abs() < 0.01);
    }
}
