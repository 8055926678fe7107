//! Liquid that stands between two parallel plates, without weight.

use std::f64::consts::PI;

/// Steps from the neck to a plate.
const STEPS: usize = 200;

/// A liquid bridge, in two dimensions (per metre) or round, in three. Lengths in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bridge {
    /// Radius half way between the plates: half of the width in 2D.
    pub neck_radius: f64,
    /// Radius at the plates.
    pub wall_radius: f64,
    /// Pressure inside over sigma, 1/m; below zero where the surface is hollow.
    pub curvature: f64,
}

impl Bridge {
    /// The bridge of this volume (m^3; m^2 in 2D) between plates a `gap` (m) apart that it meets under
    /// this contact angle (rad, above 0, below pi), the same at both. With r(z) from the neck,
    /// r'' / (1 + r'^2)^(3/2) = 1 / (r sqrt(1 + r'^2)) - p / sigma, the middle term in 3D alone (De Gennes,
    /// Brochard-Wyart and Quere, Capillarity and Wetting Phenomena, ch. 1 and 2), by bisection in the
    /// neck's radius and the pressure. It is one at rest; a slender one, longer than about its
    /// circumference, does not stay.
    ///
    /// ```
    /// use meniscus::theory::Bridge;
    /// use std::f64::consts::{FRAC_PI_2, PI};
    /// // At a right angle it is a cylinder.
    /// let bridge = Bridge::of_volume(PI, FRAC_PI_2, 1.0, 3);
    /// assert!((bridge.neck_radius - 1.0).abs() < 1e-9 && (bridge.curvature - 1.0).abs() < 1e-9);
    /// ```
    pub fn of_volume(volume: f64, contact_angle: f64, gap: f64, dimension: usize) -> Self {
        let slope = 1.0 / contact_angle.tan();
        let (mut thin, mut thick) = (1e-3 * gap, 1e3 * gap);
        for _ in 0..80 {
            let neck = (thin * thick).sqrt();
            if Self::with_neck(neck, slope, gap, dimension).1 > volume {
                thick = neck;
            } else {
                thin = neck;
            }
        }
        Self::with_neck(thin, slope, gap, dimension).0
    }

    /// The bridge of this neck that meets the plates at this slope, and its volume.
    fn with_neck(neck: f64, slope: f64, gap: f64, dimension: usize) -> (Self, f64) {
        // The higher the pressure, the more it bulges.
        let (mut low, mut high) = (-100.0 / gap, 100.0 / gap + 2.0 / neck);
        for _ in 0..80 {
            let middle = 0.5 * (low + high);
            if rise(neck, middle, gap, dimension)[1] < slope {
                high = middle;
            } else {
                low = middle;
            }
        }
        let curvature = 0.5 * (low + high);
        let [wall_radius, _, half] = rise(neck, curvature, gap, dimension);
        let bridge = Bridge {
            neck_radius: neck,
            wall_radius,
            curvature,
        };
        (bridge, 2.0 * half)
    }
}

/// r, r' and half the volume at the plate; r' alone, without end, where the profile turns back before.
fn rise(neck: f64, curvature: f64, gap: f64, dimension: usize) -> [f64; 3] {
    let solid = dimension == 3;
    let step = 0.5 * gap / STEPS as f64;
    let by = |[r, lean, _]: [f64; 3]| {
        let length = (1.0 + lean * lean).sqrt();
        let around = if solid { 1.0 / (r * length) } else { 0.0 };
        let area = if solid { PI * r * r } else { 2.0 * r };
        [lean, (around - curvature) * length.powi(3), area]
    };
    let mut y = [neck, 0.0, 0.0];
    for _ in 0..STEPS {
        let ahead = |by: [f64; 3], share: f64| [0, 1, 2].map(|d| y[d] + share * step * by[d]);
        let a = by(y);
        let b = by(ahead(a, 0.5));
        let c = by(ahead(b, 0.5));
        let d = by(ahead(c, 1.0));
        y = [0, 1, 2].map(|i| y[i] + step / 6.0 * (a[i] + 2.0 * (b[i] + c[i]) + d[i]));
        if !(y[0] > 0.0 && y[1].abs() < 1e3) {
            return [f64::NAN, f64::INFINITY.copysign(y[1]), f64::NAN];
        }
    }
    y
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::Bridge;

    #[test]
    fn in_two_dimensions_its_sides_are_arcs() {
        for degrees in [40.0_f64, 60.0, 120.0] {
            let angle = degrees.to_radians();
            let bridge = Bridge::of_volume(2.0, angle, 1.0, 2);
            // The pressure that the two slopes at the plates ask for, and the arc's sagitta.
            assert!((bridge.curvature + 2.0 * angle.cos()).abs() < 1e-6);
            let sagitta = (1.0 - angle.sin()) / (2.0 * angle.cos());
            assert!((bridge.wall_radius - bridge.neck_radius - sagitta).abs() < 1e-6);
        }
    }

    #[test]
    fn every_cut_of_a_round_one_carries_the_same_force() {
        for degrees in [40.0_f64, 75.0, 120.0] {
            let angle = degrees.to_radians();
            let bridge = Bridge::of_volume(3.0, angle, 1.0, 3);
            let force =
                |r: f64, upright: f64| 2.0 * PI * r * upright - PI * r * r * bridge.curvature;
            let (neck, wall) = (
                force(bridge.neck_radius, 1.0),
                force(bridge.wall_radius, angle.sin()),
            );
            assert!((neck / wall - 1.0).abs() < 1e-6, "{neck} and {wall}");
        }
    }
}
