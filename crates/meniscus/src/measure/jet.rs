//! A jet from a nozzle: how far it holds together, and the drops that have come off it.

use super::fragments;
use crate::vector::Vector;

/// Particles nearer than this many spacings are of one piece.
const LINK: f64 = 1.6;
/// Smaller pieces than this part of the largest free one are no drops, but what comes off between them.
const DROP: f64 = 0.1;

/// What lies beyond the plane in which a nozzle ends. Volumes in m^3, in 2D m^2.
#[derive(Clone, Debug, PartialEq)]
pub struct Jet {
    /// Mean velocity across the plane of what is within a spacing of it, m/s; NaN where nothing is.
    pub speed: f64,
    /// How far what holds together with the liquid behind the plane reaches beyond it, m.
    pub length: f64,
    /// Volume of all liquid beyond the plane.
    pub volume: f64,
    /// The drops that have come off, from the nozzle on.
    pub drops: Vec<FreeDrop>,
}

/// A drop that has come off a jet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeDrop {
    /// How far its centre of mass is beyond the plane, m.
    pub distance: f64,
    /// Velocity of that away from the plane, m/s.
    pub speed: f64,
    /// m^3, in 2D m^2
    pub volume: f64,
}

impl Jet {
    /// Of liquid by places (m), velocities (m/s), and volumes of particles `spacing` (m) apart,
    /// beyond the plane through `at` (m) in a `direction` of any length.
    pub fn measure<const D: usize>(
        position: &[Vector<f64, D>],
        velocity: &[Vector<f64, D>],
        volume: &[f64],
        spacing: f64,
        at: Vector<f64, D>,
        direction: Vector<f64, D>,
    ) -> Self {
        let unit = direction * (1.0 / direction.norm());
        let beyond: Vec<f64> = position.iter().map(|x| (*x - at).dot(&unit)).collect();
        let speed: Vec<f64> = velocity.iter().map(|v| v.dot(&unit)).collect();
        let count = beyond.len().min(speed.len()).min(volume.len());
        let pieces = fragments(position, LINK * spacing);
        let mut sums = vec![Piece::default(); pieces.iter().max().map_or(0, |last| last + 1)];
        let (mut slab, mut passed) = (Piece::default(), 0.0);
        for i in 0..count {
            sums[pieces[i]].add(volume[i], beyond[i], speed[i]);
            if beyond[i].abs() <= spacing {
                slab.add(volume[i], beyond[i], speed[i]);
            }
            if beyond[i] > 0.0 {
                passed += volume[i];
            }
        }
        let (attached, mut free): (Vec<Piece>, Vec<Piece>) =
            sums.into_iter().partition(|piece| piece.nearest <= 0.0);
        let largest = free.iter().map(|piece| piece.volume).fold(0.0, f64::max);
        free.retain(|piece| piece.volume >= DROP * largest);
        let mut drops: Vec<FreeDrop> = free.iter().map(Piece::drop).collect();
        drops.sort_by(|a, b| a.distance.total_cmp(&b.distance));
        let reach = (attached.iter()).map(|piece| piece.farthest + 0.5 * spacing);
        Self {
            speed: slab.flow / slab.volume,
            length: reach.fold(0.0, f64::max),
            volume: passed,
            drops,
        }
    }
}

/// Sums over a part of the liquid.
#[derive(Clone, Copy)]
struct Piece {
    volume: f64,
    /// Of volume times distance, and times velocity.
    moment: f64,
    flow: f64,
    nearest: f64,
    farthest: f64,
}

impl Default for Piece {
    fn default() -> Self {
        Self {
            volume: 0.0,
            moment: 0.0,
            flow: 0.0,
            nearest: f64::INFINITY,
            farthest: f64::NEG_INFINITY,
        }
    }
}

impl Piece {
    fn add(&mut self, volume: f64, beyond: f64, speed: f64) {
        self.volume += volume;
        self.moment += volume * beyond;
        self.flow += volume * speed;
        self.nearest = self.nearest.min(beyond);
        self.farthest = self.farthest.max(beyond);
    }

    fn drop(&self) -> FreeDrop {
        FreeDrop {
            distance: self.moment / self.volume,
            speed: self.flow / self.volume,
            volume: self.volume,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Jet;
    use crate::measure::samples::cut;
    use crate::vector::Vector;

    #[test]
    fn a_rod_and_three_balls_are_a_jet_two_drops_and_a_satellite() {
        // Along -x: a rod that ends 20 beyond the plane, a ball at 30, a small one at 40, a large one at 50.
        let ball = |x: &Vector<f64, 3>, centre: f64| (*x - Vector([-centre, 0.0, 0.0])).norm();
        let liquid = cut(60.0, 0.3, 0.2, |x: &Vector<f64, 3>| {
            let rod = x[1].hypot(x[2]) < 4.0 && x[0] > -20.0 && x[0] < 10.0;
            rod || ball(x, 30.0) < 4.0 || ball(x, 40.0) < 1.7 || ball(x, 50.0) < 5.0
        });
        let speed =
            |x: &Vector<f64, 3>| Vector([if x[0] > 0.0 { -1.0 } else { x[0] / 10.0 }, 7.0, 0.0]);
        let velocity: Vec<_> = liquid.iter().map(speed).collect();
        let volume = vec![1.0; liquid.len()];
        let direction = Vector([-2.0, 0.0, 0.0]);
        let jet = Jet::measure(&liquid, &velocity, &volume, 1.0, Vector::ZERO, direction);
        // Particles stand for a spacing, jittered by a fifth.
        assert!((jet.length - 20.0).abs() < 0.8, "{}", jet.length);
        assert!((jet.speed - 0.5).abs() < 0.1, "{}", jet.speed);
        let [near, far] = jet.drops[..] else {
            panic!("{:?}", jet.drops)
        };
        for (drop, centre, radius) in [(near, 30.0, 4.0_f64), (far, 50.0, 5.0)] {
            assert!((drop.distance - centre).abs() < 0.2, "{drop:?}");
            assert!((drop.speed - centre / 10.0).abs() < 0.02, "{drop:?}");
            let volume = 4.0 / 3.0 * std::f64::consts::PI * radius.powi(3);
            assert!((drop.volume / volume - 1.0).abs() < 0.05, "{drop:?}");
        }
        let behind = liquid.iter().filter(|x| x[0] >= 0.0).count();
        assert_eq!(jet.volume, (liquid.len() - behind) as f64);
    }

    #[test]
    fn nothing_is_no_jet() {
        let jet = Jet::measure::<3>(&[], &[], &[], 1.0, Vector::ZERO, Vector([1.0, 0.0, 0.0]));
        assert!(jet.speed.is_nan() && jet.drops.is_empty());
        assert_eq!((jet.length, jet.volume), (0.0, 0.0));
    }
}
