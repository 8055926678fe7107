//! Values where a field on a mesh has none: weighted means over cells of two nodes along each axis, then of
//! two such cells, until everything is one cell, and back, each cell taking from the coarser ones what it lacks
//! (the pull and push of Gortler and others 1996, for pictures).

use rayon::prelude::*;

use super::Mesh;

/// Cells that one task works on.
const CELLS_PER_TASK: usize = 4096;

/// Columns that filling needs on its way.
#[derive(Debug, Default)]
pub(in crate::physics::surface_tension) struct Fill<const D: usize> {
    levels: Vec<Level<D>>,
}

/// A mesh of cells, the value of each times its weight, and the weight.
#[derive(Debug, Default)]
struct Level<const D: usize> {
    size: Size<D>,
    cells: Vec<(f64, f64)>,
    values: Vec<f64>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Size<const D: usize>([usize; D]);

impl<const D: usize> Default for Size<D> {
    fn default() -> Self {
        Self([0; D])
    }
}

impl<const D: usize> Size<D> {
    fn cells(self) -> usize {
        self.0.iter().product()
    }

    fn place(self, mut cell: usize) -> [usize; D] {
        let mut at = [0; D];
        for d in (0..D).rev() {
            at[d] = cell % self.0[d];
            cell /= self.0[d];
        }
        at
    }

    fn cell(self, at: [usize; D]) -> usize {
        at.iter()
            .zip(self.0)
            .fold(0, |sum, (at, size)| sum * size + at)
    }
}

/// The 2^D corners of a cube.
fn corners<const D: usize>() -> impl Iterator<Item = [usize; D]> {
    (0..1_usize << D).map(|corner| std::array::from_fn(|d| corner >> d & 1))
}

impl<const D: usize> Mesh<D> {
    /// Mixes into the values at the nodes those of around, with a weight of `least`, and where `weight` is zero
    /// nothing else.
    pub fn fill(&self, values: &mut [f64], weight: &[f64], least: f64, fill: &mut Fill<D>) {
        let depth = self
            .size
            .iter()
            .map(|&n| n.next_power_of_two().trailing_zeros())
            .max();
        let depth = depth.unwrap_or(0) as usize + 1;
        fill.levels.resize_with(depth, Level::default);
        let finest = &mut fill.levels[0];
        finest.size = Size(self.size);
        finest.cells.clear();
        (finest.cells)
            .extend((values.iter().zip(weight)).map(|(value, weight)| (value * weight, *weight)));
        for k in 1..depth {
            let (fine, coarse) = fill.levels.split_at_mut(k);
            coarse[0].gather(&fine[k - 1]);
        }
        for k in (0..depth).rev() {
            let (fine, coarse) = fill.levels.split_at_mut(k + 1);
            fine[k].spread(coarse.first(), least);
        }
        values.copy_from_slice(&fill.levels[0].values);
    }
}

impl<const D: usize> Level<D> {
    /// Adds up the cells of a finer level.
    fn gather(&mut self, fine: &Self) {
        self.size = Size(fine.size.0.map(|n| n.div_ceil(2)));
        self.cells.resize(self.size.cells(), (0.0, 0.0));
        let size = self.size;
        let add = |cell: usize| {
            let at = size.place(cell);
            let mut sum = (0.0, 0.0);
            for corner in corners::<D>() {
                let to: [usize; D] = std::array::from_fn(|d| 2 * at[d] + corner[d]);
                if (0..D).all(|d| to[d] < fine.size.0[d]) {
                    let (value, weight) = fine.cells[fine.size.cell(to)];
                    sum.0 += value;
                    sum.1 += weight;
                }
            }
            sum
        };
        (self.cells.par_iter_mut().enumerate())
            .with_min_len(CELLS_PER_TASK)
            .for_each(|(cell, sum)| *sum = add(cell));
    }

    /// Values, with a share of those of a coarser level between whose cells they lie.
    fn spread(&mut self, coarse: Option<&Self>, least: f64) {
        let (size, cells) = (self.size, &self.cells);
        let value = |cell: usize| {
            let (value, weight) = cells[cell];
            let Some(coarse) = coarse else {
                return if weight > 0.0 { value / weight } else { 0.0 };
            };
            let at = size.place(cell);
            let mut around = 0.0;
            for corner in corners::<D>() {
                let mut share = 1.0;
                let to: [usize; D] = std::array::from_fn(|d| {
                    let near = at[d] / 2;
                    share *= [0.75, 0.25][corner[d]];
                    match (corner[d], at[d] % 2) {
                        (0, _) => near,
                        (_, 0) => near.saturating_sub(1),
                        _ => (near + 1).min(coarse.size.0[d] - 1),
                    }
                });
                around += share * coarse.values[coarse.size.cell(to)];
            }
            (value + least * around) / (weight + least)
        };
        self.values.resize(cells.len(), 0.0);
        (self.values.par_iter_mut().enumerate())
            .with_min_len(CELLS_PER_TASK)
            .for_each(|(cell, to)| *to = value(cell));
    }
}
