//! The ordered sweeps of a scheme: rate of density, then acceleration.
//!
//! - here: what they need, and the order of forces
//! - `density`: density and pressure
//! - `surface`: forces by surface tension
//! - `order`: what puts particles in order
//! - `van_der_waals`: a fluid of its own
//! - `force`: those of the user's own; `between`: the force of a single pair
//! - `dimension`: that they are compiled once, for 2 and 3 dimensions

mod between;
mod density;
mod dimension;
mod force;
mod order;
mod surface;
mod van_der_waals;

pub use dimension::{Dimension, Space, Table};
pub use force::Force;
pub(crate) use force::PairForce;

use crate::fluid::Fluid;
use crate::pairs::Pairs;
use crate::particles::Particles;
use crate::physics::adaptive_smoothing::Pilot;
use crate::physics::density_diffusion::Diffusing;
use crate::physics::equation_of_state::Tait;
use crate::physics::grad_h::GradH;
use crate::physics::momentum::{
    Mixture, Momentum, OneFluid, OverDensityProduct, OverDensitySquared, PressureForm,
};
use crate::physics::surface_tension::SurfaceTension;
use crate::physics::surface_tension::balanced::Wetting;
use crate::physics::surface_tension::capillary_pressure::Closeness;
use crate::physics::surface_tension::curvature::CorrectableDivergence;
use crate::physics::surface_tension::pairwise::Pull;
use crate::physics::surface_tension::pairwise::estimate::Resolution;
use crate::physics::surface_tension::surface::Surface;
use crate::physics::viscosity::ViscosityForm;
use crate::physics::viscous_stress::ViscousStress;
use crate::physics::wall::Slip;
use crate::scheme::Scheme;
use crate::term::Sweep;
use crate::vector::Vector;
use crate::walls::Walls;
use van_der_waals::Cohesive;

/// The right-hand sides of a scheme, with the columns they need on the way.
pub(crate) struct Rates<const D: usize> {
    pub(crate) scheme: Scheme,
    pub(crate) fluids: Vec<Fluid>,
    pub(crate) pairs: Pairs<D>,
    pub(crate) surface: Surface<D>,
    /// Forces of pairs, where surface tension is of them.
    pull: Option<Pull<D>>,
    /// Rows of walls whose pressure balances these.
    bearing: Vec<usize>,
    /// Bodies of liquid, where surface tension balances them, and walls that they wet.
    free: surface::FreeBodies,
    shifts: order::Shifts<D>,
    wetting: Wetting,
    /// Mean of the particles at the start, m.
    spacing: f64,
    viscous_stress: ViscousStress<D>,
    diffusing: Diffusing<D>,
    pub(crate) van_der_waals: Option<Cohesive<D>>,
    pilot: Pilot,
    grad_h: GradH<D>,
    /// For the particles at the surface alone.
    at_surface: Pairs<D>,
    pub(crate) forces: Vec<Box<dyn Force<D>>>,
    pub(crate) walls: Walls<D>,
    equations_of_state: Vec<Tait>,
    /// Mass of all particles, kg, where it is the same and there is one fluid.
    one_mass: Option<f64>,
    scalars: Vec<f64>,
    vectors: Vec<Vector<f64, D>>,
    velocity_gradients: Vec<CorrectableDivergence<f64, D>>,
}

