//! A standing wave v = U sin(k x) cos(omega t) has omega = c k w(k).
//!
//! With w(k) the mean of cos(k x) over the kernel: divergence and gradient are
//! each the exact ones, smoothed once. To first order in U pressure vanishes at
//! rest, so that the forms of the pressure gradient agree; the change of density
//! by summation is that by continuity, integrated.

use std::f64::consts::PI;

use meniscus::Simulation;
use meniscus::rates::{Dimension, Space};
use meniscus::scheme::{DensityForm, PressureForm, TimeStep};

use crate::common::fluid;
use crate::wave::{K, amplitude, mean_over_kernel, strip};

const SOUND_SPEED: f64 = 10.0;

/// Angular frequency over c k, from five zeros of the velocity.
fn slowness<const D: usize>(n: usize, density: DensityForm, pressure: PressureForm) -> f64
where
    Space: Dimension<D>,
{
    let mut setup = strip::<D>(n, D - 1, 1e-5 * SOUND_SPEED, fluid(0.0, 0.0));
    setup.scheme.density = density;
    setup.scheme.pressure = pressure;
    setup.scheme.time_step = TimeStep::Adaptive { safety: 0.25 };
    let mut simulation = Simulation::new(setup).expect("a sound setup");
    let point = |simulation: &Simulation<D>| {
        let p = simulation.particles();
        (simulation.time(), amplitude(p, &p.velocity, D - 1))
    };
    let mut zeros = Vec::new();
    let mut last = point(&simulation);
    while zeros.len() < 5 {
        simulation.step().expect("the flow is calm");
        let next = point(&simulation);
        if last.1 * next.1 < 0.0 {
            zeros.push(last.0 + (next.0 - last.0) * last.1 / (last.1 - next.1));
        }
        last = next;
    }
    4.0 * PI / (zeros[4] - zeros[0]) / (SOUND_SPEED * K)
}

fn is_as_stated<const D: usize>(n: usize, density: DensityForm, pressure: PressureForm)
where
    Space: Dimension<D>,
{
    let expected = mean_over_kernel(n, D, |x| (K * x).cos());
    let found = slowness::<D>(n, density, pressure);
    // The lattice's 1e-4 for a sum, twice; the time step's (omega dt)^2 / 24 < 2e-4; in density by summation it also is
    // an excess of density, to which c answers threefold (gamma = 7).
    assert!(
        (found / expected - 1.0).abs() < 5e-4,
        "{D}D, {density:?}, {pressure:?}, n = {n}: {found}, expected {expected}"
    );
}

#[test]
fn a_standing_wave_has_the_frequency_of_sound() {
    for density in [DensityForm::Continuity, DensityForm::Summation] {
        for pressure in [
            PressureForm::OverDensitySquared,
            PressureForm::OverDensityProduct,
            PressureForm::HuAdams,
        ] {
            is_as_stated::<2>(32, density, pressure);
        }
        is_as_stated::<3>(16, density, PressureForm::OverDensitySquared);
    }
}

#[test]
fn the_speed_of_sound_converges_to_second_order() {
    let error =
        |n| 1.0 - slowness::<2>(n, DensityForm::Continuity, PressureForm::OverDensitySquared);
    let (coarse, middle, fine) = (error(24), error(48), error(96));
    // Four, less the next order of w(k): its part of the error at n = 24 is k^2 <x^2> / 4 = 8 %.
    for ratio in [coarse / middle, middle / fine] {
        assert!(
            (3.6..4.2).contains(&ratio),
            "{coarse:e}, {middle:e}, {fine:e}"
        );
    }
}
