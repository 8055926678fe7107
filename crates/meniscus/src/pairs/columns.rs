//! Particles sorted into columns: a grid of cells whose columns, along the
//! last axis, are walked like a snake; within a cell particles are sorted
//! along that axis. Neighbours in this order are neighbours in space, which
//! makes clusters compact.

use fearless_simd::Simd;

use super::entries::Entries;
use super::lane::{Lane, WIDTH};
use super::reach::Reach;
use crate::real::Real;
use crate::vector::Vector;

/// Cells with more points than this are sorted by the library, not by insertion.
const SMALL_CELL: usize = 32;
/// Cells are sorted in parallel where there are at least this many points.
const POINTS_PER_TASK: usize = 4096;

/// A sorted set of points and where each cell of it begins.
#[derive(Debug)]
pub(crate) struct Columns<const D: usize> {
    /// Wanted width of a cell, m.
    preferred_width: f64,
    width: f64,
    origin: [f64; D],
    /// Cells along each axis.
    counts: [usize; D],
    /// First point of each cell, in sorted order; one entry more than cells.
    starts: Vec<u32>,
    /// Column of each point, in sorted order.
    column: Vec<u32>,
    /// Sorted coordinates, axis by axis, with a lane of infinities at the end.
    coordinates: [Vec<f64>; D],
    /// Original index of each sorted point.
    order: Vec<u32>,
    unsorted_cell: Vec<u32>,
}

impl<const D: usize> Columns<D> {
    pub(crate) fn new(preferred_width: f64) -> Self {
        Self {
            preferred_width,
            width: preferred_width,
            origin: [0.0; D],
            counts: [1; D],
            starts: vec![0, 0],
            column: Vec::new(),
            coordinates: std::array::from_fn(|_| vec![f64::INFINITY; WIDTH]),
            order: Vec::new(),
            unsorted_cell: Vec::new(),
        }
    }

    /// Sorts `points`; row `k` of the sorted set is the former row `order()[k]`.
    pub(crate) fn sort(&mut self, points: &[Vector<f64, D>]) {
        self.lay_grid(points);
        let cells: usize = self.counts.iter().product();
        self.starts.clear();
        self.starts.resize(cells + 1, 0);
        self.unsorted_cell.clear();
        for point in points {
            let cell = self.cell_of(point);
            self.unsorted_cell.push(cell);
            self.starts[cell as usize + 1] += 1;
        }
        for c in 0..cells {
            self.starts[c + 1] += self.starts[c];
        }
        self.order.clear();
        self.order.resize(points.len(), 0);
        for (i, &cell) in self.unsorted_cell.iter().enumerate() {
            // `starts` serves as the write position, and is moved back below.
            let slot = &mut self.starts[cell as usize];
            self.order[*slot as usize] = i as u32;
            *slot += 1;
        }
        for c in (1..=cells).rev() {
            self.starts[c] = self.starts[c - 1];
        }
        self.starts[0] = 0;
        let along = self.counts[D - 1];
        sort_cells(&mut self.order, &self.starts, 0, &|cell, a, b| {
            let sign = direction(cell / along);
            let depth = |i: u32| sign * points[i as usize][D - 1];
            depth(a).total_cmp(&depth(b))
        });
        self.column.clear();
        let cells = &self.unsorted_cell;
        (self.column).extend(self.order.iter().map(|&i| cells[i as usize] / along as u32));
        for (d, column) in self.coordinates.iter_mut().enumerate() {
            column.clear();
            column.extend(self.order.iter().map(|&i| points[i as usize][d]));
            column.extend([f64::INFINITY; WIDTH]);
        }
    }

    /// Former row of each sorted row.
    pub(crate) fn order(&self) -> &[u32] {
        &self.order
    }

    /// Number of columns.
    pub(crate) fn count(&self) -> usize {
        self.counts[..D - 1].iter().product()
    }

    /// Column of a sorted row.
    pub(crate) fn column(&self, row: usize) -> u32 {
        self.column[row]
    }

    /// Coordinate `d` of a sorted row.
    #[inline(always)]
    pub(crate) fn coordinate(&self, row: usize, d: usize) -> f64 {
        self.coordinates[d][row]
    }

