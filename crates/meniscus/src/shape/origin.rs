//! Where a pattern starts that is told no origin.

use super::{Arrangement, Pattern, Shape};
use crate::vector::Vector;

/// Normals whose product is larger are not taken for perpendicular.
const SKEW: f64 = 1e-9;

impl<const D: usize> Arrangement<D> {
    /// The centre of a round shape, where a lattice has a particle; but half a period inside of a flat face that cuts it,
    /// such as that on a wall, and of the low corner of what is not round. Of faces that are not perpendicular the first counts.
    pub(super) fn fitted_origin(
        &self,
        shape: &Shape<D>,
        low: Vector<f64, D>,
        high: Vector<f64, D>,
    ) -> Vector<f64, D> {
        let centre = match self.pattern {
            Pattern::Stacked => shape.end_of_axis(),
            _ => shape.centre(),
        };
        let is_lattice = matches!(self.pattern, Pattern::Cubic | Pattern::ClosePacked);
        match centre {
            Some(centre) if is_lattice => self.inside_of_cuts(shape, centre, low, high),
            Some(centre) => centre,
            None if is_lattice => {
                let periods = self.periods();
                let part = self.parts();
                low + Vector(std::array::from_fn(|d| part[d] * periods[d] * self.spacing))
            }
            None => (low + high) * 0.5,
        }
    }

    /// Parts of a period from a wall to the first row. Rows that alternate between two places keep the same distance to both walls.
    fn parts(&self) -> [f64; 3] {
        match (self.pattern, D) {
            (Pattern::ClosePacked, 2) => [0.25, 0.5, 0.5],
            (Pattern::ClosePacked, _) => [0.25, 1.0 / 3.0, 0.5],
            _ => [0.5; 3],
        }
    }

    fn inside_of_cuts(
        &self,
        shape: &Shape<D>,
        centre: Vector<f64, D>,
        low: Vector<f64, D>,
        high: Vector<f64, D>,
    ) -> Vector<f64, D> {
        let (periods, part) = (self.periods(), self.parts());
        let mut origin = centre;
        let mut faces: Vec<Vector<f64, D>> = Vec::new();
        for (point, outward) in shape.cuts() {
            // How far the shape's box reaches beyond the face.
            let beyond: f64 = (0..D)
                .map(|d| {
                    let side = if outward[d] > 0.0 { high[d] } else { low[d] };
                    (side - point[d]) * outward[d]
                })
                .sum();
            let across = |face: &Vector<f64, D>| face.dot(&outward).abs() < SKEW;
            if beyond <= 0.0 || !faces.iter().all(across) {
                continue;
            }
            let along = (0..D).find(|&d| outward[d].abs() > 1.0 - SKEW);
            let half = along.map_or(0.5, |d| part[d] * periods[d]) * self.spacing;
            origin -= outward * ((origin - point).dot(&outward) + half);
            faces.push(outward);
        }
        origin
    }
}
