//! The shape of a small drop at rest on a ball, or in a round vessel: a lens.

use std::f64::consts::PI;

use super::Cap;

/// What a circle (2D) or sphere (3D) cuts off the liquid beside a round wall. Lengths in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CapOnBall {
    /// Radius of the circle or sphere of its surface; negative where the surface is hollow.
    pub curvature_radius: f64,
    /// Radius of the contact line: half of the straight way between its two points in 2D.
    pub base_radius: f64,
    /// Height above the wall, on the axis.
    pub height: f64,
}

impl CapOnBall {
    /// The lens of this volume (m^3; m^2 in 2D) that meets a ball of this radius (m) under this
    /// contact angle (rad, above 0, up to pi), gravity being weak. A negative radius is that of a vessel around
    /// the liquid, which must be larger than the volume.
    ///
    /// Where the radius to the contact line leans by phi from the axis, negative in a vessel, the base is
    /// a sin(phi). Over it stand two caps with one base: of angle theta + phi the liquid and the wall in it,
    /// of angle phi the wall. Their difference is the volume, which grows with |phi|; bisection.
    ///
    /// ```
    /// use meniscus::theory::{Cap, CapOnBall};
    /// // A large ball is a flat wall.
    /// let (on, flat) = (CapOnBall::of_volume(1.0, 1.0, 1e5, 3), Cap::of_volume(1.0, 1.0, 3));
    /// assert!((on.base_radius - flat.base_radius).abs() < 1e-4);
    /// // At 90 degrees on a disc of radius one, a drop of radius one has its centre sqrt(2) away,
    /// // and its contact line half way.
    /// let disc = CapOnBall::of_volume(1.0 + std::f64::consts::FRAC_PI_2, 1.570_796_326_794_896_6, 1.0, 2);
    /// assert!((disc.base_radius - 0.5_f64.sqrt()).abs() < 1e-12);
    /// assert!((disc.curvature_radius - 1.0).abs() < 1e-12);
    /// assert!((disc.height - 2.0_f64.sqrt()).abs() < 1e-12);
    /// ```
    pub fn of_volume(
        volume: f64,
        contact_angle: f64,
        wall_radius: f64,
        dimension: usize,
    ) -> CapOnBall {
        let sign = wall_radius.signum();
        let most = if sign > 0.0 { PI - contact_angle } else { PI };
        let (mut low, mut high) = (0.0, most);
        // Up to the last bit.
        for _ in 0..100 {
            let middle = 0.5 * (low + high);
            if held(wall_radius, contact_angle, sign * middle, dimension) < volume {
                low = middle;
            } else {
                high = middle;
            }
        }
        let phi = sign * 0.5 * (low + high);
        let base_radius = wall_radius * phi.sin();
        let opening = contact_angle + phi;
        CapOnBall {
            curvature_radius: base_radius / opening.sin(),
            base_radius,
            height: base_radius * ((0.5 * opening).tan() - (0.5 * phi).tan()),
        }
    }
}

/// The volume of the lens whose contact line leans by `phi`.
fn held(wall_radius: f64, contact_angle: f64, phi: f64, dimension: usize) -> f64 {
    let base = wall_radius * phi.sin();
    let cap = |angle: f64| match angle {
        // A flat surface has nothing over its base.
        0.0 => 0.0,
        _ => angle.signum() * Cap::of_base(base, angle.abs()).volume(dimension),
    };
    cap(contact_angle + phi) - cap(phi)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::CapOnBall;

    #[test]
    fn its_volume_and_angle_are_those_asked_for() {
        // Slices across the axis by the midpoint rule: error below n^-1.5 of the volume.
        let n = 100_000;
        let asked = 1.3;
        for dimension in [2, 3] {
            for wall in [1.5_f64, 0.7, -1.2, -3.0] {
                for degrees in [20.0_f64, 60.0, 90.0, 150.0] {
                    let theta = degrees.to_radians();
                    let lens = CapOnBall::of_volume(asked, theta, wall, dimension);
                    let shown = format!("{dimension}D, {degrees} on {wall}: {lens:?}");
                    // Centres along the axis, the wall's at zero.
                    let (a, r) = (wall.abs(), lens.curvature_radius);
                    let centre = wall + lens.height - r;
                    // Where both surfaces are, and how they lean against each other there.
                    let x = 0.5 * (centre + (a * a - r * r) / centre);
                    assert!(
                        ((a * a - x * x).sqrt() - lens.base_radius).abs() < 1e-9,
                        "{shown}"
                    );
                    let cosine = (a * a + r * r - centre * centre) / (2.0 * wall * r);
                    assert!((cosine - theta.cos()).abs() < 1e-9, "{shown}");

                    let reach = a + lens.height.abs() + r.abs().min(10.0);
                    let width = 2.0 * reach / f64::from(n);
                    let slice = |half_square: f64| match dimension {
                        2 => 2.0 * half_square.max(0.0).sqrt(),
                        _ => PI * half_square.max(0.0),
                    };
                    let volume: f64 = (0..n)
                        .map(|i| -reach + (f64::from(i) + 0.5) * width)
                        .map(|y| {
                            let of_wall = a * a - y * y;
                            let of_drop = r * r - (y - centre).powi(2);
                            let both = of_wall.min(of_drop);
                            width
                                * match (wall > 0.0, r > 0.0) {
                                    (true, _) => slice(of_drop) - slice(both),
                                    (false, true) => slice(both),
                                    (false, false) => slice(of_wall) - slice(both),
                                }
                        })
                        .sum();
                    assert!((volume - asked).abs() < 1e-4, "{shown}: {volume}");
                }
            }
        }
    }
}
