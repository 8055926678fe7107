//! Diffusion of density in the continuity equation, against the noise of pressure that a weakly
//! compressible flow of particles makes:
//!
//! D rho_i / Dt += delta h c sum_j V_j psi_ij . grad W_ij,
//! psi_ij = 2 (rho_j - rho_i) (x_j - x_i) / |x_j - x_i|^2 - (g_i + g_j)
//!
//! - Antuono, Colagrossi, Marrone and Molteni (2010), Comput. Phys. Commun. 181, 532 (delta-SPH):
//!   g is the gradient of density, by CSPM. A linear density does not diffuse, up to free
//!   surfaces and walls: what is left is of fourth order.
//! - Molteni and Colagrossi (2009), Comput. Phys. Commun. 180, 861: g = 0. Of second order inside;
//!   at a free surface, where neighbours lie on one side, the layers of a liquid with weight
//!   drift apart.
//! - Fourtakas et al. (2019), Comput. Fluids 190, 346, to first order of density: g =
//!   rho_0 / c^2 times the body force, the gradient in a liquid at rest. As cheap, and such a
//!   liquid stays as it is.
//!
//! psi_ij . grad W_ij is antisymmetric, so the sum over all particles of V times the rate is zero
//! to rounding: what one particle takes on in volume another gives away. Masses do not change
//! anyhow. Density diffuses within a fluid alone, neither into walls nor into another fluid.

use super::surface_tension::gradient::Correctable;
use crate::fluid::Fluid;
use crate::particles::Particles;
use crate::real::Real;
use crate::record;
use crate::term::{Pair, PairTerm, Sweep};
use crate::vector::Vector;

/// Which part of the differences of density does not diffuse.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DiffusionForm {
    /// The linear part, by the corrected gradient of density.
    Antuono,
    /// None.
    MolteniColagrossi,
    /// That of a liquid at rest under the body force.
    Fourtakas,
}

/// Diffusion of density.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DensityDiffusion {
    /// Form.
    pub form: DiffusionForm,
    /// delta; 0.1 is usual, and more than 0.5 unstable at the acoustic limit of the step.
    pub strength: f64,
}

impl DensityDiffusion {
    /// The largest delta.
    pub const STRONGEST: f64 = 0.5;
}

record! {
    /// Volume, density and fluid.
    pub struct Filled<R, D> {
        /// V, m^D
        volume: R,
        /// rho, kg/m^3
        density: R,
        /// Index of the fluid
        fluid: R,
    }
}

impl<R: Real, const D: usize> Filled<R, D> {
    /// V of a neighbour, nothing if it is of another fluid.
    #[inline(always)]
    fn alike(&self, other: &Self) -> R {
        let one = self.volume.literal(1.0);
        other.volume * (one - (self.fluid - other.fluid).square()).positive()
    }
}

fn filled<const D: usize>(particles: &Particles<D>, i: usize) -> Filled<f64, D> {
    Filled {
        volume: particles.volume(i),
        density: particles.density[i],
        fluid: f64::from(particles.fluid[i]),
    }
}

/// Sums to the gradient of density within a fluid, kg/m^4, and what it must be divided by.
#[derive(Clone, Copy, Debug)]
pub struct DensityGradient;

impl<const D: usize> PairTerm<D> for DensityGradient {
    type Record<R: Real> = Filled<R, D>;
    type Sum<R: Real> = Correctable<R, D>;
    const OFTEN: bool = false;

    fn record(&self, particles: &Particles<D>, i: usize) -> Filled<f64, D> {
        filled(particles, i)
    }

    #[inline(always)]
    fn pair<R: Real>(
        &self,
        i: &Filled<R, D>,
        j: &Filled<R, D>,
        ij: &Pair<R, D>,
        sum: &mut Correctable<R, D>,
    ) {
        sum.add(ij.grad_w * i.alike(j), j.density - i.density, &ij.offset);
    }
}

/// Sums to sum_j V_j psi_ij . grad W_ij, kg/m^5.
#[derive(Clone, Copy, Debug)]
pub struct Diffusion<'a, const D: usize> {
    /// g of each particle, kg/m^4.
    pub gradients: &'a [Vector<f64, D>],
}

impl<const D: usize> PairTerm<D> for Diffusion<'_, D> {
    type Record<R: Real> = (Filled<R, D>, Vector<R, D>);
    type Sum<R: Real> = R;
    const OFTEN: bool = false;

    fn record(&self, particles: &Particles<D>, i: usize) -> (Filled<f64, D>, Vector<f64, D>) {
        (filled(particles, i), self.gradients[i])
    }

    #[inline(always)]
    fn pair<R: Real>(
        &self,
        (i, gradient): &(Filled<R, D>, Vector<R, D>),
        (j, other_gradient): &(Filled<R, D>, Vector<R, D>),
        ij: &Pair<R, D>,
        sum: &mut R,
    ) {
        let step = j.density - i.density;
        let linear = (*gradient + *other_gradient).dot(&ij.offset);
        *sum = *sum - (step + step + linear) * (ij.slope_over_distance * i.alike(j));
    }
}

/// Columns that diffusion needs on its way.
#[derive(Debug, Default)]
pub struct Diffusing<const D: usize> {
    sums: Vec<Correctable<f64, D>>,
    gradients: Vec<Vector<f64, D>>,
    flux: Vec<f64>,
}

impl<const D: usize> Diffusing<D> {
    /// Adds (1/rho) D rho / Dt, 1/s, of `diffusion` in a body force of `gravity`, m/s^2.
    /// Walls must have no volume.
    #[expect(clippy::too_many_arguments, reason = "state, material and result")]
    pub fn add(
        &mut self,
        diffusion: DensityDiffusion,
        sweep: &mut impl Sweep<D>,
        particles: &Particles<D>,
        fluids: &[Fluid],
        smoothing_length: f64,
        gravity: Vector<f64, D>,
        rate: &mut [f64],
    ) {
        let of = |i: usize| &fluids[particles.fluid[i] as usize];
        self.gradients.clear();
        match diffusion.form {
            DiffusionForm::Antuono => {
                sweep.sweep(&DensityGradient, particles, |_| true, &mut self.sums);
                self.gradients
                    .extend(self.sums.iter().map(Correctable::corrected));
            }
            DiffusionForm::MolteniColagrossi => {
                self.gradients.resize(particles.len(), Vector::ZERO);
            }
            DiffusionForm::Fourtakas => self.gradients.extend((0..particles.len()).map(|i| {
                let fluid = of(i);
                gravity * (fluid.density / fluid.sound_speed.powi(2))
            })),
        }
        let gradients = &self.gradients;
        let term = Diffusion { gradients };
        sweep.sweep(&term, particles, |_| true, &mut self.flux);
        for (i, (rate, flux)) in rate.iter_mut().zip(&self.flux).enumerate() {
            let spread = diffusion.strength * smoothing_length * of(i).sound_speed;
            *rate += spread * flux / particles.density[i];
        }
    }
}
