//! The outline of a round body: how far it reaches from its centre in each direction.

use std::f64::consts::{PI, TAU};

use crate::vector::Vector;

use super::centre_of_mass;

/// Width of a direction at the outline, in spacings: wide enough to hold a particle of the
/// outermost layer, of a disordered body too.
const WIDTH: f64 = 2.0;

/// The outermost particles about the centre of mass, one to each direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outline {
    /// Mean distance of the outermost particle centres from the centre of mass, m. The surface
    /// lies 0.2 to 0.5 spacings further out.
    pub mean_radius: f64,
    /// Standard deviation of that distance over the directions, m: zero for a circle or sphere,
    /// R e / sqrt(2) for an ellipse of semi-axes R (1 +- e). A lattice cut to a disc shows 0.2
    /// to 0.3 spacings; so do particles of a liquid that is not in layers along its surface.
    pub deviation: f64,
    /// Radius, m, of the circle or sphere with the area or volume that these centres
    /// enclose: the root of the mean of r^D.
    pub enclosing_radius: f64,
    /// How many directions hold a particle.
    pub directions: usize,
}

impl Outline {
    /// Measures a body of particles about `spacing` (m) apart; `None` without mass.
    ///
    /// Gonzalez's measure of circularity (thesis, sec. 4.2): of the particles in each
    /// direction the outermost counts. Directions are about two spacings wide
    /// at the outline: sectors in 2D, equal patches of the sky in 3D.
    pub fn measure<const D: usize>(
        positions: &[Vector<f64, D>],
        masses: &[f64],
        spacing: f64,
    ) -> Option<Self> {
        let centre = centre_of_mass(positions, masses)?;
        let squares = positions.iter().map(|&x| (x - centre).norm_squared());
        // That of a uniform disc or ball from its second moment.
        let size = ((D as f64 + 2.0) / D as f64 * squares.sum::<f64>() / positions.len() as f64)
            .sqrt()
            .max(spacing);
        let sky = Sky::new(D, WIDTH * spacing / size);
        let mut outermost = vec![0.0_f64; sky.patches()];
        for &x in positions {
            let arm = x - centre;
            let place = &mut outermost[sky.patch(arm.to_3d())];
            *place = place.max(arm.norm());
        }
        outermost.retain(|&radius| radius > 0.0);
        let mean = |of: &dyn Fn(f64) -> f64| {
            outermost.iter().map(|&r| of(r)).sum::<f64>() / outermost.len() as f64
        };
        let mean_radius = mean(&|r| r);
        (!outermost.is_empty()).then(|| Outline {
            mean_radius,
            deviation: mean(&|r| (r - mean_radius).powi(2)).sqrt(),
            enclosing_radius: mean(&|r| r.powi(D as i32)).powf(1.0 / D as f64),
            directions: outermost.len(),
        })
    }
}

/// Directions in patches of about equal size: a ring of sectors in 2D, in 3D bands from pole
/// to pole, each cut into sectors.
struct Sky {
    /// Where the sectors of each band begin, and where the last ends.
    bands: Vec<usize>,
}

impl Sky {
    /// Patches of about `width` radians.
    fn new(dimension: usize, width: f64) -> Self {
        let sectors = |circumference: f64| ((circumference / width).round() as usize).max(1);
        let mut bands = vec![0];
        if dimension == 2 {
            bands.push(sectors(TAU).max(8));
        } else {
            let count = sectors(PI).max(4);
            for k in 0..count {
                let latitude = PI * (k as f64 + 0.5) / count as f64;
                bands.push(bands[k] + sectors(TAU * latitude.sin()));
            }
        }
        Self { bands }
    }

    fn patches(&self) -> usize {
        self.bands[self.bands.len() - 1]
    }

    /// The patch that an arm points to.
    fn patch(&self, arm: [f64; 3]) -> usize {
        let share = |angle: f64, whole: f64, parts: usize| {
            ((angle / whole * parts as f64) as usize).min(parts - 1)
        };
        let bands = self.bands.len() - 1;
        let from_pole = arm[0].hypot(arm[1]).atan2(arm[2]);
        let band = if bands == 1 {
            0
        } else {
            share(from_pole, PI, bands)
        };
        let (begin, end) = (self.bands[band], self.bands[band + 1]);
        begin + share(arm[1].atan2(arm[0]) + PI, TAU, end - begin)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::samples::cut;

    fn outline<const D: usize>(x: &[Vector<f64, D>], spacing: f64) -> Outline {
        Outline::measure(x, &vec![1.0; x.len()], spacing).unwrap()
    }

    #[test]
    fn a_ring_is_round_to_rounding_and_an_ellipse_as_theory_has_it() {
        let ring = |a: f64, b: f64| -> Vec<Vector<f64, 2>> {
            (0..1000)
                .map(|i| (TAU * f64::from(i) / 1000.0).sin_cos())
                .map(|(sin, cos)| Vector([7.0 + a * cos, 3.0 + b * sin]))
                .collect()
        };
        let round = outline(&ring(2.0, 2.0), 0.1);
        assert!((round.mean_radius - 2.0).abs() < 1e-12 && round.deviation < 1e-12);
        assert!((round.enclosing_radius - 2.0).abs() < 1e-12);
        // To first order in e; the next is e^2 / 4 of it and the width of the sectors 2 %.
        let e = 0.05;
        let oval = outline(&ring(1.0 + e, 1.0 - e), 0.01);
        assert!(
            (oval.deviation * 2.0_f64.sqrt() / e - 1.0).abs() < 0.03,
            "{oval:?}"
        );
    }

    #[test]
    fn a_disc_and_a_ball_cut_from_a_lattice_are_rough_by_a_part_of_a_spacing() {
        // In units of the spacing, at any angle of the lattice and with jitter.
        for (angle, jitter) in [(0.0, 0.0), (0.3, 0.0), (0.3, 0.2), (1.0, 0.2)] {
            let disc = cut(10.0, angle, jitter, |x: &Vector<f64, 2>| x.norm() < 10.0);
            let disc = outline(&disc, 1.0);
            assert!((0.1..0.35).contains(&disc.deviation), "{angle}: {disc:?}");
            // The outermost of two or four abreast are nearer to the surface than half a spacing.
            assert!((9.5..9.9).contains(&disc.mean_radius), "{angle}: {disc:?}");
            assert!(disc.directions >= 27);
            let ball = cut(8.0, angle, jitter, |x: &Vector<f64, 3>| x.norm() < 8.0);
            let ball = outline(&ball, 1.0);
            assert!((0.1..0.35).contains(&ball.deviation), "{angle}: {ball:?}");
            assert!((7.5..7.95).contains(&ball.mean_radius), "{angle}: {ball:?}");
            // A patch for each four squares of the spacing.
            assert!((ball.directions as f64 / (4.0 * PI * 64.0 / 4.0) - 1.0).abs() < 0.1);
        }
    }

    #[test]
    fn nothing_has_no_outline_and_one_particle_has_none_either() {
        assert_eq!(Outline::measure::<2>(&[], &[], 1.0), None);
        assert_eq!(Outline::measure(&[Vector([1.0, 2.0])], &[1.0], 1.0), None);
    }
}
