//! A grid that finds the points near a point.

use std::collections::HashMap;

use crate::vector::Vector;

/// Points by the cell they lie in.
pub(crate) struct Cells<const D: usize> {
    reach: f64,
    points: HashMap<[i64; D], Vec<(usize, Vector<f64, D>)>>,
}

impl<const D: usize> Cells<D> {
    /// Of points that look `reach` far, m.
    pub fn new(reach: f64) -> Self {
        Self {
            reach,
            points: HashMap::new(),
        }
    }

    fn cell(&self, x: &Vector<f64, D>) -> [i64; D] {
        x.0.map(|x| (x / self.reach).floor() as i64)
    }

    /// Adds a point with its number.
    pub fn add(&mut self, i: usize, x: Vector<f64, D>) {
        let home = self.cell(&x);
        self.points.entry(home).or_default().push((i, x));
    }

    /// Calls `found` with the number and the place of each point within reach of `x`.
    pub fn near(&self, x: &Vector<f64, D>, mut found: impl FnMut(usize, Vector<f64, D>)) {
        let home = self.cell(x);
        for k in 0..3_usize.pow(D as u32) {
            let mut there = home;
            for (d, c) in there.iter_mut().enumerate() {
                *c += (k / 3_usize.pow(d as u32) % 3) as i64 - 1;
            }
            for (j, y) in self.points.get(&there).into_iter().flatten() {
                if (*y - *x).norm_squared() < self.reach * self.reach {
                    found(*j, *y);
                }
            }
        }
    }
}
