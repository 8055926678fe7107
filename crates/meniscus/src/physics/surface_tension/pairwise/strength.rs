//! How strong the forces of a model are: G of a fluid, and B between it and a wall, with
//! F = -B m_i Psi_j a(r) e on a particle i of the fluid and j of the wall.

use std::f64::consts::PI;

use super::akinci::{Akinci, Normalisation, Reading};
use super::estimate::{Resolution, moment};
use super::{Attraction, Pairwise, akinci};
use crate::fluid::Fluid;

/// What a wall does to the fluid against it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Adhesion {
    /// It does not attract it.
    #[default]
    None,
    /// beta of Akinci's adhesion, eq. 3.7, in the units of gamma.
    Coefficient(f64),
    /// The contact angle, rad, that it is to have: 0 for complete wetting, pi for none. Psi is the
    /// mass of the wall's particle: by eq. 3.8 those at the surface stand for too much.
    ContactAngle(f64),
}

/// Which forces of pairs the pressure of a wall balances, as it does the body force.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Bearing {
    /// None: the wall has the pressure that the fluid has in bulk, where cohesion has to be borne,
    /// while cohesion draws the fluid from it.
    Nothing,
    /// Adhesion (Gonzalez, eq. 4.7).
    Adhesion,
    /// Cohesion and adhesion.
    #[default]
    Pairs,
}

impl Pairwise {
    /// G of a fluid: that of its surface tension, times its factor, or of gamma. m^4/(kg s^2) times 1/m^D.
    pub fn strength(&self, fluid: &Fluid, resolution: &Resolution) -> f64 {
        match self.akinci().and_then(|akinci| akinci.gamma) {
            Some(gamma) => gamma * self.constant(resolution),
            None => {
                let asked = fluid.cohesion_factor * fluid.surface_tension;
                asked / self.tension_of_one(fluid, resolution)
            }
        }
    }

    /// B between a fluid and a wall, in the units of G.
    pub fn adhesion_strength(
        &self,
        adhesion: Adhesion,
        fluid: &Fluid,
        resolution: &Resolution,
    ) -> f64 {
        match adhesion {
            Adhesion::None => 0.0,
            Adhesion::Coefficient(beta) => {
                let shape = |q| akinci::adhesion(q, 1.0);
                beta * constant(self.akinci(), resolution, 0.007, shape)
            }
            Adhesion::ContactAngle(angle) => {
                let work = self.surface_tension(fluid, resolution) * (1.0 + angle.cos());
                0.5 * work / self.adhesion_of_one(fluid, resolution)
            }
        }
    }

    /// G at gamma = 1.
    pub(super) fn constant(&self, resolution: &Resolution) -> f64 {
        let shape = |q| Akinci::default().attraction::<f64, 3>(q, 1.0);
        constant(self.akinci(), resolution, 32.0 / PI, shape)
    }

    /// What the model multiplies F / m by: the mass of a particle, kg, where F is taken for an
    /// acceleration.
    pub(super) fn share(&self, mass: f64) -> f64 {
        match self.akinci() {
            Some(akinci) if akinci.reading == Reading::Acceleration => mass,
            _ => 1.0,
        }
    }
}

/// The constant before a spline whose constant in 3D is `in_space`, over s^D, or s^3 as printed.
fn constant(
    akinci: Option<&Akinci>,
    resolution: &Resolution,
    in_space: f64,
    shape: impl Fn(f64) -> f64,
) -> f64 {
    let support = resolution.support();
    let printed = akinci.is_some_and(|akinci| akinci.normalisation == Normalisation::Printed);
    if resolution.dimension == 3 || printed {
        return in_space / support.powi(3);
    }
    in_space * 2.0 * moment(2, &shape) / moment(1, &shape) / support.powi(2)
}
