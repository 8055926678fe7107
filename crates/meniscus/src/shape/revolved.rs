//! What is round about an axis: a polygon turned about it.

use super::geometry::ROUNDING;
use super::polygon;
use crate::vector::Vector;

/// A polygon beside an axis, turned about it. Lengths in m.
#[derive(Clone, Debug, PartialEq)]
pub struct Revolved {
    /// Corners of the polygon in order, the last joined to the first: each by how far it is along
    /// the axis, counted from `point`, and its distance from the axis, not below zero.
    pub corners: Vec<Vector<f64, 2>>,
    /// A point of the axis.
    pub point: Vector<f64, 3>,
    /// Direction of the axis, of any length.
    pub axis: Vector<f64, 3>,
}

impl Revolved {
    /// The direction of the axis as a unit vector; NaN where it has none.
    pub(crate) fn direction(&self) -> Vector<f64, 3> {
        self.axis * (1.0 / self.axis.norm())
    }

    /// Where the axis enters what is along it.
    pub(super) fn end(&self) -> Vector<f64, 3> {
        let (low, _) = polygon::bounding_box(&self.corners);
        self.point + self.direction() * low[0]
    }

    /// Whether a point is inside: a point on the axis too, where the polygon has an edge on it.
    pub(super) fn contains(&self, x: &Vector<f64, 3>) -> bool {
        let direction = self.direction();
        let arm = *x - self.point;
        let along = arm.dot(&direction);
        let away = (arm - direction * along).norm();
        polygon::contains(&self.both_halves(), Vector([along, away]))
    }

    /// The lowest and the highest coordinates.
    pub(super) fn bounding_box(&self) -> (Vector<f64, 3>, Vector<f64, 3>) {
        let (low, high) = polygon::bounding_box(&self.corners);
        let direction = self.direction();
        let ends = [low[0], high[0]].map(|along| self.point + direction * along);
        let reach = direction.0.map(|a| high[1] * (1.0 - a * a).max(0.0).sqrt());
        let bound = |pick: fn(f64, f64) -> f64, sign: f64| {
            Vector(std::array::from_fn(|d| {
                pick(ends[0][d], ends[1][d]) + sign * reach[d]
            }))
        };
        (bound(f64::min, -1.0), bound(f64::max, 1.0))
    }

    /// The polygon and its mirror image as one, where it has an edge on the axis, which is no
    /// surface; any other polygon as it is.
    pub(crate) fn both_halves(&self) -> Vec<Vector<f64, 2>> {
        let (n, corners) = (self.corners.len(), &self.corners);
        let farthest = polygon::bounding_box(corners).1[1];
        let on_axis = |corner: &Vector<f64, 2>| corner[1] <= ROUNDING * farthest;
        let along_axis = |k: &usize| on_axis(&corners[*k]) && on_axis(&corners[(k + 1) % n]);
        let Some(edge) = (0..n).find(along_axis) else {
            return corners.clone();
        };
        let half: Vec<_> = (1..=n).map(|k| corners[(edge + k) % n]).collect();
        // From the last corner on the axis before it leaves it, to the first where it is back.
        let away = |corner: &Vector<f64, 2>| !on_axis(corner);
        let (Some(first), Some(last)) = (half.iter().position(away), half.iter().rposition(away))
        else {
            return corners.clone();
        };
        // A face across the axis goes on straight to its mirror image, with no corner between.
        let (head, tail) = (half[first.saturating_sub(1)], half[(last + 1).min(n - 1)]);
        let side = &half[first..=last];
        let mut outline = Vec::with_capacity(2 * n);
        if head[0] != side[0][0] {
            outline.push(head);
        }
        outline.extend_from_slice(side);
        if tail[0] != side[side.len() - 1][0] {
            outline.push(tail);
        }
        outline.extend((side.iter().rev()).map(|corner| Vector([corner[0], -corner[1]])));
        outline
    }
}
