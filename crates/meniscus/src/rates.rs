//! The ordered sweeps of a scheme: rate of density, then acceleration.

use rayon::prelude::*;

use crate::divergence::{self, Culprit};
use crate::fluid::Fluid;
use crate::pairs::{Domain, Pairs};
use crate::particles::Particles;
use crate::physics::continuity::{Continuity, NumberContinuity};
use crate::physics::density_diffusion::Diffusing;
use crate::physics::equation_of_state::Tait;
use crate::physics::momentum::{
    Mixture, Momentum, OneFluid, OverDensityProduct, OverDensitySquared, PressureForm,
};
use crate::physics::summation::Summation;
use crate::physics::surface_tension::SurfaceTension;
use crate::physics::surface_tension::continuum::{FlatLayer, Relist, Surroundings};
use crate::physics::surface_tension::pairwise::Pull;
use crate::physics::surface_tension::pairwise::estimate::Resolution;
use crate::physics::surface_tension::surface::Surface;
use crate::physics::velocity_smoothing::VelocitySmoothing;
use crate::physics::viscosity::ViscosityForm;
use crate::physics::viscous_stress::ViscousStress;
use crate::physics::wall::Slip;
use crate::scheme::{Bearing, DensityForm, Scheme};
use crate::term::{PairTerm, Sweep};
use crate::vector::Vector;
use crate::walls::Walls;

/// Rows that one task works on at least, where the work per row is small.
pub(crate) const ROWS_PER_TASK: usize = 2048;

/// A force of the user's own, added to the momentum equation.
pub trait Force<const D: usize>: Send + Sync {
    /// Adds its acceleration, m/s^2, to that of each particle.
    fn accelerate(
        &mut self,
        pairs: &mut Pairs<D>,
        particles: &Particles<D>,
        acceleration: &mut [Vector<f64, D>],
    );
}

/// A [`PairTerm`] that sums to an acceleration, as a [`Force`].
pub(crate) struct PairForce<T, const D: usize> {
    pub(crate) term: T,
    pub(crate) sums: Vec<Vector<f64, D>>,
}

impl<T, const D: usize> Force<D> for PairForce<T, D>
where
    T: PairTerm<D, Sum<f64> = Vector<f64, D>> + Send,
{
    fn accelerate(
        &mut self,
        pairs: &mut Pairs<D>,
        particles: &Particles<D>,
        acceleration: &mut [Vector<f64, D>],
    ) {
        pairs.sweep(&self.term, particles, |_| true, &mut self.sums);
        for (a, sum) in acceleration.iter_mut().zip(&self.sums) {
            *a += *sum;
        }
    }
}

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
    viscous_stress: ViscousStress<D>,
    diffusing: Diffusing<D>,
    /// For the particles at the surface alone.
    at_surface: Pairs<D>,
    pub(crate) forces: Vec<Box<dyn Force<D>>>,
    pub(crate) walls: Walls<D>,
    equations_of_state: Vec<Tait>,
    /// Mass of all particles, kg, where it is the same and there is one fluid.
    one_mass: Option<f64>,
    scalars: Vec<f64>,
    vectors: Vec<Vector<f64, D>>,
}

impl<const D: usize> Rates<D> {
    pub(crate) fn new(
        scheme: Scheme,
        fluids: Vec<Fluid>,
        particles: &Particles<D>,
        pairs: Pairs<D>,
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
        Self {
            at_surface,
            pull,
            bearing: Vec::new(),
            viscous_stress: ViscousStress::default(),
            diffusing: Diffusing::default(),
            equations_of_state: fluids.iter().map(Tait::new).collect(),
            walls: Walls::new(&scheme.walls, particles),
            one_mass: first.filter(|_| same && fluids.len() == 1),
            scheme,
            fluids,
            pairs,
            surface: Surface::default(),
            forces: Vec::new(),
            scalars: Vec::new(),
            vectors: Vec::new(),
        }
    }

    /// Density at the end of a step of `dt` seconds that starts at `time`, then pressure. By
    /// continuity from positions and velocities at its middle, where XSPH moves
    /// particles too; by summation from positions at its end.
    pub(crate) fn advance_density(&mut self, particles: &mut Particles<D>, time: f64, dt: f64) {
        self.walls.go_halfway(&self.pairs, particles, dt);
        match self.scheme.density {
            DensityForm::Continuity | DensityForm::Number => {
                if self.scheme.density == DensityForm::Number {
                    self.pairs
                        .sweep(&NumberContinuity, particles, |_| true, &mut self.scalars);
                } else {
                    self.pairs
                        .sweep(&Continuity, particles, |_| true, &mut self.scalars);
                }
                self.walls
                    .compress(&mut self.pairs, particles, &mut self.scalars);
                self.diffuse(particles, time + 0.5 * dt);
                self.smooth_motion(particles, dt);
                (particles.density.par_iter_mut(), &self.scalars)
                    .into_par_iter()
                    .with_min_len(ROWS_PER_TASK)
                    .for_each(|(density, rate)| *density += dt * *density * rate);
            }
            DensityForm::Summation => {
                self.pairs
                    .sweep(&Summation, particles, |_| true, &mut self.scalars);
                particles.density.copy_from_slice(&self.scalars);
            }
        }
        self.update_pressure(particles);
    }

