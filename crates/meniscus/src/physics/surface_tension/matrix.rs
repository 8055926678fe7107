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
    /// The inverse of a sum of w r r^T over neighbours at r, guarded: where they lie so
    /// nearly on a line or a plane that the inverse would be noise, the geometric mean of
    /// the eigenvalues below `least` times the arithmetic, the identity over the trace,
    /// which is right along a line. Zero without neighbours.
    ///
    /// ```
    /// use meniscus::Vector;
    /// use meniscus::physics::surface_tension::matrix::Matrix;
    /// let inverse = Matrix([Vector([2.0, 1.0]), Vector([1.0, 1.0])]).inverse(0.2);
    /// assert_eq!(inverse, Matrix([Vector([1.0, -1.0]), Vector([-1.0, 2.0])]));
    /// let line = Matrix([Vector([1.0, 1.0]), Vector([1.0, 1.0])]).inverse(0.2);
    /// assert_eq!(line, Matrix([Vector([0.5, 0.0]), Vector([0.0, 0.5])]));
    /// ```
    pub fn inverse(&self, least: f64) -> Self {
        let at = |row: usize, column: usize| self.0[row % D][column % D];
        // The cofactor of an entry; indices wrap, which gives it its sign.
        let cofactor = |row: usize, column: usize| match D {
            2 => {
                let sign = if (row + column).is_multiple_of(2) {
                    1.0
                } else {
                    -1.0
                };
                sign * at(row + 1, column + 1)
            }
            _ => {
                at(row + 1, column + 1) * at(row + 2, column + 2)
                    - at(row + 1, column + 2) * at(row + 2, column + 1)
            }
        };
        let determinant: f64 = (0..D)
            .map(|column| at(0, column) * cofactor(0, column))
            .sum();
        let trace: f64 = (0..D).map(|d| at(d, d)).sum();
        if determinant > (least * trace / D as f64).powi(D as i32) {
            Matrix(std::array::from_fn(|row| {
                Vector(std::array::from_fn(|column| {
                    cofactor(column, row) / determinant
                }))
            }))
        } else {
            Self::diagonal(if trace > 0.0 { 1.0 / trace } else { 0.0 })
        }
    }

    /// The identity times `value`.
    pub fn diagonal(value: f64) -> Self {
        Matrix(std::array::from_fn(|row| {
            let mut entries = Vector::ZERO;
            entries[row] = value;
            entries
        }))
    }

    /// Sum of the entries on the diagonal.
    pub fn trace(&self) -> f64 {
        (0..D).map(|d| self.0[d][d]).sum()
    }

    /// The matrix times a vector.
    pub fn times(&self, vector: &Vector<f64, D>) -> Vector<f64, D> {
        Vector(self.0.map(|row| row.dot(vector)))
    }

    /// The trace of the square.
    pub fn trace_of_square(&self) -> f64 {
        self.trace_of_product(self)
    }

    /// The trace of the product with another.
    pub fn trace_of_product(&self, other: &Self) -> f64 {
        let entry = |row: usize, column: usize| self.0[row][column] * other.0[column][row];
        (0..D)
            .map(|row| (0..D).map(|column| entry(row, column)).sum::<f64>())
            .sum()
    }

    /// Its part in the plane across a unit vector: P M P, P = 1 - u u.
    pub fn within(&self, across: &Vector<f64, D>) -> Self {
        let rows = self.0.map(|row| row - *across * row.dot(across));
        let mut sum = Vector::ZERO;
        for d in 0..D {
            sum += rows[d] * across[d];
        }
        Matrix(std::array::from_fn(|d| rows[d] - sum * across[d]))
    }
}
