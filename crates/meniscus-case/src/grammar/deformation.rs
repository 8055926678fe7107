//! A drop that is left to settle, then drawn out.

use crate::read::{Node, Sign};
use crate::units;

/// The whole liquid drawn out along y, about its centre of mass and to the same volume, at some time.
#[derive(Clone, Debug, PartialEq)]
pub struct Deformation {
    /// When, s.
    pub time: f64,
    /// Extent along y over that along the others, of what was round.
    pub aspect: f64,
    /// Rate of a drag that brings the liquid to rest until then, 1/s; zero for none.
    pub settling: f64,
}

pub(super) fn deformation(node: &mut Node<'_>, end_time: f64) -> Deformation {
    node.table(|fields| Deformation {
        time: fields.required("time", "When.", |node| {
            let time = node.quantity(&units::TIME, Sign::NotNegative);
            if time >= end_time {
                node.fail(
                    format!("`time` is {time} s"),
                    "not before the end of the run",
                    format!("end_time is {end_time} s"),
                );
            }
            time
        }),
        aspect: fields.required(
            "aspect",
            "Extent along y over that along the others, of what was round.",
            |node| node.number(Sign::Positive),
        ),
        settling: fields.or(
            "settling",
            "'0 /s'",
            "Rate of a drag that brings the liquid to rest until then.",
            |node| node.quantity(&units::RATE, Sign::NotNegative),
        ),
    })
}
