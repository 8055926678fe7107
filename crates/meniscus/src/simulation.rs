//! A simulation: particles, a scheme, and the march in time.

use rayon::prelude::*;

use crate::divergence::{Circumstances, Diverged, Failure, check};
use crate::domain::Domain;
use crate::fluid::Fluid;
use crate::pairs::{Instructions, Pairs};
use crate::particles::{Particles, ROWS_PER_TASK};
use crate::physics::surface_tension::jancik_hyhlik::Surface;
use crate::physics::van_der_waals::Flow;
use crate::rates::{Dimension, Force, PairForce, Rates, Space, Table};
use crate::scheme::{DensityForm, Scheme, TimeStep};
use crate::setup::{Setup, SetupError, check_density, validate};
use crate::smoothing::Smoothing;
use crate::snapshot::Snapshot;
use crate::term::{PairTerm, Sweep};
use crate::time::integrator::{drift, kick, kick_drift};
use crate::time::step::StepLimits;
use crate::time::work::Work;
use crate::vector::Vector;

/// Skin of the first lists, and bounds of all later ones, in spacings.
const SKIN: f64 = 0.1;
const LEAST_SKIN: f64 = 0.02;
const LARGEST_SKIN: f64 = 0.5;

/// Cost of new lists over that of one step's sweeps, as measured in 2D and 3D.
const COST_OF_LISTS: f64 = 1.0;

