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

    /// Whether any axis is periodic.
    pub fn is_periodic(&self) -> bool {
        self.periodic.iter().any(Option::is_some)
    }
}