    /// Coordinate `d` of up to eight sorted rows, the last one repeated.
    #[inline(always)]
    pub(crate) fn lane<S: Simd>(&self, simd: S, rows: std::ops::Range<usize>, d: usize) -> Lane<S> {
        let values =
            std::array::from_fn(|lane| self.coordinates[d][(rows.start + lane).min(rows.end - 1)]);
        Lane::load(simd, values)
    }

    /// Number of points.
    pub(crate) fn len(&self) -> usize {
        self.order.len()
    }

    /// Corners of the smallest box around these sorted rows.
    pub(crate) fn bounds_of(&self, rows: std::ops::Range<usize>) -> ([f64; D], [f64; D]) {
        let least = |column: &Vec<f64>| {
            column[rows.clone()]
                .iter()
                .fold(f64::INFINITY, |a, &b| a.min(b))
        };
        let most = |column: &Vec<f64>| {
            column[rows.clone()]
                .iter()
                .fold(f64::NEG_INFINITY, |a, &b| a.max(b))
        };
        (
            self.coordinates.each_ref().map(least),
            self.coordinates.each_ref().map(most),
        )
    }

    /// Appends `offset` plus each sorted row no farther from the box from `low` to `high` than
    /// `own` and the row reach together, in a fixed order.
    #[inline(always)]
    pub(crate) fn append_near<S: Simd>(
        &self,
        simd: S,
        (low, high): &([f64; D], [f64; D]),
        own: f64,
        reach: &Reach,
        offset: u32,
        entries: &mut Entries,
    ) {
        if self.order.is_empty() {
            return;
        }
        let farthest = own + reach.largest();
        let mut first = [0; 2];
        let mut last = [0; 2];
        for d in 0..D - 1 {
            first[d] = self.cell_along(low[d] - farthest, d);
            last[d] = self.cell_along(high[d] + farthest, d);
        }
        for ix in first[0]..=last[0] {
            let gap_x = self.gap(ix, 0, low, high);
            for iy in first[1]..=last[1] {
                let gap_y = if D == 3 {
                    self.gap(iy, 1, low, high)
                } else {
                    0.0
                };
                let column = self.snake(ix, iy);
                let both = own + reach.of_column(column);
                let left = both * both - gap_x * gap_x - gap_y * gap_y;
                if left < 0.0 {
                    continue;
                }
                let half = left.sqrt();
                let rows = self.rows(column, low[D - 1] - half, high[D - 1] + half);
                let mut row = rows.start;
                while row < rows.end {
                    let mut square = Lane::splat(simd, 0.0);
                    for d in 0..D {
                        let x = Lane::load_slice(simd, &self.coordinates[d][row..]);
                        let gap = (-(x - low[d])).max(x - high[d]).positive();
                        square = square + gap * gap;
                    }
                    let there = u8::MAX >> WIDTH.saturating_sub(rows.end - row);
                    let both = match reach.same() {
                        Some(_) => Lane::splat(simd, both),
                        None => reach.lane(simd, row) + own,
                    };
                    let near = square.not_above(both.square());
                    entries.append(offset + row as u32, near & there);
                    row += WIDTH;
                }
            }
        }
    }

    /// Sorted rows of the cells of a column from one depth to another.
    #[inline(always)]
    fn rows(&self, column: usize, from: f64, to: f64) -> std::ops::Range<usize> {
        let along = self.counts[D - 1];
        let (mut a, mut b) = (self.cell_along(from, D - 1), self.cell_along(to, D - 1));
        if direction(column) < 0.0 {
            (a, b) = (along - 1 - b, along - 1 - a);
        }
        let first = column * along;
        self.starts[first + a] as usize..self.starts[first + b + 1] as usize
    }

    fn lay_grid(&mut self, points: &[Vector<f64, D>]) {
        let (low, high) = bounds(points);
        self.origin = low;
        self.width = self.preferred_width;
        // A few stray particles far away must not cost a grid of empty cells.
        let most = 8.0 * points.len() as f64 + 64.0;
        loop {
            let counts: [f64; D] =
                std::array::from_fn(|d| ((high[d] - low[d]) / self.width).floor() + 1.0);
            let total: f64 = counts.iter().product();
            if total <= most {
                self.counts = counts.map(|c| c as usize);
                return;
            }
            if !total.is_finite() {
                self.counts = [1; D];
                return;
            }
            self.width *= 1.25;
        }
    }