impl<const D: usize> Rates<D> {
    pub(crate) fn new(
        scheme: Scheme,
        fluids: Vec<Fluid>,
        particles: &Particles<D>,
        mut pairs: Pairs<D>,
    ) -> Self {
        let first = particles.mass.first().copied();
        let same = particles.mass.iter().all(|&mass| Some(mass) == first);
        let surface_smoothing = match &scheme.surface_tension {
            Some(SurfaceTension::Continuum(model)) => model.curvature_smoothing,
            _ => 1.0,
        };
        let spacing = mean_spacing(&fluids, particles);
        let at_surface = pairs.sibling(
            surface_smoothing * scheme.smoothing_length,
            spacing,
            pairs.domain(),
        );
        let van_der_waals =
            (scheme.van_der_waals).map(|model| Cohesive::new(model, &scheme, &fluids, &mut pairs));
        if let Some(SurfaceTension::CapillaryPressure(_)) = scheme.surface_tension
            && fluids[0].surface_tension > 0.0
        {
            let walled = !scheme.walls.is_empty();
            let (kernel, smoothing_length) = Closeness::range(D, spacing, walled);
            pairs.set_second(kernel, smoothing_length);
        }
        let pull = match scheme.surface_tension {
            Some(SurfaceTension::Pairwise(model)) => {
                let resolution = Resolution {
                    kernel: scheme.kernel,
                    smoothing_length: scheme.smoothing_length,
                    spacing,
                    dimension: D,
                };
                let walls = &scheme.walls;
                Some(Pull::new(model, resolution, &fluids, walls, particles))
            }
            _ => None,
        };
        let tension = wall_tension(&scheme, &fluids);
        let support = scheme.kernel.support() * scheme.smoothing_length;
        let domain = pairs.domain();
        let walls = Walls::new(&scheme.walls, particles, tension, spacing, support, &domain);
        Self {
            at_surface,
            pull,
            bearing: Vec::new(),
            free: surface::FreeBodies::default(),
            shifts: order::Shifts::default(),
            wetting: Wetting::default(),
            spacing,
            viscous_stress: ViscousStress::default(),
            diffusing: Diffusing::default(),
            van_der_waals,
            pilot: Pilot::default(),
            grad_h: GradH::default(),
            equations_of_state: fluids.iter().map(Tait::new).collect(),
            walls,
            one_mass: first.filter(|_| same && fluids.len() == 1),
            scheme,
            fluids,
            pairs,
            surface: Surface::default(),
            forces: Vec::new(),
            scalars: Vec::new(),
            vectors: Vec::new(),
            velocity_gradients: Vec::new(),
        }
    }

    /// The body force at `time` seconds, m/s^2.
    pub(crate) fn body_force(&self, time: f64) -> Vector<f64, D> {
        (self.scheme.body_force.as_ref())
            .map_or(Vector::ZERO, |force| Vector::from_3d(force.at(time)))
    }

    /// Acceleration at `time` seconds.
    pub(crate) fn accelerate(&mut self, particles: &mut Particles<D>, time: f64) {
        let body_force = self.body_force(time);
        self.walls.place(&self.pairs, particles, time);
        let sigma = self.find_capillary_pressure(particles);
        if sigma.is_some() {
            // Forces of pairs see p - q, which is what density gives.
            self.update_pressure(particles);
        }
        self.walls.prepare(
            &mut self.pairs,
            particles,
            &self.equations_of_state,
            body_force,
            time,
        );
        self.press_walls(particles);
        let mut acceleration = std::mem::take(&mut particles.acceleration);
        if let Some(fluid) = &mut self.van_der_waals {
            (fluid.flow).accelerate(&mut self.pairs, particles, &mut acceleration);
        } else {
            self.push(particles, &mut acceleration);
        }
        self.push_by_grad_h(particles, &mut acceleration);
        if let Some(sigma) = sigma {
            self.slide(particles, &mut acceleration);
            self.add_capillary_pressure(sigma, particles, &mut acceleration);
        }
        self.walls.bear(particles, &mut acceleration);
        let stress = self.scheme.viscosity.is_stress();
        if stress && self.van_der_waals.is_none() && is_viscous(&self.fluids) {
            self.walls
                .hide(particles, |wall| wall.slip == Slip::FreeSlip);
            let walls = &self.walls;
            self.viscous_stress.accelerate(
                &mut self.pairs,
                particles,
                |rows| walls.is_wet(particles, rows),
                &self.fluids,
                self.scheme.viscosity == ViscosityForm::StressAndRest,
                &mut acceleration,
            );
            self.walls.bear(particles, &mut acceleration);
            self.walls.show(particles);
        }
        if self.pull.is_some() {
            self.pull_pairs(particles, &mut acceleration);
            self.walls.bear(particles, &mut acceleration);
        } else if self.scheme.surface_tension.is_some() {
            self.walls.find_wetting(particles, &mut self.wetting);
            self.walls.hide(particles, |_| true);
            self.pull_surface(particles, &mut acceleration);
            self.walls.show(particles);
        }
        if self.scheme.body_force.is_some() {
            acceleration.iter_mut().for_each(|a| *a += body_force);
        }
        self.walls.keep(&mut acceleration);
        for force in &mut self.forces {
            force.accelerate(&mut self.pairs, particles, &mut acceleration);
        }
        self.walls.bear(particles, &mut acceleration);
        self.walls
            .finish(particles, &mut acceleration, self.scheme.damping);
        if let Some(fluid) = &mut self.van_der_waals {
            (fluid.flow).heat(&mut self.pairs, particles, &acceleration);
        }
        particles.acceleration = acceleration;
    }

