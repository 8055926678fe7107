//! The region of the flow: which axes repeat.

use crate::vector::Vector;

/// The region of the flow: for each axis, where it repeats, if it does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Domain<const D: usize> {
    /// (low, high) in metres of each periodic axis.
    pub periodic: [Option<(f64, f64)>; D],
}

impl<const D: usize> Default for Domain<D> {
    fn default() -> Self {
        Self {
            periodic: [None; D],
        }
    }
}

impl<const D: usize> Domain<D> {
    /// Moves a point by whole periods into the box.
    pub fn wrap(&self, point: &mut Vector<f64, D>) {
        for d in 0..D {
            if let Some((low, high)) = self.periodic[d] {
                let period = high - low;
                let shift = ((point[d] - low) / period).floor();
                if shift != 0.0 {
                    point[d] -= shift * period;
                }
                if point[d] >= high {
                    point[d] = low;
                }
            }
        }
    }

    /// Hands out `offset` to all images of a point that may be nearer than `reach` metres.
    pub(crate) fn for_each_image(
        &self,
        offset: Vector<f64, D>,
        reach: f64,
        visit: &mut impl FnMut(Vector<f64, D>),
    ) {
        let mut copies = [(0_i64, 0.0); D];
        for (copies, axis) in copies.iter_mut().zip(self.periodic) {
            if let Some((low, high)) = axis {
                *copies = ((reach / (high - low)).ceil() as i64 + 1, high - low);
            }
        }
        let combinations: i64 = copies.iter().map(|(n, _)| 2 * n + 1).product();
        for combination in 0..combinations {
            let mut rest = combination;
            let mut shifted = offset;
            for (d, (n, period)) in copies.iter().enumerate() {
                shifted[d] += (rest % (2 * n + 1) - n) as f64 * period;
                rest /= 2 * n + 1;
            }
            visit(shifted);
        }
    }

    /// Whether any axis is periodic.
    pub fn is_periodic(&self) -> bool {
        self.periodic.iter().any(Option::is_some)
    }
}
