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

use super::viscosity::{ViscosityForm, artificial, harmonic_mean, monaghan_cleary, morris};
use crate::fluid::Fluid;
use crate::particles::Particles;
use crate::real::Real;
use crate::record;
use crate::term::{Pair, PairTerm, Record};
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

/// The pressure gradient of one pair: a form known to the compiler, or chosen at run time.
pub trait PressureGradient: Copy + Sync {
    /// What a particle of this pressure (Pa) and density (kg/m^3) brings to a pair.
    fn stress(self, pressure: f64, density: f64) -> f64;
    /// The factor of -grad W, m^5/(kg s^2) times kg. `masses` are those of i and j, kg.
    fn along_gradient<R: Real, const D: usize>(
        self,
        i: &Flowing<R, D>,
        j: &Flowing<R, D>,
        masses: (R, R),
    ) -> R;
}

/// [`PressureForm::OverDensitySquared`], known to the compiler.
#[derive(Clone, Copy, Debug)]
pub struct OverDensitySquared;

impl PressureGradient for OverDensitySquared {
    #[inline(always)]
    fn stress(self, pressure: f64, density: f64) -> f64 {
        pressure / (density * density)
    }
    #[inline(always)]
    fn along_gradient<R: Real, const D: usize>(
        self,
        i: &Flowing<R, D>,
        j: &Flowing<R, D>,
        (_, mass): (R, R),
    ) -> R {
        mass * (i.stress + j.stress)
    }
}

/// [`PressureForm::OverDensityProduct`], known to the compiler.
#[derive(Clone, Copy, Debug)]
pub struct OverDensityProduct;

impl PressureGradient for OverDensityProduct {
    #[inline(always)]
    fn stress(self, pressure: f64, _: f64) -> f64 {
        pressure
    }
    #[inline(always)]
    fn along_gradient<R: Real, const D: usize>(
        self,
        i: &Flowing<R, D>,
        j: &Flowing<R, D>,
        (_, mass): (R, R),
    ) -> R {
        mass * ((i.stress + j.stress) / (i.density * j.density))
    }
}

impl PressureGradient for Option<PressureForm> {
    fn stress(self, pressure: f64, density: f64) -> f64 {
        match self {
            Some(PressureForm::OverDensitySquared) => OverDensitySquared.stress(pressure, density),
            _ => pressure,
        }
    }
    #[inline(always)]
    fn along_gradient<R: Real, const D: usize>(
        self,
        i: &Flowing<R, D>,
        j: &Flowing<R, D>,
        masses: (R, R),
    ) -> R {
        match self {
            Some(PressureForm::OverDensitySquared) => {
                OverDensitySquared.along_gradient(i, j, masses)
            }
            Some(PressureForm::OverDensityProduct) => {
                OverDensityProduct.along_gradient(i, j, masses)
            }
            Some(PressureForm::HuAdams) => {
                let (own_mass, mass) = masses;
                let volumes = (own_mass / i.density).square() + (mass / j.density).square();
                let between =
                    (j.density * i.stress + i.density * j.stress) / (i.density + j.density);
                volumes * between / own_mass
            }
            None => i.density.zero(),
        }
    }
}

record! {
    /// What the momentum equation reads, beside the material.
    pub struct Flowing<R, D> {
        /// v, m/s
        velocity: Vector<R, D>,
        /// rho, kg/m^3
        density: R,
        /// p / rho^2, m^5/(kg s^2), for [`PressureForm::OverDensitySquared`]; p, Pa, for the others
        stress: R,
    }
}

/// What acts between two particles: factors of 0 or 1.
#[derive(Clone, Copy, Debug)]
pub struct Contact<R> {
    /// On the pressure gradient.
    pub pressure: R,
    /// On artificial and laminar viscosity.
    pub friction: R,
}

/// Where mass, sound speed and viscosity of a particle come from.
pub trait Material: Copy + Sync {
    /// Whether [`contact`](Self::contact) is ever other than 1.
    const WALLS: bool = false;
    /// See [`PairTerm::OFTEN`].
    const OFTEN: bool = true;
    /// What is read of a particle.
    type Record<R: Real>: Record<R>;
    /// The record of a particle of this mass (kg), fluid and body.
    fn record(&self, mass: f64, fluid: u16, body: u16) -> Self::Record<f64>;
    /// m, kg. `like` gives the width.
    fn mass<R: Real>(&self, record: &Self::Record<R>, like: R) -> R;
    /// c, m/s
    fn sound_speed<R: Real>(&self, record: &Self::Record<R>, like: R) -> R;
    /// mu, Pa s
    fn viscosity<R: Real>(&self, record: &Self::Record<R>, like: R) -> R;
    /// Harmonic mean of two viscosities, Pa s.
    #[inline(always)]
    fn mean_viscosity<R: Real>(&self, i: &Self::Record<R>, j: &Self::Record<R>, like: R) -> R {
        harmonic_mean(self.viscosity(i, like), self.viscosity(j, like))
    }
    /// What acts between two particles.
    #[inline(always)]
    fn contact<R: Real>(&self, _: &Self::Record<R>, _: &Self::Record<R>, like: R) -> Contact<R> {
        Contact {
            pressure: like.literal(1.0),
            friction: like.literal(1.0),
        }
    }
}

/// One fluid, all particles of one mass: nothing is read.
#[derive(Clone, Copy, Debug)]
pub struct OneFluid {
    mass: f64,
    sound_speed: f64,
    viscosity: f64,
}

