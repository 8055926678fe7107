//! Particles sorted into columns: a grid over all axes but the last, walked
//! like a snake, each column sorted along the last axis. Neighbours in this
//! order are neighbours in space, which makes clusters compact.

use rayon::prelude::*;

use crate::vector::Vector;

/// A sorted set of points and where each column of it begins.
#[derive(Debug)]
pub(crate) struct Columns<const D: usize> {
    /// Wanted width of a column, m.
    preferred_width: f64,
    width: f64,
    origin: [f64; D],
    /// Columns along each axis but the last, whose entry is 1.
    counts: [usize; D],
    /// First point of column `c`, in sorted order; one entry more than columns.
    starts: Vec<u32>,
    /// Column of each point, in sorted order.
    column: Vec<u32>,
    /// Last coordinate of each sorted point, negated in columns that run down.
    depth: Vec<f64>,
    /// Original index of each sorted point.
    order: Vec<u32>,
    keys: Vec<(f64, u32)>,
    unsorted_column: Vec<u32>,
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
            depth: Vec::new(),
            order: Vec::new(),
            keys: Vec::new(),
            unsorted_column: Vec::new(),
        }
    }

    /// Sorts `points`; row `k` of the sorted set is the former row `order()[k]`.
    pub(crate) fn sort(&mut self, points: &[Vector<f64, D>]) {
        self.lay_grid(points);
        let columns: usize = self.counts.iter().product();
        self.starts.clear();
        self.starts.resize(columns + 1, 0);
        self.unsorted_column.clear();
        for point in points {
            let column = self.column_of(point);
            self.unsorted_column.push(column as u32);
            self.starts[column + 1] += 1;
        }
        for c in 0..columns {
            self.starts[c + 1] += self.starts[c];
        }
        self.keys.clear();
        self.keys.resize(points.len(), (0.0, 0));
        for (i, point) in points.iter().enumerate() {
            let column = self.unsorted_column[i] as usize;
            // `starts` serves as the write position, and is moved back below.
            let slot = self.starts[column] as usize;
            self.starts[column] += 1;
            self.keys[slot] = (direction(column) * point[D - 1], i as u32);
        }
        for c in (1..=columns).rev() {
            self.starts[c] = self.starts[c - 1];
        }
        self.starts[0] = 0;
        sort_columns(&mut self.keys, &self.starts);
        self.depth.clear();
        self.depth.extend(self.keys.iter().map(|key| key.0));
        self.order.clear();
        self.order.extend(self.keys.iter().map(|key| key.1));
        self.column.clear();
        self.column
            .extend(self.order.iter().map(|&i| self.unsorted_column[i as usize]));
    }

    /// Former row of each sorted row.
    pub(crate) fn order(&self) -> &[u32] {
        &self.order
    }

    /// Column of a sorted row.
    pub(crate) fn column(&self, row: usize) -> u32 {
        self.column[row]
    }

    /// Calls `found` with each sorted row whose point, in `points`, lies
    /// within `reach` of the box from `low` to `high`, in a fixed order.
    pub(crate) fn near_box(
        &self,
        points: &[Vector<f64, D>],
        low: &[f64; D],
        high: &[f64; D],
        reach: f64,
        mut found: impl FnMut(u32),
    ) {
        if points.is_empty() {
            return;
        }
        let reach_squared = reach * reach;
        let mut first = [0; 2];
        let mut last = [0; 2];
        for d in 0..D - 1 {
            first[d] = self.cell(low[d] - reach, d);
            last[d] = self.cell(high[d] + reach, d);
        }
        for ix in first[0]..=last[0] {
            let gap_x = self.gap(ix, 0, low, high);
            for iy in first[1]..=last[1] {
                let gap_y = if D == 3 {
                    self.gap(iy, 1, low, high)
                } else {
                    0.0
                };
                let left = reach_squared - gap_x * gap_x - gap_y * gap_y;
                if left < 0.0 {
                    continue;
                }
                let column = self.ordinal(ix, iy);
                let sign = direction(column);
                let (a, b) = (sign * low[D - 1], sign * high[D - 1]);
                let half = left.sqrt();
                let from = a.min(b) - half;
                let to = a.max(b) + half;
                let start = self.starts[column] as usize;
                let end = self.starts[column + 1] as usize;
                let depth = &self.depth[start..end];
                let skip = depth.partition_point(|&z| z < from);
                for (k, &z) in depth.iter().enumerate().skip(skip) {
                    if z > to {
                        break;
                    }
                    let row = start + k;
                    if distance_squared_to_box(&points[row], low, high) <= reach_squared {
                        found(row as u32);
                    }
                }
            }
        }
    }

    fn lay_grid(&mut self, points: &[Vector<f64, D>]) {
        let (low, high) = bounds(points);
        self.origin = low;
        self.width = self.preferred_width;
        // A few stray particles far away must not cost a grid of empty columns.
        let most = 4.0 * points.len() as f64 + 64.0;
        loop {
            let mut total = 1.0;
            let mut counts = [1.0; D];
            for d in 0..D - 1 {
                // No place that is a number leaves -inf or NaN here.
                counts[d] = (((high[d] - low[d]) / self.width).floor() + 1.0).max(1.0);
                total *= counts[d];
            }
            if total <= most {
                self.counts = counts.map(|c| c as usize);
                return;
            }
            if !total.is_finite() {
                self.counts = [1; D];
                return;
            }
            self.width *= 1.5;
        }
    }

    fn cell(&self, x: f64, d: usize) -> usize {
        let cell = ((x - self.origin[d]) / self.width).max(0.0) as usize;
        cell.min(self.counts[d] - 1)
    }

    fn column_of(&self, point: &Vector<f64, D>) -> usize {
        let ix = self.cell(point[0], 0);
        let iy = if D == 3 { self.cell(point[1], 1) } else { 0 };
        self.ordinal(ix, iy)
    }

    /// Place of a column on the snake's way.
    fn ordinal(&self, ix: usize, iy: usize) -> usize {
        let across = if D == 3 { self.counts[1] } else { 1 };
        let iy = if ix % 2 == 0 { iy } else { across - 1 - iy };
        ix * across + iy
    }

    /// Distance along axis `d` between cell `cell` and the box; the outermost
    /// cells hold whatever lies beyond them by rounding.
    fn gap(&self, cell: usize, d: usize, low: &[f64; D], high: &[f64; D]) -> f64 {
        let slack = 1e-9 * self.width;
        let left = self.origin[d] + cell as f64 * self.width - slack;
        let right = left + self.width + 2.0 * slack;
        (left - high[d]).max(low[d] - right).max(0.0)
    }
}

