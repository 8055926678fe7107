//! The viscous force as the divergence of the stress, in two sweeps:
//!
//! - G_i = sum_j V_j (v_j - v_i) grad W_ij A_i^-1               gradient of velocity, by CSPM
//! - S_i = mu_i (G_i + G_i^T) A_i^-1
//! - a_i = 1/rho_i sum_j V_j (S_i + S_j) grad W_ij
//!
//! with A_i = sum_j V_j (x_j - x_i) grad W_ij. The second sum is the first one's
//! adjoint: what is lost is sum_i V_i mu_i (G + G^T) : G, the dissipation of the gradient
//! itself, up to a free surface, where other forms lose a part of it. Pairs
//! push each other, and since the stress is symmetric angular momentum is conserved
//! as well. No traction at a free surface.
//!
//! Brookshaw's short forms ([`super::viscosity`]) need one sweep, and damp motion
//! at the scale of particles, which this form hardly sees. It can be told to add Morris's form of what the
//! gradient leaves:
//!
//! 1/rho_i sum_j V_j (mu_i + mu_j) (x_ij . grad W) / x_ij^2 [v_ij - 1/2 (G_i A_i^-1 + G_j A_j^-1) x_ij]
//!
//! nothing for a linear motion, and of the order of its third derivatives for a smooth one.

use std::ops::Range;

use rayon::prelude::*;

use super::stress_divergence::{StressDivergence, Weight};
use super::surface_tension::curvature::CorrectableDivergence;
use super::surface_tension::gradient::LEAST_MATRIX;
use super::surface_tension::matrix::Matrix;
use super::velocity_gradient::VelocityGradient;
use super::viscous_rest::{Rest, ViscousRest};
use crate::fluid::Fluid;
use crate::particles::{Particles, ROWS_PER_TASK};
use crate::term::Sweep;
use crate::vector::Vector;

/// Columns that the force needs on its way.
#[derive(Debug, Default)]
pub struct ViscousStress<const D: usize> {
    gradients: Vec<CorrectableDivergence<f64, D>>,
    stress: Vec<Matrix<f64, D>>,
    rest: Vec<Rest<f64, D>>,
    force: Vec<Vector<f64, D>>,
}

impl<const D: usize> ViscousStress<D> {
    /// Adds the viscous acceleration, m/s^2, to the rows that are `active`, which feel no others; `with_rest`, that of what the
    /// gradient leaves, too.
    pub fn accelerate(
        &mut self,
        sweep: &mut impl Sweep<D>,
        particles: &Particles<D>,
        active: impl Fn(Range<usize>) -> bool + Sync,
        fluids: &[Fluid],
        with_rest: bool,
        acceleration: &mut [Vector<f64, D>],
    ) {
        sweep.sweep(&VelocityGradient, particles, &active, &mut self.gradients);
        (self.gradients.par_iter(), &particles.fluid)
            .into_par_iter()
            .with_min_len(ROWS_PER_TASK)
            .map(|(sum, &fluid)| {
                let viscosity = fluids[fluid as usize].viscosity;
                let inverse = sum.matrix.inverse(LEAST_MATRIX);
                let gradient = sum.gradient();
                Matrix(std::array::from_fn(|d| {
                    let row = Vector(std::array::from_fn(|e| {
                        viscosity * (gradient.0[d][e] + gradient.0[e][d])
                    }));
                    inverse.times(&row)
                }))
            })
            .collect_into_vec(&mut self.stress);
        let stress = &self.stress;
        let term = StressDivergence {
            stress,
            weight: Weight::Volume,
        };
        sweep.sweep(&term, particles, &active, &mut self.force);
        add(&self.force, particles, acceleration);
        if with_rest {
            (self.gradients.par_iter().enumerate())
                .with_min_len(ROWS_PER_TASK)
                .map(|(i, sum)| Rest {
                    volume: particles.volume(i),
                    viscosity: fluids[particles.fluid[i] as usize].viscosity,
                    velocity: particles.velocity[i],
                    gradient: sum.gradient(),
                })
                .collect_into_vec(&mut self.rest);
            let term = ViscousRest { rest: &self.rest };
            sweep.sweep(&term, particles, &active, &mut self.force);
            add(&self.force, particles, acceleration);
        }
    }
}

/// Adds forces per volume, N/m^3, to accelerations.
fn add<const D: usize>(
    force: &[Vector<f64, D>],
    particles: &Particles<D>,
    acceleration: &mut [Vector<f64, D>],
) {
    for ((a, force), density) in (acceleration.iter_mut().zip(force)).zip(&particles.density) {
        *a += *force * (1.0 / density);
    }
}