impl OneFluid {
    /// Particles of `mass` kg of `fluid`.
    pub fn new(mass: f64, fluid: &Fluid) -> Self {
        Self {
            mass,
            sound_speed: fluid.sound_speed,
            viscosity: fluid.viscosity,
        }
    }
}

impl Material for OneFluid {
    type Record<R: Real> = ();

    fn record(&self, _: f64, _: u16, _: u16) {}

    #[inline(always)]
    fn mass<R: Real>(&self, (): &(), like: R) -> R {
        like.literal(self.mass)
    }
    #[inline(always)]
    fn sound_speed<R: Real>(&self, (): &(), like: R) -> R {
        like.literal(self.sound_speed)
    }
    #[inline(always)]
    fn viscosity<R: Real>(&self, (): &(), like: R) -> R {
        like.literal(self.viscosity)
    }
    #[inline(always)]
    fn mean_viscosity<R: Real>(&self, (): &(), (): &(), like: R) -> R {
        like.literal(self.viscosity)
    }
}

/// Any fluids and masses, by the fluid's index.
#[derive(Clone, Copy, Debug)]
pub struct Mixture<'a>(pub &'a [Fluid]);

record! {
    /// The material of one particle of a mixture.
    pub struct Substance<R, D> {
        /// m, kg
        mass: R,
        /// c, m/s
        sound_speed: R,
        /// mu, Pa s
        viscosity: R,
    }
}

impl Material for Mixture<'_> {
    type Record<R: Real> = Substance<R, 0>;
    const OFTEN: bool = false;

    fn record(&self, mass: f64, fluid: u16, _: u16) -> Substance<f64, 0> {
        let Fluid {
            sound_speed,
            viscosity,
            ..
        } = self.0[fluid as usize];
        Substance {
            mass,
            sound_speed,
            viscosity,
        }
    }

    #[inline(always)]
    fn mass<R: Real>(&self, record: &Substance<R, 0>, _: R) -> R {
        record.mass
    }
    #[inline(always)]
    fn sound_speed<R: Real>(&self, record: &Substance<R, 0>, _: R) -> R {
        record.sound_speed
    }
    #[inline(always)]
    fn viscosity<R: Real>(&self, record: &Substance<R, 0>, _: R) -> R {
        record.viscosity
    }
}

/// Sums to acceleration, m/s^2.
#[derive(Clone, Copy, Debug)]
pub struct Momentum<M, P = Option<PressureForm>> {
    /// Materials.
    pub material: M,
    /// Form of the pressure gradient, if it acts.
    pub pressure: P,
    /// alpha of the artificial viscosity; zero for none.
    pub artificial_viscosity: f64,
    /// Form of the laminar viscous force, if it acts.
    pub viscosity: Option<ViscosityForm>,
    /// h, m
    pub smoothing_length: f64,
}

impl<M: Material, P: PressureGradient, const D: usize> PairTerm<D> for Momentum<M, P> {
    type Record<R: Real> = (Flowing<R, D>, M::Record<R>);
    type Sum<R: Real> = Vector<R, D>;
    const OFTEN: bool = M::OFTEN;

    fn record(&self, particles: &Particles<D>, i: usize) -> (Flowing<f64, D>, M::Record<f64>) {
        let (density, pressure) = (particles.density[i], particles.pressure[i]);
        let stress = self.pressure.stress(pressure, density);
        let flowing = Flowing {
            velocity: particles.velocity[i],
            density,
            stress,
        };
        (
            flowing,
            self.material
                .record(particles.mass[i], particles.fluid[i], particles.body[i]),
        )
    }

    #[inline(always)]
    fn pair<R: Real>(
        &self,
        (i, i_material): &(Flowing<R, D>, M::Record<R>),
        (j, j_material): &(Flowing<R, D>, M::Record<R>),
        ij: &Pair<R, D>,
        sum: &mut Vector<R, D>,
    ) {
        let like = i.density;
        let mass = self.material.mass(j_material, like);
        let own_mass = self.material.mass(i_material, like);
        let mut along_gradient = (self.pressure).along_gradient(i, j, (own_mass, mass));
        let mut velocity_difference = i.velocity - j.velocity;
        if M::WALLS {
            let contact = self.material.contact(i_material, j_material, like);
            along_gradient = along_gradient * contact.pressure;
            velocity_difference = velocity_difference * contact.friction;
        }
        if self.artificial_viscosity != 0.0 {
            let h = self.smoothing_length;
            let sound_speeds = self.material.sound_speed(i_material, like)
                + self.material.sound_speed(j_material, like);
            let pi = artificial(
                self.artificial_viscosity * h,
                0.01 * h * h,
                &velocity_difference,
                sound_speeds,
                i.density + j.density,
                ij,
            );
            along_gradient = mass.mul_add(pi, along_gradient);
        }
        *sum = sum.add_scaled(ij.offset, -(ij.slope_over_distance * along_gradient));
        if let Some(form) = self.viscosity {
            let density_product = i.density * j.density;
            *sum += match form {
                ViscosityForm::Morris => {
                    let sum = self.material.viscosity(i_material, like)
                        + self.material.viscosity(j_material, like);
                    morris(sum, &velocity_difference, density_product, ij)
                }
                ViscosityForm::MonaghanCleary => {
                    let mean = self.material.mean_viscosity(i_material, j_material, like);
                    monaghan_cleary(mean, &velocity_difference, density_product, ij)
                }
                // It is no sum over one pair.
                ViscosityForm::Stress | ViscosityForm::StressAndRest => {
                    velocity_difference * like.zero()
                }
            } * mass;
        }
    }
}
