//! What follows from the strength of pairwise forces where particles are spread evenly, at their
//! density at rest, up to a sharp flat surface. In moments of f, with s the support,
//!
//! - p_c   = G rho^2 S_D / (2 D) integral f r^D dr,   S_2 = 2 pi, S_3 = 4 pi
//! - sigma = G rho^2 T_D integral f r^(D+1) dr,       T_2 = 1/3, T_3 = pi/8
//! - cos(theta) = -1 + 2 sigma_w / sigma,             sigma_w as sigma, of fluid and wall
//!
//! p_c is the cohesion pressure, which the equation of state has to bear: minus the virial of the
//! forces in bulk. sigma is half the work that parts two half-spaces (Rayleigh 1890; Tartakovsky
//! and Panchenko 2016), and theta follows from the work between fluid and wall (Young, Dupre).
//! Akinci's curvature force, F = -H m_i m_j (n_i - n_j), adds to sigma the normal stress
//! that it makes in the layer under a surface at z = 0, with normals n(z),
//!
//! - 1/2 rho^2 H integral (z - z') (n(z) - n(z')) over z, z' < 0 and across, |x - x'| < s
//!
//! In a flow the surface is not sharp, nor are particles spread evenly, and the pressure takes
//! from it ([`Pairwise::net_surface_tension`]): a drop shows less surface tension, see docs/theory.md.

use std::f64::consts::PI;

use super::akinci::Curvature;
use super::strength::Adhesion;
use super::{Attraction, Pairwise};
use crate::fluid::Fluid;
use crate::kernel::Kernel;

/// One over the density, kg/m^3, for which Akinci's curvature force is meant as printed: water's.
const AS_PRINTED: f64 = 1e-3;

/// What the forces are summed with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Resolution {
    /// Kernel.
    pub kernel: Kernel,
    /// h, m
    pub smoothing_length: f64,
    /// Distance between particles at rest, m.
    pub spacing: f64,
    /// 2 or 3.
    pub dimension: usize,
}

impl Resolution {
    /// s, m
    pub fn support(&self) -> f64 {
        self.kernel.support() * self.smoothing_length
    }

    /// Mass of a particle, kg (kg/m in 2D).
    fn mass(&self, fluid: &Fluid) -> f64 {
        fluid.density * self.spacing.powi(self.dimension as i32)
    }
}

/// Integral of f(q) q^power from 0 to 1.
pub(super) fn moment(power: i32, f: impl Fn(f64) -> f64) -> f64 {
    // Midpoints: a shape may have an edge at 1/2, which then lies between two parts, or an
    // infinite slope at an end.
    const PARTS: usize = 6000;
    let middles = (0..PARTS).map(|k| (k as f64 + 0.5) / PARTS as f64);
    middles.map(|q| f(q) * q.powi(power)).sum::<f64>() / PARTS as f64
}

impl Pairwise {
    /// The cohesion pressure p_c of a fluid in bulk, Pa.
    ///
    /// Akinci's cohesion in 2D with the printed constant has 0.0294 gamma rho^2:
    /// ```
    /// use meniscus::physics::surface_tension::pairwise::{Pairwise, estimate::Resolution};
    /// use meniscus::physics::surface_tension::pairwise::akinci::{Akinci, Curvature, Normalisation};
    /// use meniscus::{Fluid, Kernel};
    ///
    /// let model = Pairwise::Akinci(Akinci {
    ///     gamma: Some(1.0),
    ///     normalisation: Normalisation::Printed,
    ///     curvature: Curvature::None,
    ///     ..Akinci::default()
    /// });
    /// let (kernel, spacing) = (Kernel::QuinticSpline, 0.01);
    /// let resolution = Resolution { kernel, smoothing_length: spacing, spacing, dimension: 2 };
    /// let fluid = Fluid::new("water", 1000.0);
    /// assert!((model.cohesion_pressure(&fluid, &resolution) / 1e6 - 0.02939).abs() < 1e-5);
    /// assert!((model.surface_tension(&fluid, &resolution) / 0.03e6 - 0.003908).abs() < 1e-6);
    /// ```
    pub fn cohesion_pressure(&self, fluid: &Fluid, resolution: &Resolution) -> f64 {
        let dimension = resolution.dimension as i32;
        let across = if dimension == 2 {
            0.5 * PI
        } else {
            2.0 * PI / 3.0
        };
        let moment = moment(dimension, self.attraction_from_rest(resolution));
        let strength = self.strength(fluid, resolution) * self.share(resolution.mass(fluid));
        strength
            * across
            * fluid.density.powi(2)
            * resolution.support().powi(dimension + 1)
            * moment
    }

