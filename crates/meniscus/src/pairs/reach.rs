//! How far each particle reaches for others.

use fearless_simd::Simd;

use super::columns::Columns;
use super::lane::{Lane, WIDTH};

/// How far sorted points reach: the list of one holds those that are no farther away than both
/// reach together.
#[derive(Debug, Default)]
pub(crate) struct Reach {
    /// That of all, m, if it is the same; the columns below are empty then.
    same: Option<f64>,
    /// Of each point, m, and a lane of zeros.
    of_row: Vec<f64>,
    /// The largest of each column, m.
    of_column: Vec<f64>,
    /// The largest of all, m.
    largest: f64,
}

impl Reach {
    /// The same for all, m.
    pub(crate) fn fill_same(&mut self, reach: f64) {
        self.same = Some(reach);
        self.of_row.clear();
        self.of_column.clear();
        self.largest = reach;
    }

    /// Those of the sorted points of `columns`, m.
    pub(crate) fn fill<const D: usize>(
        &mut self,
        columns: &Columns<D>,
        of_row: impl Iterator<Item = f64>,
    ) {
        self.same = None;
        self.of_row.clear();
        self.of_row.extend(of_row.take(columns.len()));
        self.of_column.clear();
        self.of_column.resize(columns.count(), 0.0);
        for (row, &reach) in self.of_row.iter().enumerate() {
            let largest = &mut self.of_column[columns.column(row) as usize];
            *largest = largest.max(reach);
        }
        self.largest = self.of_column.iter().fold(0.0, |a, &b| a.max(b));
        self.of_row.extend([0.0; WIDTH]);
    }

    /// That of all, m, if it is the same.
    #[inline(always)]
    pub(crate) fn same(&self) -> Option<f64> {
        self.same
    }

    /// Of one point, m.
    #[inline(always)]
    pub(crate) fn of(&self, row: usize) -> f64 {
        self.same.unwrap_or_else(|| self.of_row[row])
    }

    /// Of eight sorted points from `row` on, m, where it is not the same.
    #[inline(always)]
    pub(crate) fn lane<S: Simd>(&self, simd: S, row: usize) -> Lane<S> {
        Lane::load_slice(simd, &self.of_row[row..])
    }

    /// The largest of a column, m.
    #[inline(always)]
    pub(crate) fn of_column(&self, column: usize) -> f64 {
        self.same.unwrap_or_else(|| self.of_column[column])
    }

    /// The largest of all, m.
    pub(crate) fn largest(&self) -> f64 {
        self.largest
    }

    pub(crate) fn bytes(&self) -> usize {
        (self.of_row.capacity() + self.of_column.capacity()) * size_of::<f64>()
    }
}
