//! What makes sigma what it says.
//!
//! The force of eq. 21 adds up to s kappa sigma sum |n| V over a unit of area. The paper
//! takes s = 2 for a free surface and 1 between two fluids (eqs. 21, 22). At a free
//! surface the colour falls from 1 to a little over 1/2 at the outermost particle, so that
//! sum |n| V is less than 1/2: with 2, sigma comes out at 0.72 (CSPM) or 0.47 (Morris) of
//! its value for the cubic spline with h = 2 dx. The default measures
//! sum |n| V on a flat layer of the same kernel, h and spacing, and divides by it.
//!
//! The normals lie in a layer whose mean depth, sum |n| V z / sum |n| V, is
//! somewhat more than a spacing below a free surface. There curvature is that of
//! the parallel surface at that depth: 1 / (R - z). The default gives
//! back the curvature of the surface itself. With k_1 and k_2 the principal curvatures
//! found, it is k_1 / (1 + k_1 z) + k_2 / (1 + k_2 z).

use super::super::gradient::CorrectedGradient;
use super::super::matrix::Matrix;
use super::super::surface::Surface;
use super::{Continuum, FlatLayer, Form, Surroundings};
use crate::term::Sweep;

/// What the force is multiplied by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Calibration {
    /// What makes the force on a flat layer add up to sigma, with the curvature of the surface.
    FlatLayer,
    /// As printed: 2 for a free surface, 1 between two fluids, with the curvature of the layer.
    Printed,
}

/// What a flat layer tells.
#[derive(Clone, Copy, Debug)]
pub(in super::super) struct Calibrated {
    /// s
    pub(in super::super) strength: f64,
    /// z, m
    depth: f64,
}

impl Default for Calibrated {
    fn default() -> Self {
        Self {
            strength: 1.0,
            depth: 0.0,
        }
    }
}

impl Calibrated {
    /// Curvature of the surface from the gradient of normals in the layer, 1/m.
    pub(super) fn curvature_of<const D: usize>(self, gradient: &Matrix<f64, D>) -> f64 {
        let sum = -gradient.trace();
        // k_1 k_2; in the plane there is one curvature.
        let product = match D {
            2 => 0.0,
            _ => 0.5 * (sum * sum - gradient.trace_of_square()),
        };
        self.at_surface(sum, product)
    }

    /// The same from the sum of the principal curvatures alone, which count as equal.
    pub(super) fn curvature<const D: usize>(self, sum: f64) -> f64 {
        let product = if D == 2 { 0.0 } else { 0.25 * sum * sum };
        self.at_surface(sum, product)
    }

    fn at_surface(self, sum: f64, product: f64) -> f64 {
        let z = self.depth;
        // A hollow narrower than twice the depth is not resolved.
        let narrowing = (1.0 + sum * z + product * z * z).max(0.5);
        (sum + 2.0 * product * z) / narrowing
    }
}

impl Continuum {
    /// Measures strength and depth on a flat layer, whose particles `sweep` knows.
    pub fn calibrate<const D: usize>(
        &self,
        sweep: &mut impl Sweep<D>,
        layer: &FlatLayer<D>,
        surroundings: Surroundings<'_>,
        surface: &mut Surface<D>,
    ) {
        surface.continuum.calibration = Some(match self.calibration {
            Calibration::Printed => Calibrated {
                strength: if surroundings.has_interface() {
                    1.0
                } else {
                    2.0
                },
                depth: 0.0,
            },
            Calibration::FlatLayer => {
                self.find_normals(sweep, &layer.particles, surroundings, surface);
                let shortest = self.shortest(surroundings);
                let length = |i: usize| {
                    let length = surface.normal[i].norm();
                    if length >= shortest { length } else { 0.0 }
                };
                let sum = match self.form {
                    Form::Force | Form::Balanced => layer.integral(length),
                    Form::Stress => {
                        let term = CorrectedGradient {
                            values: &surface.colour,
                        };
                        let mut sums = Vec::new();
                        sweep.sweep(&term, &layer.particles, |_| true, &mut sums);
                        layer.integral(|i| length(i) * sums[i].matrix.0[0][0])
                    }
                };
                Calibrated {
                    strength: 1.0 / sum,
                    depth: layer.integral(|i| length(i) * layer.depth(i)) / layer.integral(length),
                }
            }
        });
    }
}
