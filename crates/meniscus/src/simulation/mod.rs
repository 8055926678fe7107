//! A simulation: particles, a scheme, and the march in time.
//!
//! - here: a step, and what may be asked
//! - `start`: from a setup
//! - `pace`: the length of the next step
//! - `health`: whether the flow is sound

mod health;
mod pace;
mod start;

use crate::divergence::Diverged;
use crate::domain::Domain;
use crate::fluid::Fluid;
use crate::pairs::{Instructions, Pairs};
use crate::particles::Particles;
use crate::physics::surface_tension::jancik_hyhlik::Surface;
use crate::physics::van_der_waals::Flow;
use crate::rates::{Force, PairForce, Rates, Table};
use crate::scheme::{DensityForm, Scheme};
use crate::snapshot::Snapshot;
use crate::term::{PairTerm, Sweep};
use crate::time::integrator::{drift, kick, kick_drift};
use crate::time::step::StepLimits;
use crate::time::work::Work;
use crate::vector::Vector;

/// A flow on its way.
///
/// Work is spread over the threads of the rayon pool that it is called from;
/// the result is the same, bit by bit, for any number of them.
pub struct Simulation<const D: usize> {
    pub(crate) particles: Particles<D>,
    pub(crate) rates: Rates<D>,
    pub(crate) domain: Domain<D>,
    pub(crate) spacing: f64,
    pub(crate) time: f64,
    pub(crate) steps: u64,
    pub(crate) work: Work,
    pub(crate) next_step: f64,
    pub(crate) limits: StepLimits,
    /// Of the last velocities, m/s.
    largest_speed: f64,
    pub(crate) table: Table<D>,
}

impl<const D: usize> Simulation<D> {
    /// Marches one time step.
    ///
    /// # Errors
    /// If the flow blew up: which particle, which term, what to change. The
    /// simulation must not be used further then.
    pub fn step(&mut self) -> Result<(), Diverged> {
        let dt = self.next_step;
        let damping = self.rates.scheme.damping;
        kick_drift(&mut self.particles, dt, damping);
        if self.rates.scheme.density != DensityForm::Summation {
            self.refresh_lists();
            (self.table.advance_density)(&mut self.rates, &mut self.particles, self.time, dt);
        }
        drift(&mut self.particles, dt);
        self.refresh_lists();
        if self.rates.scheme.density == DensityForm::Summation {
            (self.table.advance_density)(&mut self.rates, &mut self.particles, self.time, dt);
        }
        self.fall(dt);
        self.time += dt;
        (self.table.accelerate)(&mut self.rates, &mut self.particles, self.time);
        self.work.push(self.rates.walls.power(), dt);
        self.steps += 1;
        // Velocities are still those that the accelerations belong to.
        self.check_state()?;
        (self.table.put_in_order)(&mut self.rates, &mut self.particles, self.steps, dt);
        kick(&mut self.particles, dt, damping);
        self.choose_step();
        self.check_step()
    }

    /// Counts the work of the body force in the drift from now on.
    fn fall(&mut self, dt: f64) {
        let rates = &self.rates;
        if rates.scheme.body_force.is_some() {
            let ends = [self.time, self.time + dt].map(|time| rates.body_force(time));
            let mean = (ends[0] + ends[1]) * 0.5;
            let moves = |body| !rates.walls.is_wall(body);
            self.work.fall(&self.particles, moves, mean, dt);
        }
    }

    /// Stretches the whole by these factors along the axes, about its centre of mass; velocities
    /// stay. Meant for factors whose product is one: density by continuity stays as well.
    pub fn stretch(&mut self, factors: [f64; D]) {
        let particles = &mut self.particles;
        let mass: f64 = particles.mass.iter().sum();
        let mut centre = Vector::<f64, D>::ZERO;
        for (x, m) in particles.position.iter().zip(&particles.mass) {
            centre += *x * (m / mass);
        }
        for x in &mut particles.position {
            for (d, factor) in factors.iter().enumerate() {
                x[d] = centre[d] + (x[d] - centre[d]) * factor;
            }
        }
        (self.table.rebuild)(&mut self.rates.pairs, &mut self.particles);
        if self.rates.scheme.density == DensityForm::Summation {
            (self.table.advance_density)(&mut self.rates, &mut self.particles, self.time, 0.0);
        }
        (self.table.accelerate)(&mut self.rates, &mut self.particles, self.time);
        self.choose_step();
    }

    /// Sets the rate of the drag from now on, 1/s.
    pub fn set_damping(&mut self, rate: f64) {
        self.rates.scheme.damping = rate;
    }

    /// Marches until `time` in s is reached or passed.
    ///
    /// # Errors
    /// As [`step`](Self::step).
    pub fn advance_to(&mut self, time: f64) -> Result<(), Diverged> {
        while self.time < time {
            self.step()?;
        }
        Ok(())
    }

    /// Adds a force of your own to the momentum equation: a term that sums to
    /// an acceleration, m/s^2.
    pub fn add_force<T>(&mut self, term: T)
    where
        T: PairTerm<D, Sum<f64> = Vector<f64, D>> + Send + 'static,
    {
        self.rates.forces.push(Box::new(PairForce {
            term,
            sums: Vec::new(),
        }));
    }

    /// Adds a force that is not a sum over pairs.
    pub fn add_other_force(&mut self, force: Box<dyn Force<D>>) {
        self.rates.forces.push(force);
    }

    /// Sums `term` over the neighbours of every particle, as things stand.
    pub fn sum<T: PairTerm<D>>(&mut self, term: &T) -> Vec<T::Sum<f64>> {
        let mut sums = Vec::new();
        self.refresh_lists();
        self.rates
            .pairs
            .sweep(term, &self.particles, |_| true, &mut sums);
        sums
    }

    /// State of the flow.
    pub fn particles(&self) -> &Particles<D> {
        &self.particles
    }

    /// What the surface-tension model found in the last step; empty columns without one.
    pub fn surface(&self) -> &Surface<D> {
        &self.rates.surface
    }

    /// What is known of a van der Waals fluid, if this is one.
    pub fn van_der_waals(&self) -> Option<&Flow<D>> {
        (self.rates.van_der_waals.as_ref()).map(|fluid| &fluid.flow)
    }

    /// Time, s.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// Work done on the liquid so far.
    pub fn work(&self) -> Work {
        self.work
    }

    /// Steps so far.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Length of the next step, s.
    pub fn next_step(&self) -> f64 {
        self.next_step
    }

    /// Limits on the next step.
    pub fn limits(&self) -> StepLimits {
        self.limits
    }

    /// Fluids by index.
    pub fn fluids(&self) -> &[Fluid] {
        &self.rates.fluids
    }

    /// The scheme.
    pub fn scheme(&self) -> &Scheme {
        &self.rates.scheme
    }

    /// Distance between neighbouring particles at the start, m.
    pub fn spacing(&self) -> f64 {
        self.spacing
    }

    /// Periodic axes.
    pub fn domain(&self) -> &Domain<D> {
        &self.domain
    }

    /// The pair engine, to look at its statistics.
    pub fn pairs(&self) -> &Pairs<D> {
        &self.rates.pairs
    }

    /// Restricts the instructions of the sweeps, to measure or test the other paths.
    pub fn set_instructions(&mut self, instructions: Instructions) {
        self.rates.pairs.set_instructions(instructions);
    }

    /// The whole state, to go on from later.
    pub fn snapshot(&self) -> Snapshot {
        Snapshot::of(self)
    }
}
