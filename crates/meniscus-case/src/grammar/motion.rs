//! What moves, and how: walls, and body forces that swing.

use meniscus::Vector;
use meniscus::scheme::Motion;

use super::shape::centre;
use crate::read::{Choice, Fields, Node, Sign};
use crate::units::{self, Kind};

/// Amplitude, frequency (Hz) and phase (rad) of what goes to and fro.
pub(super) fn swing(
    fields: &mut Fields<'_, '_>,
    kind: &'static Kind,
    about: &str,
) -> ([f64; 3], f64, f64) {
    let amplitude = fields.required("amplitude", about, |node| node.vector(kind, Sign::Any));
    let frequency = fields.required("frequency", "Oscillations per second.", |node| {
        node.quantity(&units::RATE, Sign::Positive)
    });
    let phase = fields.or("phase", "'0 deg'", "Phase at the start.", |node| {
        node.quantity(&units::ANGLE, Sign::Any)
    });
    (amplitude, frequency, phase)
}

/// A rate of turning: anticlockwise, or in 3D a vector along the axis.
pub(super) fn angular_velocity<const D: usize>(node: &mut Node<'_>) -> [f64; 3] {
    node.either(
        D == 2,
        |node| [0.0, 0.0, node.quantity(&units::ANGULAR_VELOCITY, Sign::Any)],
        |node| node.vector(&units::ANGULAR_VELOCITY, Sign::Any),
    )
}

/// The motions of a wall.
pub(super) fn motions<const D: usize>() -> [Choice<Motion>; 4] {
    [
        Choice::new("rest", "It stays where it is.", |node| {
            node.table(|_| Motion::Rest)
        }),
        Choice::new("translation", "At a constant velocity.", |node| {
            node.table(|fields| Motion::Translation {
                velocity: fields.required("velocity", "Its velocity.", |node| {
                    node.vector(&units::SPEED, Sign::Any)
                }),
            })
        }),
        Choice::new(
            "oscillation",
            "To and fro: displaced by velocity t + amplitude (sin(2 pi frequency t + phase) - sin(phase)).",
            |node| {
                node.table(|fields| {
                    let about = "The amplitude.";
                    let (amplitude, frequency, phase) = swing(fields, &units::LENGTH, about);
                    let still = format!("[{}]", ["'0 m/s'"; D].join(", "));
                    let about = "The velocity of its middle.";
                    let velocity = fields.or("velocity", &still, about, |node| {
                        node.vector(&units::SPEED, Sign::Any)
                    });
                    Motion::Oscillation {
                        velocity,
                        amplitude,
                        frequency,
                        phase,
                    }
                })
            },
        ),
        Choice::new("rotation", "About an axis, steadily.", |node| {
            node.table(|fields| {
                let about = "Anticlockwise, or in 3D a vector along the axis.";
                let angular_velocity =
                    fields.required("angular_velocity", about, angular_velocity::<D>);
                let centre: Vector<f64, D> = centre(fields, "A point of the axis.");
                Motion::Rotation {
                    centre: centre.to_3d(),
                    angular_velocity,
                }
            })
        }),
    ]
}
