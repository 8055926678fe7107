//! A square matrix of `D` rows, as pair sums and the corrected estimates need it.

use crate::real::Real;
use crate::term::Record;
use crate::vector::Vector;

/// A square matrix, by rows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Matrix<R, const D: usize>(pub [Vector<R, D>; D]);

impl<R: Real, const D: usize> Record<R> for Matrix<R, D> {
    const LENGTH: usize = D * D;
    #[inline(always)]
    fn read(next: &mut impl FnMut() -> R) -> Self {
        let mut rows = [Vector::read(next); D];
        for row in rows.iter_mut().skip(1) {
            *row = Vector::read(next);
        }
        Matrix(rows)
    }
    #[inline(always)]
    fn write(&self, put: &mut impl FnMut(R)) {
        for row in &self.0 {
            row.write(put);
        }
    }
}

impl<R: Real, const D: usize> Matrix<R, D> {
    /// Adds the outer product, `row` times `column`.
    #[inline(always)]
    pub fn add_outer(&mut self, row: &Vector<R, D>, column: &Vector<R, D>) {
        for d in 0..D {
            self.0[d] += *column * row[d];
        }
    }
}

impl<const D: usize> Matrix<f64, D> {
    /// The inverse of a matrix that is the identity where a kernel is full and
    /// shrinks with what is missing of it; `None` where so little is left, a
    /// determinant below `least`^D, that the inverse would only be noise.
    ///
    /// ```
    /// use meniscus::Vector;
    /// use meniscus::physics::surface_tension::matrix::Matrix;
    /// let inverse = Matrix([Vector([2.0, 1.0]), Vector([1.0, 1.0])]).inverse(0.1);
    /// assert_eq!(inverse, Some(Matrix([Vector([1.0, -1.0]), Vector([-1.0, 2.0])])));
    /// let line = Matrix([Vector([1.0, 1.0]), Vector([1.0, 1.0])]);
    /// assert_eq!(line.inverse(0.1), None);
    /// ```
    pub fn inverse(&self, least: f64) -> Option<Self> {
        let at = |row: usize, column: usize| self.0[row % D][column % D];
        // The cofactor of an entry; indices wrap, which gives it its sign.
        let cofactor = |row: usize, column: usize| match D {
            2 => {
                let sign = if (row + column) % 2 == 0 { 1.0 } else { -1.0 };
                sign * at(row + 1, column + 1)
            }
            _ => {
                at(row + 1, column + 1) * at(row + 2, column + 2)
                    - at(row + 1, column + 2) * at(row + 2, column + 1)
            }
        };
        let determinant: f64 = (0..D).map(|column| at(0, column) * cofactor(0, column)).sum();
        let enough = determinant > least.powi(D as i32);
        enough.then(|| {
            Matrix(std::array::from_fn(|row| {
                Vector(std::array::from_fn(|column| {
                    cofactor(column, row) / determinant
                }))
            }))
        })
    }

    /// The matrix times a vector.
    pub fn times(&self, vector: &Vector<f64, D>) -> Vector<f64, D> {
        Vector(std::array::from_fn(|row| self.0[row].dot(vector)))
    }
}