    /// The acceleration by pressure and by the viscous forces of pairs, m/s^2.
    fn push(&mut self, particles: &Particles<D>, acceleration: &mut Vec<Vector<f64, D>>) {
        let (scheme, fluids, pairs) = (&self.scheme, &self.fluids[..], &mut self.pairs);
        if !self.walls.is_empty() {
            let walls = &self.walls;
            let material = walls.material(fluids);
            let term = momentum(scheme, fluids, material, Some(scheme.pressure));
            let wet = |rows| walls.is_wet(particles, rows);
            return pairs.sweep(&term, particles, wet, acceleration);
        }
        let one = self.one_mass.map(|mass| OneFluid::new(mass, &fluids[0]));
        // The common cases have code of their own.
        match (one, scheme.pressure) {
            (Some(material), PressureForm::OverDensitySquared) => {
                let term = momentum(scheme, fluids, material, OverDensitySquared);
                pairs.sweep(&term, particles, |_| true, acceleration);
            }
            (Some(material), PressureForm::OverDensityProduct) => {
                let term = momentum(scheme, fluids, material, OverDensityProduct);
                pairs.sweep(&term, particles, |_| true, acceleration);
            }
            (_, form) => {
                let term = momentum(scheme, fluids, Mixture(fluids), Some(form));
                pairs.sweep(&term, particles, |_| true, acceleration);
            }
        }
    }
}

impl<const D: usize> Rates<D> {
    /// Adds what pressure owes to the change of smoothing lengths, m/s^2; of a van der Waals fluid what
    /// cohesion owes, since its pressure warms by its work, whatever that is.
    fn push_by_grad_h(&mut self, particles: &Particles<D>, acceleration: &mut [Vector<f64, D>]) {
        let Some(model) = self.scheme.adaptive_smoothing.filter(|model| model.grad_h) else {
            return;
        };
        let h = self.scheme.smoothing_length;
        let (grad_h, pairs) = (&mut self.grad_h, &mut self.pairs);
        grad_h.begin(particles);
        self.scalars.clear();
        if let Some(fluid) = &self.scheme.van_der_waals {
            let cohesion = -fluid.substance.cohesion;
            self.scalars.resize(particles.len(), cohesion);
            if let Some(far) = pairs.second() {
                grad_h.add_energy(far, particles, &self.scalars);
            }
            grad_h.accelerate(&model, h, &self.pilot, pairs, particles, acceleration);
            return;
        }
        let columns = particles.pressure.iter().zip(&particles.density);
        self.scalars
            .extend(columns.map(|(p, density)| p / (density * density)));
        grad_h.add_energy(pairs, particles, &self.scalars);
        grad_h.accelerate(&model, h, &self.pilot, pairs, particles, acceleration);
    }
}

/// The spacing that gives the particles their volume at rest, m.
fn mean_spacing<const D: usize>(fluids: &[Fluid], particles: &Particles<D>) -> f64 {
    let volume: f64 = (particles.mass.iter().zip(&particles.fluid))
        .map(|(mass, fluid)| mass / fluids[*fluid as usize].density)
        .sum();
    (volume / particles.len().max(1) as f64).powf(1.0 / D as f64)
}

/// How much walls pull, Pa, at most: with models in balance they pull as the liquid beside them does, under a hollow surface or
/// above the level of a pool, as far as the pressure of a surface bent by 1 / h. What is further below is noise.
fn wall_tension(scheme: &Scheme, fluids: &[Fluid]) -> f64 {
    match (scheme.surface_tension, fluids) {
        (Some(SurfaceTension::Balanced(_) | SurfaceTension::CapillaryPressure(_)), [fluid, ..]) => {
            fluid.surface_tension / scheme.smoothing_length
        }
        _ => 0.0,
    }
}

fn is_viscous(fluids: &[Fluid]) -> bool {
    fluids.iter().any(|fluid| fluid.viscosity != 0.0)
}

/// The terms of the momentum equation that `scheme` has for `fluids`.
pub(crate) fn momentum<M, P>(
    scheme: &Scheme,
    fluids: &[Fluid],
    material: M,
    pressure: P,
) -> Momentum<M, P> {
    let by_pairs = is_viscous(fluids) && !scheme.viscosity.is_stress();
    Momentum {
        material,
        pressure,
        artificial_viscosity: scheme.artificial_viscosity,
        viscosity: by_pairs.then_some(scheme.viscosity),
        smoothing_length: scheme.smoothing_length,
    }
}
