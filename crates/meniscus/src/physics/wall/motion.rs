//! How a wall moves: its place, velocity and acceleration as functions of time.

use std::f64::consts::TAU;

use crate::shape::Rotation;
use crate::vector::Vector;

/// A prescribed rigid motion. In 2D third components are ignored, but for the angular
/// velocity, of which only the third counts.
#[derive(Clone, Debug, PartialEq)]
pub enum Motion {
    /// It stays where it is.
    Rest,
    /// At a constant velocity.
    Translation {
        /// m/s
        velocity: [f64; 3],
    },
    /// To and fro about a place that may move on:
    /// x = x_0 + velocity t + amplitude (sin(2 pi frequency t + phase) - sin(phase)).
    Oscillation {
        /// Mean velocity, m/s.
        velocity: [f64; 3],
        /// Amplitude, m.
        amplitude: [f64; 3],
        /// Frequency, Hz.
        frequency: f64,
        /// Phase at t = 0, rad.
        phase: f64,
    },
    /// About an axis, at a constant angular velocity.
    Rotation {
        /// A point of the axis, m.
        centre: [f64; 3],
        /// rad/s, along the axis; anticlockwise.
        angular_velocity: [f64; 3],
    },
}

/// A point of a wall at some time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moved<const D: usize> {
    /// m
    pub position: Vector<f64, D>,
    /// m/s
    pub velocity: Vector<f64, D>,
    /// m/s^2
    pub acceleration: Vector<f64, D>,
}

impl Motion {
    /// Where the point that starts at `start` (m) is at `time` (s), and how it moves.
    ///
    /// ```
    /// use meniscus::Vector;
    /// use meniscus::physics::wall::Motion;
    ///
    /// let motion = Motion::Rotation { centre: [1.0, 0.0, 0.0], angular_velocity: [0.0, 0.0, 2.0] };
    /// let quarter = motion.at(Vector([3.0, 0.0]), std::f64::consts::FRAC_PI_4);
    /// assert!((quarter.position - Vector([1.0, 2.0])).norm() < 1e-15);
    /// assert!((quarter.velocity - Vector([-4.0, 0.0])).norm() < 1e-15);
    /// assert!((quarter.acceleration - Vector([0.0, -8.0])).norm() < 1e-14);
    /// ```
    pub fn at<const D: usize>(&self, start: Vector<f64, D>, time: f64) -> Moved<D> {
        let mut moved = Moved {
            position: start,
            velocity: Vector::ZERO,
            acceleration: Vector::ZERO,
        };
        match *self {
            Motion::Rest => {}
            Motion::Translation { velocity } => {
                moved.velocity = Vector::from_3d(velocity);
                moved.position += moved.velocity * time;
            }
            Motion::Oscillation {
                velocity,
                amplitude,
                frequency,
                phase,
            } => {
                let (mean, amplitude) = (Vector::from_3d(velocity), Vector::from_3d(amplitude));
                let omega = TAU * frequency;
                let (sin, cos) = (omega * time + phase).sin_cos();
                moved.position += mean * time + amplitude * (sin - phase.sin());
                moved.velocity = mean + amplitude * (omega * cos);
                moved.acceleration = amplitude * (-omega * omega * sin);
            }
            Motion::Rotation {
                centre,
                angular_velocity,
            } => {
                let omega = Vector(angular_velocity);
                let centre = Vector::<f64, D>::from_3d(centre);
                let rate = if D == 2 { omega[2].abs() } else { omega.norm() };
                let turn = Rotation::<D>::about(omega, rate * time);
                let arm = turn.apply(&(start - centre));
                moved.position = centre + arm;
                moved.velocity = self.shear(arm);
                moved.acceleration = self.shear(moved.velocity);
            }
        }
        moved
    }

    /// How much faster, m/s, the wall moves at one of its points than at another, with `arm`,
    /// m, from the other to the one.
    pub fn shear<const D: usize>(&self, arm: Vector<f64, D>) -> Vector<f64, D> {
        let Motion::Rotation {
            angular_velocity, ..
        } = self
        else {
            return Vector::ZERO;
        };
        let [x, y, z] = arm.to_3d();
        let [mut a, mut b, c] = *angular_velocity;
        if D == 2 {
            (a, b) = (0.0, 0.0);
        }
        Vector::from_3d([b * z - c * y, c * x - a * z, a * y - b * x])
    }

    /// Whether all its numbers are finite.
    pub(crate) fn is_sound(&self) -> bool {
        let finite = |numbers: &[f64]| numbers.iter().all(|x| x.is_finite());
        match self {
            Motion::Rest => true,
            Motion::Translation { velocity } => finite(velocity),
            Motion::Oscillation {
                velocity,
                amplitude,
                frequency,
                phase,
            } => finite(velocity) && finite(amplitude) && finite(&[*frequency, *phase]),
            Motion::Rotation {
                centre,
                angular_velocity,
            } => finite(centre) && finite(angular_velocity),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Motion;
    use crate::vector::Vector;

    #[test]
    fn velocity_and_acceleration_are_what_the_place_says() {
        let turning = Motion::Rotation {
            centre: [0.1, 0.2, 0.3],
            angular_velocity: [1.0, -2.0, 0.5],
        };
        let swinging_on = Motion::Oscillation {
            velocity: [0.5, 0.0, -1.0],
            amplitude: [0.1, 0.2, 0.0],
            frequency: 0.7,
            phase: 0.4,
        };
        let start = Vector([1.0, 2.0, -1.0]);
        for motion in [turning, swinging_on] {
            assert_eq!(motion.at(start, 0.0).position, start);
            for time in [0.3, 1.7] {
                // A central difference errs by its step squared, 1e-8, and by rounding.
                let step = 1e-4;
                let (before, after) =
                    (motion.at(start, time - step), motion.at(start, time + step));
                let now = motion.at(start, time);
                let velocity = (after.position - before.position) * (0.5 / step);
                let acceleration = (after.velocity - before.velocity) * (0.5 / step);
                assert!((velocity - now.velocity).norm() < 1e-6);
                assert!((acceleration - now.acceleration).norm() < 1e-6);
            }
        }
    }
}
