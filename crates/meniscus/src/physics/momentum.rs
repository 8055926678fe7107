//! The momentum equation of a weakly compressible fluid: pressure gradient,
//! artificial and laminar viscosity. Three discretisations of the pressure
//! gradient, each exactly antisymmetric in m_i a_ij:
//!
//! - a_i = -sum_j m_j (p_i/rho_i^2 + p_j/rho_j^2) grad W_ij
//!   (Jancik and Hyhlik, eq. 3)
//! - a_i = -sum_j m_j (p_i + p_j)/(rho_i rho_j) grad W_ij
//!   (Colagrossi and Landrini 2003)
//! - a_i = -1/m_i sum_j (V_i^2 + V_j^2) (rho_j p_i + rho_i p_j)/(rho_i + rho_j) grad W_ij
//!   (Hu and Adams 2006), steady across a jump of density

use super::viscosity::{ViscosityForm, artificial, monaghan_cleary, morris};
use crate::fluid::Fluid;
use crate::particles::Particles;
use crate::real::Real;
use crate::record;
use crate::term::{Pair, PairTerm};
use crate::vector::Vector;

/// How the pressure gradient is discretised. Each conserves linear momentum exactly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PressureForm {
    /// -sum m_j (p_i/rho_i^2 + p_j/rho_j^2) grad W
    OverDensitySquared,
    /// -sum m_j (p_i + p_j)/(rho_i rho_j) grad W
    OverDensityProduct,
    /// -1/m_i sum (V_i^2 + V_j^2) (rho_j p_i + rho_i p_j)/(rho_i + rho_j) grad W (Hu and Adams)
    HuAdams,
}

record! {
    /// What the momentum equation reads.
    pub struct Flowing<R, D> {
        /// v, m/s
        velocity: Vector<R, D>,
        /// m, kg
        mass: R,
        /// rho, kg/m^3
        density: R,
        /// p, Pa
        pressure: R,
        /// c, m/s
        sound_speed: R,
        /// mu, Pa s
        viscosity: R,
    }
}

/// Sums to acceleration, m/s^2.
#[derive(Clone, Copy, Debug)]
pub struct Momentum<'a> {
    /// Fluids by index.
    pub fluids: &'a [Fluid],
    /// Form of the pressure gradient, if it acts.
    pub pressure: Option<PressureForm>,
    /// alpha of the artificial viscosity; zero for none.
    pub artificial_viscosity: f64,
    /// Form of the laminar viscous force, if it acts.
    pub viscosity: Option<ViscosityForm>,
    /// h, m
    pub smoothing_length: f64,
}

impl<const D: usize> PairTerm<D> for Momentum<'_> {
    type Record<R: Real> = Flowing<R, D>;
    type Sum<R: Real> = Vector<R, D>;

    fn record(&self, particles: &Particles<D>, i: usize) -> Flowing<f64, D> {
        let fluid = &self.fluids[particles.fluid[i] as usize];
        Flowing {
            velocity: particles.velocity[i],
            mass: particles.mass[i],
            density: particles.density[i],
            pressure: particles.pressure[i],
            sound_speed: fluid.sound_speed,
            viscosity: fluid.viscosity,
        }
    }

    #[inline(always)]
    fn pair<R: Real>(
        &self,
        i: &Flowing<R, D>,
        j: &Flowing<R, D>,
        ij: &Pair<R, D>,
        sum: &mut Vector<R, D>,
    ) {
        let density_product = i.density * j.density;
        let mut along_gradient = i.mass.zero();
        match self.pressure {
            Some(PressureForm::OverDensitySquared) => {
                along_gradient =
                    j.mass * (i.pressure / i.density.square() + j.pressure / j.density.square());
            }
            Some(PressureForm::OverDensityProduct) => {
                along_gradient = j.mass * ((i.pressure + j.pressure) / density_product);
            }
            Some(PressureForm::HuAdams) => {
                let volumes = (i.mass / i.density).square() + (j.mass / j.density).square();
                let between =
                    (j.density * i.pressure + i.density * j.pressure) / (i.density + j.density);
                along_gradient = volumes * between / i.mass;
            }
            None => {}
        }
        let velocity_difference = i.velocity - j.velocity;
        if self.artificial_viscosity != 0.0 {
            let h = self.smoothing_length;
            let pi = artificial(
                self.artificial_viscosity * h,
                0.01 * h * h,
                &velocity_difference,
                (i.sound_speed + j.sound_speed) * 0.5,
                (i.density + j.density) * 0.5,
                ij,
            );
            along_gradient = along_gradient + j.mass * pi;
        }
        *sum -= ij.grad_w * along_gradient;
        let viscosities = (i.viscosity, j.viscosity);
        match self.viscosity {
            Some(ViscosityForm::Morris) => {
                *sum += morris(viscosities, &velocity_difference, density_product, ij) * j.mass;
            }
            Some(ViscosityForm::MonaghanCleary) => {
                *sum += monaghan_cleary(viscosities, &velocity_difference, density_product, ij)
                    * j.mass;
            }
            None => {}
        }
    }
}