/// An adaptive step shorter than this part of h / c counts as collapsed.
const COLLAPSED: f64 = 1e-4;

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
    /// A simulation at t = 0.
    ///
    /// # Errors
    /// If a value is impossible: no fluid, a spacing or length that is not
    /// positive, a viscosity below zero, a body force that is not a number, a
    /// particle of an unknown fluid, at no finite place, or without mass.
    pub fn new(setup: Setup<D>) -> Result<Self, SetupError>
    where
        Space: Dimension<D>,
    {
        let mut simulation = Self::assemble(setup)?;
        (simulation.table.rebuild)(&mut simulation.rates.pairs, &mut simulation.particles);
        if simulation.rates.scheme.density == DensityForm::Summation {
            (simulation.table.advance_density)(
                &mut simulation.rates,
                &mut simulation.particles,
                0.0,
                0.0,
            );
        }
        if let Some(model) = &simulation.rates.scheme.van_der_waals {
            check_density(model, &simulation.particles)?;
        } else {
            simulation.rates.update_pressure(&mut simulation.particles);
        }
        (simulation.table.accelerate)(&mut simulation.rates, &mut simulation.particles, 0.0);
        simulation.work.push(simulation.rates.walls.power(), 0.0);
        simulation.choose_step();
        Ok(simulation)
    }

    /// All but lists, pressure and acceleration.
    pub(crate) fn assemble(setup: Setup<D>) -> Result<Self, SetupError>
    where
        Space: Dimension<D>,
    {
        validate(&setup)?;
        let Setup {
            scheme,
            fluids,
            particles,
            spacing,
            domain,
        } = setup;
        let mut particles = Particles::new(&particles);
        for i in 0..particles.len() {
            particles.density[i] = fluids[particles.fluid[i] as usize].density;
        }
        particles.smoothing_length.fill(scheme.smoothing_length);
        let smoothing = match scheme.adaptive_smoothing {
            Some(_) => Smoothing::Mean { factor: 1.0 },
            None => Smoothing::Constant(scheme.smoothing_length),
        };
        let skin = SKIN * spacing;
        let mut pairs = Pairs::new(scheme.kernel, smoothing, spacing, skin, domain);
        if scheme.adaptive_smoothing.is_some() {
            pairs.hold_also(scheme.smoothing_length);
        }
        pairs.set_precision(scheme.precision);
        let support = scheme.kernel.support() * scheme.smoothing_length;
        let limits = StepLimits::new(&fluids, scheme.smoothing_length, support, 0.0, 0.0);
        if let Some(model) = &scheme.van_der_waals {
            particles.temperature = vec![model.temperature; particles.len()];
            particles.heating = vec![0.0; particles.len()];
            particles.heating_gain = vec![0.0; particles.len()];
        }
        Ok(Self {
            rates: Rates::new(scheme, fluids, &particles, pairs),
            particles,
            domain,
            spacing,
            time: 0.0,
            steps: 0,
            work: Work::default(),
            next_step: 0.0,
            limits,
            largest_speed: 0.0,
            table: Space::table(),
        })
    }

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

    fn refresh_lists(&mut self) {
        if self.rates.pairs.is_stale(&self.particles) {
            let skin = self.best_skin();
            self.rates.pairs.set_skin(skin);
            (self.table.rebuild)(&mut self.rates.pairs, &mut self.particles);
        }
    }

    /// The skin s that makes sweeps and new lists together cheapest, m: with a
    /// motion of u a step, lists live s / (2 u) steps, and a sweep costs
    /// 1 + s D / (support + spacing) of its cost without a skin.
    fn best_skin(&self) -> f64 {
        let scheme = &self.rates.scheme;
        let reach = scheme.kernel.support() * scheme.smoothing_length + self.spacing;
        let motion = self.largest_speed * self.next_step;
        let best = (2.0 * motion * COST_OF_LISTS * reach / D as f64).sqrt();
        best.clamp(LEAST_SKIN * self.spacing, LARGEST_SKIN * self.spacing)
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

    pub(crate) fn choose_step(&mut self) {
        let scheme = &self.rates.scheme;
        let largest = |column: &[Vector<f64, D>]| {
            (column.par_iter().with_min_len(ROWS_PER_TASK))
                .map(Vector::norm_squared)
                .reduce(|| 0.0, f64::max)
                .sqrt()
        };
        self.largest_speed = largest(&self.particles.velocity);
        let largest_acceleration = largest(&self.particles.acceleration);
        let shortest = match scheme.adaptive_smoothing {
            None => scheme.smoothing_length,
            Some(_) => shortest(&self.particles.smoothing_length),
        };
        let support = scheme.kernel.support() * shortest;
        let limits = StepLimits::new(
            &self.rates.fluids,
            shortest,
            support,
            self.largest_speed,
            largest_acceleration,
        )
        .with_stiffness(self.rates.stiffness(largest_acceleration));
        self.limits = match &self.rates.van_der_waals {
            Some(fluid) => limits.with_van_der_waals(
                fluid.flow.stiffness(&self.particles),
                support,
                self.largest_speed,
            ),
            None => limits,
        };
        self.next_step = match scheme.time_step {
            TimeStep::Fixed(dt) => dt,
            TimeStep::Adaptive { safety } => safety * self.limits.governing().1,
        };
    }

    fn check_state(&self) -> Result<(), Diverged> {
        let (particles, fluids) = (&self.particles, &self.rates.fluids);
        let bad = (0..particles.len())
            .into_par_iter()
            .with_min_len(ROWS_PER_TASK)
            .filter(|&i| check(particles, fluids, i).is_some())
            .min();
        if let Some(i) = bad {
            let failure = check(particles, fluids, i).unwrap_or(Failure::NotFinite);
            return Err(self.diverged(i, failure));
        }
        Ok(())
    }

    fn check_step(&self) -> Result<(), Diverged> {
        let fastest =
            (self.rates.fluids.iter()).fold(0.0, |c: f64, fluid| c.max(fluid.sound_speed));
        let acoustic = self.rates.scheme.smoothing_length / fastest;
        if self.next_step < COLLAPSED * acoustic && self.rates.scheme.time_step.is_adaptive() {
            let a = &self.particles.acceleration;
            let i = (0..a.len())
                .max_by(|&i, &j| a[i].norm_squared().total_cmp(&a[j].norm_squared()))
                .unwrap_or(0);
            return Err(self.diverged(
                i,
                Failure::StepCollapsed {
                    step: self.next_step,
                    acoustic,
                },
            ));
        }
        Ok(())
    }

    fn circumstances(&self) -> Circumstances {
        let fluids = &self.rates.fluids;
        let slowest = fluids
            .iter()
            .fold(f64::INFINITY, |c, fluid| c.min(fluid.sound_speed));
        Circumstances {
            step_over_limit: self.next_step / self.limits.governing().1,
            mach_number: self.largest_speed / slowest,
            artificial_viscosity: self.rates.scheme.artificial_viscosity,
        }
    }

    fn diverged(&self, i: usize, failure: Failure) -> Diverged {
        Diverged {
            step: self.steps,
            time: self.time,
            particle: self.particles.id[i],
            dimension: D,
            position: self.particles.position[i].to_3d(),
            failure,
            culprit: Box::new((self.table.diagnose)(
                &self.rates,
                &self.particles,
                &self.domain,
                self.time,
                i,
            )),
            circumstances: self.circumstances(),
        }
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

/// The shortest of some lengths, m.
fn shortest(lengths: &[f64]) -> f64 {
    (lengths.par_iter().with_min_len(ROWS_PER_TASK).copied()).reduce(|| f64::INFINITY, f64::min)
}