    /// Adds diffusion to the rates of density at `time` seconds.
    fn diffuse(&mut self, particles: &mut Particles<D>, time: f64) {
        let Some(diffusion) = self.scheme.density_diffusion else {
            return;
        };
        let gravity = self.body_force(time);
        self.walls.hide(particles, |_| true);
        self.diffusing.add(
            diffusion,
            &mut self.pairs,
            particles,
            &self.fluids,
            self.scheme.smoothing_length,
            gravity,
            &mut self.scalars,
        );
        self.walls.show(particles);
    }

    /// The body force at `time` seconds, m/s^2.
    pub(crate) fn body_force(&self, time: f64) -> Vector<f64, D> {
        (self.scheme.body_force.as_ref())
            .map_or(Vector::ZERO, |force| Vector::from_3d(force.at(time)))
    }

    /// Moves particles towards the velocity of their surroundings, for `dt` seconds.
    fn smooth_motion(&mut self, particles: &mut Particles<D>, dt: f64) {
        let strength = self.scheme.velocity_smoothing;
        if strength == 0.0 {
            return;
        }
        let term = VelocitySmoothing { strength };
        self.walls.hide(particles, |_| true);
        self.pairs
            .sweep(&term, particles, |_| true, &mut self.vectors);
        self.walls.show(particles);
        self.walls.keep(&mut self.vectors);
        (particles.position.par_iter_mut(), &self.vectors)
            .into_par_iter()
            .with_min_len(ROWS_PER_TASK)
            .for_each(|(position, velocity)| *position += *velocity * dt);
    }

    pub(crate) fn update_pressure(&self, particles: &mut Particles<D>) {
        (
            particles.pressure.par_iter_mut(),
            &particles.density,
            &particles.fluid,
        )
            .into_par_iter()
            .with_min_len(ROWS_PER_TASK)
            .for_each(|(pressure, density, fluid)| {
                *pressure = self.equations_of_state[*fluid as usize].pressure(*density);
            });
    }