    #[inline(always)]
    fn cell_along(&self, x: f64, d: usize) -> usize {
        let cell = ((x - self.origin[d]) / self.width).max(0.0) as usize;
        cell.min(self.counts[d] - 1)
    }

    fn cell_of(&self, point: &Vector<f64, D>) -> u32 {
        let ix = self.cell_along(point[0], 0);
        let iy = if D == 3 {
            self.cell_along(point[1], 1)
        } else {
            0
        };
        let column = self.snake(ix, iy);
        let along = self.counts[D - 1];
        let depth = self.cell_along(point[D - 1], D - 1);
        let depth = if direction(column) > 0.0 {
            depth
        } else {
            along - 1 - depth
        };
        (column * along + depth) as u32
    }

    /// Place of a column on the snake's way.
    #[inline(always)]
    fn snake(&self, ix: usize, iy: usize) -> usize {
        let across = if D == 3 { self.counts[1] } else { 1 };
        let iy = if ix.is_multiple_of(2) {
            iy
        } else {
            across - 1 - iy
        };
        ix * across + iy
    }

    /// Distance along axis `d` between cell `cell` and the box; the outermost
    /// cells hold whatever lies beyond them by rounding.
    #[inline(always)]
    fn gap(&self, cell: usize, d: usize, low: &[f64; D], high: &[f64; D]) -> f64 {
        let slack = 1e-9 * self.width;
        let left = self.origin[d] + cell as f64 * self.width - slack;
        let right = left + self.width + 2.0 * slack;
        (left - high[d]).max(low[d] - right).max(0.0)
    }
}

/// +1 for columns that run up the last axis, -1 for those that run down.
#[inline(always)]
fn direction(column: usize) -> f64 {
    if column.is_multiple_of(2) { 1.0 } else { -1.0 }
}

/// Corners of the smallest box that holds all points; zero for no point.
fn bounds<const D: usize>(points: &[Vector<f64, D>]) -> ([f64; D], [f64; D]) {
    let mut low = [f64::INFINITY; D];
    let mut high = [f64::NEG_INFINITY; D];
    for point in points {
        for d in 0..D {
            low[d] = low[d].min(point[d]);
            high[d] = high[d].max(point[d]);
        }
    }
    // No point, or none that is a number.
    if low.contains(&f64::INFINITY) {
        return ([0.0; D], [0.0; D]);
    }
    (low, high)
}

/// Sorts the points of each cell by depth, ties by original index, halves in
/// parallel. `starts` begins with cell `first`.
fn sort_cells(
    order: &mut [u32],
    starts: &[u32],
    first: usize,
    compare: &(impl Fn(usize, u32, u32) -> std::cmp::Ordering + Sync),
) {
    let cells = starts.len() - 1;
    if order.len() < POINTS_PER_TASK || cells < 2 {
        for cell in 0..cells {
            let range =
                (starts[cell] - starts[0]) as usize..(starts[cell + 1] - starts[0]) as usize;
            sort_cell(&mut order[range], |a, b| compare(first + cell, a, b));
        }
        return;
    }
    let middle = cells / 2;
    let (left, right) = order.split_at_mut((starts[middle] - starts[0]) as usize);
    rayon::join(
        || sort_cells(left, &starts[..=middle], first, compare),
        || sort_cells(right, &starts[middle..], first + middle, compare),
    );
}

fn sort_cell(order: &mut [u32], compare: impl Fn(u32, u32) -> std::cmp::Ordering) {
    let key = |&a: &u32, &b: &u32| compare(a, b).then(a.cmp(&b));
    if order.len() > SMALL_CELL {
        order.sort_unstable_by(key);
        return;
    }
    for k in 1..order.len() {
        let moving = order[k];
        let mut hole = k;
        while hole > 0 && key(&moving, &order[hole - 1]).is_lt() {
            order[hole] = order[hole - 1];
            hole -= 1;
        }
        order[hole] = moving;
    }
}
