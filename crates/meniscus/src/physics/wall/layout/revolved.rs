//! The particles of a wall that is round about an axis: those of its profile, a polygon beside the
//! axis, each drawn out into a ring of particles a spacing apart.

use std::f64::consts::TAU;

use super::{Layers, Side, some};
use crate::shape::{FillError, Revolved, perpendiculars};
use crate::vector::Vector;

/// A ring this near the axis, in spacings, is the place of one particle.
const ON_THE_AXIS: f64 = 0.25;

impl Layers {
    /// A polygon turned about an axis; or all around it. An edge on the axis is no surface.
    ///
    /// # Errors
    /// As [`Arrangement::fill`](crate::shape::Arrangement::fill).
    pub fn revolved(&self, shape: &Revolved, side: Side) -> Result<Vec<Vector<f64, 3>>, FillError> {
        let axis = shape.direction();
        let farthest = shape.corners.iter().map(|corner| corner[1]);
        let beside = farthest.clone().all(|away| away >= 0.0);
        if !(axis.norm() > 0.0 && beside) {
            return Err(FillError::Empty);
        }
        let profile = self.polygon(&shape.both_halves(), side)?;
        let ring = |radius: f64| (TAU * radius / self.spacing).round().max(3.0);
        let widest = ring(farthest.fold(0.0, f64::max) + self.thickness());
        self.allow(widest * profile.len() as f64)?;
        let [across, aside] = perpendiculars(&axis);
        let mut positions = Vec::new();
        for place in profile {
            let (along, radius) = (shape.point + axis * place[0], place[1]);
            if radius.abs() <= ON_THE_AXIS * self.spacing {
                positions.push(along);
            } else if radius > 0.0 {
                let count = ring(radius);
                positions.extend((0..count as usize).map(|k| {
                    let (sin, cos) = (TAU * k as f64 / count).sin_cos();
                    along + across * (radius * cos) + aside * (radius * sin)
                }));
            }
        }
        some(positions)
    }
}
