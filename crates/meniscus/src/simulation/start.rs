//! The start of a flow.

use super::Simulation;
use crate::pairs::Pairs;
use crate::particles::Particles;
use crate::rates::{Dimension, Rates, Space};
use crate::scheme::DensityForm;
use crate::setup::{Setup, SetupError, check_density, validate};
use crate::smoothing::Smoothing;
use crate::time::step::StepLimits;
use crate::time::work::Work;

/// Skin of the first lists, in spacings.
const SKIN: f64 = 0.1;

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
}