    /// Acceleration at `time` seconds.
    pub(crate) fn accelerate(&mut self, particles: &mut Particles<D>, time: f64) {
        let body_force = self.body_force(time);
        self.walls.prepare(
            &mut self.pairs,
            particles,
            &self.equations_of_state,
            body_force,
            time,
        );
        self.press_walls(particles);
        let mut acceleration = std::mem::take(&mut particles.acceleration);
        self.push(particles, &mut acceleration);
        self.walls.bear(particles, &mut acceleration);
        if self.scheme.viscosity == ViscosityForm::Stress && is_viscous(&self.fluids) {
            self.walls
                .hide(particles, |wall| wall.slip == Slip::FreeSlip);
            self.viscous_stress.accelerate(
                &mut self.pairs,
                particles,
                &self.fluids,
                &mut acceleration,
            );
            self.walls.bear(particles, &mut acceleration);
            self.walls.show(particles);
        }
        if self.pull.is_some() {
            self.pull_pairs(particles, &mut acceleration);
            self.walls.bear(particles, &mut acceleration);
        } else if self.scheme.surface_tension.is_some() {
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
    /// Adds the acceleration by surface tension, m/s^2.
    fn pull_surface(&mut self, particles: &Particles<D>, acceleration: &mut [Vector<f64, D>]) {
        let smoothing_length = self.scheme.smoothing_length;
        match self.scheme.surface_tension {
            Some(SurfaceTension::JancikHyhlik(model)) => model.accelerate(
                &mut self.pairs,
                particles,
                smoothing_length,
                |i| self.fluids[particles.fluid[i] as usize].surface_tension,
                &mut self.surface,
                acceleration,
            ),
            Some(SurfaceTension::Continuum(model)) => {
                let surroundings = Surroundings {
                    fluids: &self.fluids,
                    smoothing_length,
                };
                if !self.surface.is_calibrated() {
                    let spacing = mean_spacing(&self.fluids, particles);
                    let support = self.scheme.kernel.support() * smoothing_length;
                    let mut layer = FlatLayer::new(surroundings, support, spacing);
                    let periodic = layer.periodic;
                    let domain = Domain { periodic };
                    let mut pairs = self.pairs.sibling(smoothing_length, spacing, domain);
                    pairs.relist(&mut layer.particles);
                    model.calibrate(&mut pairs, &layer, surroundings, &mut self.surface);
                }
                model.accelerate(
                    &mut self.pairs,
                    &mut self.at_surface,
                    particles,
                    surroundings,
                    &mut self.surface,
                    acceleration,
                );
            }
            Some(SurfaceTension::Pairwise(_)) | None => {}
        }
    }

    /// Adds to the pressure of walls what balances the forces of pairs on the fluid near them.
    fn press_walls(&mut self, particles: &mut Particles<D>) {
        let Some(pull) = &mut self.pull else {
            return;
        };
        let builds = self.pairs.builds();
        let mut rows = std::mem::take(&mut self.bearing);
        for bearing in [Bearing::Adhesion, Bearing::Pairs] {
            self.walls.find_bearing(particles, bearing, &mut rows);
            if rows.is_empty() {
                continue;
            }
            pull.charge(&mut self.pairs, particles, builds);
            let cohesion = bearing == Bearing::Pairs;
            pull.press_walls(&mut self.pairs, particles, cohesion, &rows);
            for &row in &rows {
                let equation = self.equations_of_state[usize::from(particles.fluid[row])];
                particles.density[row] = equation.density(particles.pressure[row]);
            }
        }
        self.bearing = rows;
    }

    /// Adds the acceleration by forces of pairs, walls among them, m/s^2.
    fn pull_pairs(&mut self, particles: &mut Particles<D>, acceleration: &mut [Vector<f64, D>]) {
        let Some(pull) = &mut self.pull else {
            return;
        };
        let builds = self.pairs.builds();
        pull.charge(&mut self.pairs, particles, builds);
        if pull.has_curvature() {
            self.walls.hide(particles, |_| true);
            pull.find_normals(&mut self.pairs, particles);
            self.walls.show(particles);
        }
        pull.accelerate(&mut self.pairs, particles, &mut self.surface, acceleration);
    }

    /// The square of the largest frequency of stiff forces, 1/s^2, where the largest acceleration
    /// is `largest`, m/s^2.
    pub(crate) fn stiffness(&self, largest: f64) -> f64 {
        (self.pull.as_ref()).map_or(0.0, |pull| pull.stiffness(largest))
    }

    /// Part of the acceleration of row `i` that surface tension made, m/s^2.
    pub(crate) fn surface_acceleration(
        &self,
        particles: &Particles<D>,
        i: usize,
    ) -> Vector<f64, D> {
        let force = self.surface.force.get(i).copied().unwrap_or_default();
        force * (1.0 / particles.density[i])
    }
}

impl<const D: usize> Relist<D> for Pairs<D> {
    fn relist(&mut self, particles: &mut Particles<D>) {
        self.rebuild(particles);
    }
}

/// The spacing that gives the particles their volume at rest, m.
fn mean_spacing<const D: usize>(fluids: &[Fluid], particles: &Particles<D>) -> f64 {
    let volume: f64 = (particles.mass.iter().zip(&particles.fluid))
        .map(|(mass, fluid)| mass / fluids[*fluid as usize].density)
        .sum();
    (volume / particles.len().max(1) as f64).powf(1.0 / D as f64)
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
    let by_pairs = is_viscous(fluids) && scheme.viscosity != ViscosityForm::Stress;
    Momentum {
        material,
        pressure,
        artificial_viscosity: scheme.artificial_viscosity,
        viscosity: by_pairs.then_some(scheme.viscosity),
        smoothing_length: scheme.smoothing_length,
    }
}

/// The dimensions that the library is compiled for: `Space` implements this
/// for 2 and 3.
///
/// The sweeps are the bulk of the machine code. Reached through this trait
/// they are compiled once, in this crate, and not again in every crate that
/// mentions a simulation.
pub trait Dimension<const D: usize> {
    #[doc(hidden)]
    fn table() -> Table<D>;
}

/// Implements [`Dimension`] for 2 and 3.
#[derive(Clone, Copy, Debug)]
pub struct Space;

/// Entry points of the compiled sweeps.
#[doc(hidden)]
#[derive(Clone, Copy)]
pub struct Table<const D: usize> {
    pub(crate) advance_density: fn(&mut Rates<D>, &mut Particles<D>, f64, f64),
    pub(crate) accelerate: fn(&mut Rates<D>, &mut Particles<D>, f64),
    pub(crate) rebuild: fn(&mut Pairs<D>, &mut Particles<D>),
    pub(crate) diagnose: fn(&Rates<D>, &Particles<D>, &Domain<D>, f64, usize) -> Culprit,
}

macro_rules! compile_for {
    ($D:literal) => {
        impl Dimension<$D> for Space {
            // Inlined, it would be compiled, and all it points to, in every crate anew.
            #[inline(never)]
            fn table() -> Table<$D> {
                Table {
                    advance_density: Rates::<$D>::advance_density,
                    accelerate: Rates::<$D>::accelerate,
                    rebuild: Pairs::<$D>::rebuild,
                    diagnose: divergence::diagnose::<$D>,
                }
            }
        }
    };
}

compile_for!(2);
compile_for!(3);