    /// The surface tension sigma of a sharp surface of a fluid, N/m; its own times its factor, where the strength
    /// follows from it.
    pub fn surface_tension(&self, fluid: &Fluid, resolution: &Resolution) -> f64 {
        self.strength(fluid, resolution) * self.tension_of_one(fluid, resolution)
    }

    /// The surface tension less what the pressure that bears the cohesion takes from it, N/m.
    ///
    /// Pressure acts between particles as well, over the reach of W: it pushes them apart, and a
    /// pressure of p_c up to the surface takes off p_c r / pi in 2D and p_c r / 4 in 3D, with r the
    /// mean distance under W. At a surface it falls to zero: what a flow shows lies between this
    /// and [`surface_tension`](Self::surface_tension).
    pub fn net_surface_tension(&self, fluid: &Fluid, resolution: &Resolution) -> f64 {
        let (s, dimension) = (resolution.support(), resolution.dimension);
        let w = |q: f64| {
            let h = resolution.smoothing_length;
            resolution.kernel.value(q * s, h, dimension) * s.powi(dimension as i32 + 1)
        };
        let (around, share) = match dimension {
            2 => (2.0 * PI, 1.0 / PI),
            _ => (4.0 * PI, 0.25),
        };
        let mean_distance = around * moment(dimension as i32, w);
        let pressure = self.cohesion_pressure(fluid, resolution);
        self.surface_tension(fluid, resolution) - share * pressure * mean_distance
    }

    /// The contact angle, rad, at a wall; none where the fluid wets it completely.
    ///
    /// ```
    /// use meniscus::physics::surface_tension::pairwise::Pairwise;
    /// use meniscus::physics::surface_tension::pairwise::akinci::{Akinci, Curvature, Normalisation};
    /// use meniscus::physics::surface_tension::pairwise::estimate::Resolution;
    /// use meniscus::physics::surface_tension::pairwise::strength::Adhesion;
    /// use meniscus::{Fluid, Kernel};
    ///
    /// let model = Pairwise::Akinci(Akinci {
    ///     gamma: Some(1.0),
    ///     normalisation: Normalisation::Printed,
    ///     curvature: Curvature::None,
    ///     ..Akinci::default()
    /// });
    /// let (kernel, spacing) = (Kernel::QuinticSpline, 0.01);
    /// let resolution = Resolution { kernel, smoothing_length: spacing, spacing, dimension: 2 };
    /// let water = Fluid::new("water", 1000.0);
    /// let beta = Adhesion::Coefficient(3.0);
    /// let angle = model.contact_angle(beta, &water, &resolution).expect("wetting is partial");
    /// assert!((angle.cos() + 1.0 - 3.0 * 0.1705).abs() < 3e-4);
    /// // The strength of adhesion that an angle asks for has this angle.
    /// let asked = Adhesion::ContactAngle(1.0);
    /// assert!((model.contact_angle(asked, &water, &resolution).unwrap() - 1.0).abs() < 1e-9);
    /// ```
    pub fn contact_angle(
        &self,
        adhesion: Adhesion,
        fluid: &Fluid,
        resolution: &Resolution,
    ) -> Option<f64> {
        let strength = self.adhesion_strength(adhesion, fluid, resolution);
        let work = strength * self.adhesion_of_one(fluid, resolution);
        let cosine = -1.0 + 2.0 * work / self.surface_tension(fluid, resolution);
        (cosine <= 1.0).then(|| cosine.acos())
    }

    /// sigma of G = 1, N/m.
    pub(super) fn tension_of_one(&self, fluid: &Fluid, resolution: &Resolution) -> f64 {
        let shape = self.attraction_from_rest(resolution);
        let cohesion = sharp_tension(shape, fluid.density, resolution);
        let mass = resolution.mass(fluid);
        let per_strength = self.curvature_of_one(resolution);
        let curvature = match per_strength {
            (0.0, 0.0) => 0.0,
            (alone, by_mass) => {
                let strength = alone / mass + by_mass;
                strength * curvature_tension(fluid.density, resolution)
            }
        };
        (cohesion + curvature) * self.share(mass)
    }

