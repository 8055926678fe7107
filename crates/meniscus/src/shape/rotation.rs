//! How a shape or a lattice is turned.

use crate::vector::Vector;

/// A rotation in 2 or 3 dimensions: the matrix that turns a vector.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rotation<const D: usize>([[f64; D]; D]);

impl<const D: usize> Rotation<D> {
    /// No rotation.
    pub fn none() -> Self {
        Rotation(std::array::from_fn(|row| {
            std::array::from_fn(|column| f64::from(u8::from(row == column)))
        }))
    }

    /// By `angle`, in rad, about `axis`, of any length, by the right hand.
    ///
    /// In 2D only the part of the axis out of the plane counts; a positive one
    /// turns anticlockwise. An axis of no length gives no rotation.
    ///
    /// Rodrigues: R = cos(angle) I + sin(angle) \[u\]x + (1 - cos(angle)) u u^T.
    pub fn about(axis: Vector<f64, 3>, angle: f64) -> Self {
        let axis = if D == 2 {
            Vector([0.0, 0.0, axis[2]])
        } else {
            axis
        };
        let length = axis.norm();
        if length == 0.0 || angle == 0.0 {
            return Self::none();
        }
        let u = axis * (1.0 / length);
        let (sin, cos) = angle.sin_cos();
        let cross = [[0.0, -u[2], u[1]], [u[2], 0.0, -u[0]], [-u[1], u[0], 0.0]];
        Rotation(std::array::from_fn(|row| {
            std::array::from_fn(|column| {
                let same = if row == column { cos } else { 0.0 };
                same + sin * cross[row][column] + (1.0 - cos) * u[row] * u[column]
            })
        }))
    }

    /// The vector turned.
    pub fn apply(&self, v: &Vector<f64, D>) -> Vector<f64, D> {
        Vector(std::array::from_fn(|row| {
            (0..D).map(|column| self.0[row][column] * v[column]).sum()
        }))
    }

    /// The vector turned back.
    pub fn undo(&self, v: &Vector<f64, D>) -> Vector<f64, D> {
        Vector(std::array::from_fn(|row| {
            (0..D).map(|column| self.0[column][row] * v[column]).sum()
        }))
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use super::*;

    #[test]
    fn a_quarter_turn_takes_x_to_y_and_back() {
        let plane = Rotation::<2>::about(Vector([0.3, 0.1, 2.0]), FRAC_PI_2);
        let x = Vector([1.0, 0.0]);
        // One rounding of sine and cosine.
        assert!((plane.apply(&x) - Vector([0.0, 1.0])).norm() < 1e-15);
        assert!((plane.undo(&plane.apply(&x)) - x).norm() < 1e-15);
        let space = Rotation::<3>::about(Vector([1.0, 1.0, 1.0]), 2.0 * std::f64::consts::PI / 3.0);
        assert!((space.apply(&Vector([1.0, 2.0, 3.0])) - Vector([3.0, 1.0, 2.0])).norm() < 1e-14);
    }

    #[test]
    fn an_axis_of_no_length_turns_nothing() {
        let v = Vector([1.0, 2.0, 3.0]);
        assert_eq!(Rotation::<3>::about(Vector::ZERO, 1.0).apply(&v), v);
    }
}
