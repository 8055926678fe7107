//! The axis of shapes that are round about one.

use super::geometry::Shape;
use crate::vector::Vector;

impl<const D: usize> Shape<D> {
    /// The direction of the axis that a shape is round about, or x. A shape made of others takes its
    /// first part's.
    pub(super) fn axis(&self) -> Vector<f64, D> {
        self.line().map_or_else(
            || Vector::from_3d([1.0, 0.0, 0.0]),
            |(_, direction)| direction,
        )
    }

    /// Where that axis enters the shape.
    pub(super) fn end_of_axis(&self) -> Option<Vector<f64, D>> {
        self.line().map(|(end, _)| end)
    }

    /// The axis of a round shape: where it enters the shape, and its direction.
    fn line(&self) -> Option<(Vector<f64, D>, Vector<f64, D>)> {
        match self {
            Shape::Cylinder { start, end, .. } => Some((*start, *end - *start)),
            Shape::Revolved(shape) => {
                let (end, direction) = (shape.end().to_3d(), shape.direction().to_3d());
                Some((Vector::from_3d(end), Vector::from_3d(direction)))
            }
            Shape::Union(shapes) | Shape::Intersection(shapes) => {
                shapes.first().and_then(Shape::line)
            }
            Shape::Difference(shape, _) => shape.line(),
            _ => None,
        }
    }
}
