//! A field on a mesh that is known at some nodes, and elsewhere the mean of what is around: the solution u of
//!
//! w_i (u_i - v_i) = c sum_j (u_j - u_i)
//!
//! over the neighbours j along each axis, with weights w where the field is known to be v and zero elsewhere. At the edges of
//! the mesh it does not change across them.
//!
//! By multigrid (Brandt 1977): cells of two nodes along each axis, of two such cells, and on until everything is one cell. A coarser cell
//! takes the sums of w and of w v, and links of c 2^(D - 2): as wide as 2^(D - 1), and twice as long. From the coarsest on each
//! level starts with what lies between the cells of the one before; cycles over all levels then take the error away.
//! In a cycle every level asks the next coarser one twice (W-cycle): coarse cells join what a surface or a wall holds apart, and make
//! errors that only their own cycles take away. After two cycles kappa of a cap of 30 degrees is right within 0.006 of its 1/R; asked once, within 0.1.

use rayon::prelude::*;

use super::Mesh;

/// Cells that one task works on.
const CELLS_PER_TASK: usize = 4096;
/// Passes before and after a coarser level is asked.
const PASSES: usize = 2;
/// How often a cycle asks a coarser level.
const TURNS: usize = 2;
/// The part of a change that a pass makes, or values of neighbours would change places for ever.
const DAMPING: f64 = 0.8;

/// Columns on the way.
#[derive(Debug, Default)]
pub(in crate::physics::surface_tension) struct Harmonic<const D: usize> {
    levels: Vec<Level<D>>,
}

/// A mesh of cells.
#[derive(Debug, Default)]
struct Level<const D: usize> {
    size: Size<D>,
    /// c
    link: f64,
    /// w
    weight: Vec<f64>,
    /// w v, or what is left of it.
    right: Vec<f64>,
    /// u
    values: Vec<f64>,
    spare: Vec<f64>,
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

fn set(column: &mut Vec<f64>, length: usize, value: impl Fn(usize) -> f64 + Sync) {
    column.resize(length, 0.0);
    (column.par_iter_mut().enumerate())
        .with_min_len(CELLS_PER_TASK)
        .for_each(|(cell, to)| *to = value(cell));
}

impl<const D: usize> Mesh<D> {
    /// Makes `values` harmonic: where `weight` is 1 they stay nearly as they are, by links of `link`, and where it is
    /// zero their own do not count. All zero where all weights are.
    pub fn make_harmonic(
        &self,
        values: &mut [f64],
        weight: &[f64],
        link: f64,
        cycles: usize,
        harmonic: &mut Harmonic<D>,
    ) {
        let depth = (self.size.iter())
            .map(|&n| n.next_power_of_two().trailing_zeros() as usize)
            .max()
            .unwrap_or(0);
        let levels = &mut harmonic.levels;
        levels.resize_with(depth + 1, Level::default);
        let finest = &mut levels[0];
        finest.size = Size(self.size);
        finest.link = link;
        set(&mut finest.weight, values.len(), |i| weight[i]);
        set(&mut finest.right, values.len(), |i| weight[i] * values[i]);
        for k in 1..=depth {
            let (fine, coarse) = levels.split_at_mut(k);
            coarse[0].weigh(&fine[k - 1]);
            coarse[0].gather(fine[k - 1].size, &fine[k - 1].right);
        }
        levels[depth].end();
        for k in (0..depth).rev() {
            let (fine, coarse) = levels.split_at_mut(k + 1);
            fine[k].start();
            fine[k].correct(&coarse[0]);
            fine[k].relax(PASSES);
        }
        for _ in 0..cycles {
            cycle(levels);
        }
        values.copy_from_slice(&levels[0].values);
    }
}

/// Takes off the error of the finest of these.
fn cycle<const D: usize>(levels: &mut [Level<D>]) {
    let [fine, coarser @ ..] = levels else {
        return;
    };
    let Some(coarse) = coarser.first_mut() else {
        fine.end();
        return;
    };
    fine.relax(PASSES);
    fine.find_rest();
    coarse.gather(fine.size, &fine.spare);
    coarse.start();
    for _ in 0..TURNS {
        cycle(coarser);
    }
    fine.correct(&coarser[0]);
    fine.relax(PASSES);
}

impl<const D: usize> Level<D> {
    /// Takes size, links and weights from a finer level.
    fn weigh(&mut self, fine: &Self) {
        self.size = Size(fine.size.0.map(|n| n.div_ceil(2)));
        self.link = fine.link * 2_f64.powi(D as i32 - 2);
        let size = self.size;
        set(&mut self.weight, size.cells(), |cell| {
            size.sum(cell, fine.size, &fine.weight)
        });
    }

