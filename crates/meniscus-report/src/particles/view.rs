//! From where the particles are seen.

use super::Snapshot;

/// A direction of space.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// Along x: y to the right, z up.
    X,
    /// Along y: x to the right, z up.
    Y,
    /// Along z: x to the right, y up.
    Z,
}

/// What is seen of the particles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum View {
    /// All of them, looking along a direction; near ones hide those behind.
    Whole(Direction),
    /// Those whose coordinate along the direction is within half of
    /// `thickness` of `at`, m.
    Slice {
        /// Looking along it.
        direction: Direction,
        /// Coordinate of the middle of the slice, m.
        at: f64,
        /// Thickness of the slice, m.
        thickness: f64,
    },
}

/// A particle as seen: position to the right and up, m.
pub(super) struct Seen {
    pub at: [f64; 2],
    pub radius: f64,
    pub depth: f64,
    pub value: f64,
    /// To the right and up, in its own unit.
    pub arrow: Option<[f64; 2]>,
}

impl View {
    /// The particles seen, from the farthest to the nearest.
    pub(super) fn see(&self, snapshot: &Snapshot, arrows: &[[f64; 3]]) -> Vec<Seen> {
        let direction = match *self {
            View::Whole(direction) | View::Slice { direction, .. } => direction,
        };
        let mut seen: Vec<Seen> = snapshot
            .positions
            .iter()
            .enumerate()
            .filter(|(_, p)| p.iter().all(|x| x.abs() < 1e100))
            .map(|(i, &[x, y, z])| {
                // Depth grows towards the eye, in right-handed axes.
                let turned = |[x, y, z]: [f64; 3]| match direction {
                    Direction::X => ([y, z], x),
                    Direction::Y => ([x, z], -y),
                    Direction::Z => ([x, y], z),
                };
                let (at, depth) = turned([x, y, z]);
                Seen {
                    at,
                    depth,
                    radius: 0.5 * snapshot.diameter.abs(),
                    value: snapshot.values.get(i).copied().unwrap_or(f64::NAN),
                    arrow: arrows.get(i).map(|&arrow| turned(arrow).0),
                }
            })
            .collect();
        if let View::Slice { at, thickness, .. } = *self {
            let middle = if direction == Direction::Y { -at } else { at };
            seen.retain(|p| (p.depth - middle).abs() <= 0.5 * thickness);
        }
        seen.sort_by(|a, b| a.depth.total_cmp(&b.depth));
        seen
    }
}