/// +1 for columns that run up the last axis, -1 for those that run down.
fn direction(column: usize) -> f64 {
    if column.is_multiple_of(2) { 1.0 } else { -1.0 }
}

fn distance_squared_to_box<const D: usize>(
    point: &Vector<f64, D>,
    low: &[f64; D],
    high: &[f64; D],
) -> f64 {
    let mut sum = 0.0;
    for d in 0..D {
        let gap = (low[d] - point[d]).max(point[d] - high[d]).max(0.0);
        sum += gap * gap;
    }
    sum
}

/// Corners of the smallest box that holds all points; zero for no point.
fn bounds<const D: usize>(points: &[Vector<f64, D>]) -> ([f64; D], [f64; D]) {
    let empty = ([f64::INFINITY; D], [f64::NEG_INFINITY; D]);
    if points.is_empty() {
        return ([0.0; D], [0.0; D]);
    }
    points.iter().fold(empty, |(mut low, mut high), point| {
        for d in 0..D {
            low[d] = low[d].min(point[d]);
            high[d] = high[d].max(point[d]);
        }
        (low, high)
    })
}

/// Sorts each column by depth, ties by original index, halves in parallel.
fn sort_columns(keys: &mut [(f64, u32)], starts: &[u32]) {
    let columns = starts.len() - 1;
    if columns == 0 {
        return;
    }
    if columns == 1 {
        keys.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        return;
    }
    let middle = columns / 2;
    let (left, right) = keys.split_at_mut((starts[middle] - starts[0]) as usize);
    if keys_are_few(left) {
        sort_columns(left, &starts[..=middle]);
        sort_columns(right, &starts[middle..]);
    } else {
        rayon::join(
            || sort_columns(left, &starts[..=middle]),
            || sort_columns(right, &starts[middle..]),
        );
    }
}

fn keys_are_few(keys: &[(f64, u32)]) -> bool {
    keys.len() < 4096
}

/// Whether no row of `a` is farther than `distance` from that of `b`; a NaN is.
pub(crate) fn all_within<const D: usize>(
    distance: f64,
    a: &[Vector<f64, D>],
    b: &[Vector<f64, D>],
) -> bool {
    a.par_iter()
        .with_min_len(4096)
        .zip(b)
        .all(|(a, b)| (*a - *b).norm_squared() <= distance * distance)
}
