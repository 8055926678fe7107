//! How hard walls push what comes too near: by their smoothed colour C_w, along which nothing holds a particle.
//!
//! Half a spacing before a plane wall C_w is 0.35; from 1/3 on the push begins. In a corner the colours of two or three walls add
//! up, to 0.58 and 0.72 half a spacing from all, which would push the liquid out. C_w smoothed more, C_w', tells: before a plane
//! wall it follows from C_w, in a corner it is higher, by 0.07 and 0.1 there. So
//!
//! push = 32 sigma / dx^2 max(C_w - 1/3 - 4.2 max(C_w' - C_p(C_w) - 0.015, 0), 0)   per volume
//!
//! with C_p = 1 / (1 + ((1 - C_w) / C_w)^s), s^2 the ratio of their variances: what C_w' is before a wall that goes on and on, within 0.001.
//! Before one of four layers it is lower; before a round one of twelve spacings it is higher by 0.008.

use super::nodes::VARIANCE;
use super::order;

/// Colour of a wall from which on it pushes.
pub(super) const AT_WALL: f64 = 1.0 / 3.0;
/// Push of a wall on what comes nearer, sigma / dx^2.
const STIFFNESS: f64 = 32.0;
/// Difference of colours from which on a wall has a corner.
const LEEWAY: f64 = 0.015;
/// What a difference beyond takes off the colour.
const IN_CORNER: f64 = 4.2;
/// Variances of both colours as particles feel them, dx^2.
const NARROW: f64 = VARIANCE + 1.0 / 3.0;
const WIDE: f64 = NARROW + 0.5 * order::PASSES as f64;
/// Most of the colour.
const SOLID: f64 = 0.999;

/// Push per volume, sigma / dx^2, where a wall has this colour, and this one smoothed more.
pub(super) fn push(wall: f64, wide: impl FnOnce() -> f64) -> f64 {
    if wall <= AT_WALL {
        return 0.0;
    }
    let open = (1.0 - wall.min(SOLID)) / wall.min(SOLID);
    let plane = 1.0 / (1.0 + libm::pow(open, libm::sqrt(NARROW / WIDE)));
    let corner = (wide() - plane - LEEWAY).max(0.0);
    STIFFNESS * (wall - AT_WALL - IN_CORNER * corner).max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of four layers so many spacings away, with this variance.
    fn colour(distance: f64, variance: f64) -> f64 {
        let beyond = |x: f64| 0.5 * libm::erfc(x / libm::sqrt(2.0 * variance));
        beyond(distance) - beyond(distance + 4.0)
    }

    /// In the corner of walls at these distances.
    fn pushed(distances: &[f64]) -> f64 {
        let all = |variance| {
            let open = |&distance: &f64| 1.0 - colour(distance, variance);
            1.0 - distances.iter().map(open).product::<f64>()
        };
        push(all(NARROW), || all(WIDE))
    }

    #[test]
    fn half_a_spacing_from_all_walls_is_near_enough() {
        // That of a plane wall there is what 0.05 spacings more would end.
        let plane = pushed(&[0.5]);
        assert!(plane < 0.6);
        for along in [0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0] {
            assert!(pushed(&[0.5, along]) < 1.5 * plane, "{along}");
        }
        assert!(pushed(&[0.5; 3]) < pushed(&[0.3]));
    }

    #[test]
    fn what_is_nearer_is_pushed() {
        // By a plane wall for its colour alone.
        for distance in [0.4, 0.2, 0.0, -0.5] {
            let alone = STIFFNESS * (colour(distance, NARROW) - AT_WALL);
            assert!((pushed(&[distance]) - alone).abs() < 1e-12, "{distance}");
        }
        for along in [0.5, 1.0, 2.0, 4.0] {
            assert!(pushed(&[0.0, along]) > 0.4 * pushed(&[0.0]), "{along}");
        }
    }
}