    /// Takes the sums over its cells for its right side.
    fn gather(&mut self, of: Size<D>, fine: &[f64]) {
        let size = self.size;
        set(&mut self.right, size.cells(), |cell| {
            size.sum(cell, of, fine)
        });
    }

    fn start(&mut self) {
        self.values.clear();
        self.values.resize(self.size.cells(), 0.0);
    }

    /// What a single cell has.
    fn end(&mut self) {
        let (right, weight) = (&self.right, &self.weight);
        set(&mut self.values, right.len(), |cell| {
            ratio(right[cell], weight[cell])
        });
    }

    /// Jacobi's passes.
    fn relax(&mut self, passes: usize) {
        let (size, link) = (self.size, self.link);
        let links = 2.0 * D as f64 * link;
        for _ in 0..passes {
            let (from, right, weight) = (&self.values, &self.right, &self.weight);
            size.by_neighbours(from, &mut self.spare, |cell, around| {
                let to = (right[cell] + link * around) / (weight[cell] + links);
                from[cell] + DAMPING * (to - from[cell])
            });
            std::mem::swap(&mut self.values, &mut self.spare);
        }
    }

    /// What the values leave of the right side, into the spare column.
    fn find_rest(&mut self) {
        let (size, link) = (self.size, self.link);
        let links = 2.0 * D as f64 * link;
        let (of, right, weight) = (&self.values, &self.right, &self.weight);
        size.by_neighbours(of, &mut self.spare, |cell, around| {
            right[cell] + link * around - (weight[cell] + links) * of[cell]
        });
    }

    /// Adds what lies between the cells of a coarser level.
    fn correct(&mut self, coarse: &Self) {
        let size = self.size;
        let more = |at: [usize; D]| -> f64 {
            let share = |corner: [usize; D]| {
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
                share * coarse.values[coarse.size.cell(to)]
            };
            corners::<D>().map(share).sum()
        };
        size.by_rows(&mut self.values, |start, row| {
            let mut at = size.place(start);
            for value in row {
                *value += more(at);
                at[D - 1] += 1;
            }
        });
    }
}

impl<const D: usize> Size<D> {
    /// Works on the rows of cells along the last axis, with the first cell of each.
    fn by_rows(self, column: &mut [f64], work: impl Fn(usize, &mut [f64]) + Sync) {
        let length = self.0[D - 1];
        (column.par_chunks_mut(length).enumerate())
            .with_min_len(CELLS_PER_TASK.div_ceil(length))
            .for_each(|(row, cells)| work(row * length, cells));
    }

    /// What each cell comes to by the sum of its neighbours; beyond an edge it is its own.
    fn by_neighbours(
        self,
        of: &[f64],
        to: &mut Vec<f64>,
        value: impl Fn(usize, f64) -> f64 + Sync,
    ) {
        to.resize(of.len(), 0.0);
        self.by_rows(to, |start, row| {
            let (at, length) = (self.place(start), row.len());
            // The starts of the rows on either side.
            let mut beside = [[start; 2]; D];
            let mut stride = length;
            for d in (0..D - 1).rev() {
                if at[d] > 0 {
                    beside[d][0] -= stride;
                }
                if at[d] + 1 < self.0[d] {
                    beside[d][1] += stride;
                }
                stride *= self.0[d];
            }
            for (k, to) in row.iter_mut().enumerate() {
                let cell = start + k;
                let mut sum = of[cell - usize::from(k > 0)];
                sum += of[cell + usize::from(k + 1 < length)];
                for [before, after] in beside[..D - 1].iter().rev() {
                    sum += of[before + k];
                    sum += of[after + k];
                }
                *to = value(cell, sum);
            }
        });
    }

    /// What the nodes of a cell add up to.
    fn sum(self, cell: usize, fine: Self, of: &[f64]) -> f64 {
        let at = self.place(cell);
        let mut sum = 0.0;
        for corner in corners::<D>() {
            let to: [usize; D] = std::array::from_fn(|d| 2 * at[d] + corner[d]);
            if (0..D).all(|d| to[d] < fine.0[d]) {
                sum += of[fine.cell(to)];
            }
        }
        sum
    }
}

fn ratio(sum: f64, weight: f64) -> f64 {
    if weight > 0.0 { sum / weight } else { 0.0 }
}