    /// sigma_w of B = 1, N/m.
    pub(super) fn adhesion_of_one(&self, fluid: &Fluid, resolution: &Resolution) -> f64 {
        let nearest = self.nearest(resolution);
        let (model, support) = (*self, resolution.support());
        let shape = |q: f64| match resolution.dimension {
            _ if q < nearest => 0.0,
            2 => model.adhesion::<f64, 2>(q * support, support),
            _ => model.adhesion::<f64, 3>(q * support, support),
        };
        sharp_tension(shape, fluid.density, resolution) * self.share(resolution.mass(fluid))
    }

    /// The factors of K (n_i - n_j) and of m_j K (n_i - n_j) in Akinci's curvature force, over G.
    pub(super) fn curvature_of_one(&self, resolution: &Resolution) -> (f64, f64) {
        match self.akinci().map(|akinci| akinci.curvature) {
            Some(Curvature::Consistent) => {
                let volume = resolution.spacing.powi(resolution.dimension as i32);
                (0.0, AS_PRINTED / (volume * self.constant(resolution)))
            }
            Some(Curvature::Printed) => (1.0 / self.constant(resolution), 0.0),
            Some(Curvature::None) | None => (0.0, 0.0),
        }
    }

    /// How near two particles come, over the support: no nearer than at rest by Lennard-Jones,
    /// whose core would outweigh all else.
    fn nearest(&self, resolution: &Resolution) -> f64 {
        match self {
            Pairwise::LennardJones(model) => model.rest_distance / resolution.support(),
            _ => 0.0,
        }
    }

    /// f of q = r/s, from the nearest distance on.
    fn attraction_from_rest(&self, resolution: &Resolution) -> impl Fn(f64) -> f64 {
        let nearest = self.nearest(resolution);
        let (model, support, dimension) = (*self, resolution.support(), resolution.dimension);
        move |q| match dimension {
            _ if q < nearest => 0.0,
            2 => model.attraction::<f64, 2>(q * support, support),
            _ => model.attraction::<f64, 3>(q * support, support),
        }
    }
}

/// sigma of a force of strength 1 with this shape in q = r/s, N/m.
fn sharp_tension(shape: impl Fn(f64) -> f64, density: f64, resolution: &Resolution) -> f64 {
    let dimension = resolution.dimension as i32;
    let factor = if dimension == 2 { 1.0 / 3.0 } else { PI / 8.0 };
    let reach = resolution.support().powi(dimension + 2);
    factor * density.powi(2) * reach * moment(dimension + 1, shape)
}

/// What the curvature force of strength H = 1 adds to sigma, N/m.
fn curvature_tension(density: f64, resolution: &Resolution) -> f64 {
    const LAYERS: usize = 100;
    let s = resolution.support();
    let (h, in_space) = (resolution.smoothing_length, resolution.dimension == 3);
    // Beyond s under the surface there is no normal, but neighbours of those that have one.
    let depth = |k: usize| (k as f64 + 0.5) * s / LAYERS as f64;
    let normal: Vec<f64> = (0..2 * LAYERS)
        .map(|k| {
            // The gradient of what fills half the space is W, integrated along its surface.
            let along = |q: f64| {
                let w = resolution
                    .kernel
                    .value(depth(k).hypot(q * s), h, resolution.dimension);
                if in_space {
                    2.0 * PI * q * s * w
                } else {
                    2.0 * w
                }
            };
            s * s * moment(0, along)
        })
        .collect();
    let mut sum = 0.0;
    for a in 0..2 * LAYERS {
        for b in 0..2 * LAYERS {
            let apart = depth(b) - depth(a);
            let square = (s * s - apart * apart).max(0.0);
            let across = if in_space {
                PI * square
            } else {
                2.0 * square.sqrt()
            };
            sum += across * apart * (normal[a] - normal[b]);
        }
    }
    0.5 * density.powi(2) * sum * (s / LAYERS as f64).powi(2)
}
