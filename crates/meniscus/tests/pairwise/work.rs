//! Estimates against forces, on lattices at their density at rest: the pressure in bulk, and the
//! work that parts a liquid from itself or from a wall.

use std::f64::consts::PI;

use meniscus::physics::surface_tension::pairwise::Pairwise;
use meniscus::physics::surface_tension::pairwise::gaussian_pair::GaussianPair;
use meniscus::rates::{Dimension, Space};
use meniscus::scheme::{Adhesion, Bearing, SurfaceTension, Wall};
use meniscus::{Simulation, Vector};

use crate::common::{fluid, periodic_box, periodic_lattice};
use crate::{cohesion, resolution, soft};

/// A lattice of an eighth of the support sums a shape as its integral does to 1.5 %; cores that
/// push, no wider than a spacing or two and with a cusp in the middle, to 6 %.
fn lattice_error(model: Pairwise) -> f64 {
    match model {
        Pairwise::GaussianPair(GaussianPair::Plain) | Pairwise::Kordilla(_) => 0.06,
        _ => 0.015,
    }
}

/// h over the spacing.
const FINE: f64 = 4.0;

fn bulk<const D: usize>()
where
    Space: Dimension<D>,
{
    for model in soft() {
        let mut setup = periodic_box::<D>(10, |_| Vector::ZERO, fluid(0.0, 1.0));
        setup.scheme.surface_tension = Some(SurfaceTension::Pairwise(model));
        setup.scheme.smoothing_length = FINE * setup.spacing;
        let largest = cohesion().cohesion_pressure(&setup.fluids[0], &resolution(&setup));
        let estimate = model.cohesion_pressure(&setup.fluids[0], &resolution(&setup));
        let simulation = Simulation::new(setup).expect("a sound setup");
        for virial in &simulation.surface().virial_pressure {
            // Some have none, and balance as large a push and pull.
            let error = (virial + estimate).abs() / largest;
            assert!(
                error < lattice_error(model),
                "{D}D {model:?}: {virial} of {estimate}"
            );
        }
    }
}

#[test]
fn the_virial_pressure_of_bulk_is_minus_the_cohesion_pressure() {
    bulk::<2>();
    bulk::<3>();
}

/// What it takes per area to part the lower half of a slab from its upper half, or from a wall
/// that is its upper half, by the forces at many distances.
fn work_of_parting<const D: usize>(
    model: Pairwise,
    adhesion: Option<Adhesion>,
    pressure: f64,
) -> f64
where
    Space: Dimension<D>,
{
    let spacing = 0.1;
    let mut counts = [9; D];
    counts[D - 1] = 16;
    let middle = 0.8;
    // Halfway through each part of the way from touch to out of reach.
    let parts = 32;
    let gap = |k: usize| (k as f64 + 0.5) * middle / parts as f64;
    let pull = |gap: f64| {
        let mut setup = periodic_lattice::<D>(counts, spacing, |_| Vector::ZERO, fluid(0.0, 1.0));
        setup.scheme.surface_tension = Some(SurfaceTension::Pairwise(model));
        setup.scheme.smoothing_length = FINE * setup.spacing;
        setup.domain.periodic[D - 1] = None;
        setup.fluids[0].background_pressure = pressure;
        for particle in &mut setup.particles {
            if particle.position[D - 1] > middle {
                particle.position[D - 1] += gap;
                particle.body = 1;
            }
        }
        if let Some(adhesion) = adhesion {
            setup.scheme.walls = vec![Wall {
                adhesion,
                // Attraction alone is asked for.
                bearing: Bearing::Nothing,
                ..Wall::new(1)
            }];
        }
        let simulation = Simulation::new(setup).expect("a sound setup");
        let p = simulation.particles();
        let below = (0..p.len()).filter(|&i| p.body[i] == 0);
        below
            .map(|i| p.mass[i] * p.acceleration[i][D - 1])
            .sum::<f64>()
    };
    let area = (9.0 * spacing).powi(D as i32 - 1);
    (0..parts).map(|k| pull(gap(k))).sum::<f64>() * middle / parts as f64 / area
}

#[test]
fn to_part_a_liquid_takes_twice_its_surface_tension() {
    for model in soft() {
        let plane = work_of_parting::<2>(model, None, 0.0);
        assert!(
            (plane / 2.0 - 1.0).abs() < lattice_error(model),
            "{model:?}: {plane}"
        );
    }
    let space = work_of_parting::<3>(cohesion(), None, 0.0);
    assert!(
        (space / 2.0 - 1.0).abs() < lattice_error(cohesion()),
        "3D: {space}"
    );
}

fn parts_under_pressure<const D: usize>()
where
    Space: Dimension<D>,
{
    let mut setup = periodic_box::<D>(10, |_| Vector::ZERO, fluid(0.0, 1.0));
    setup.scheme.smoothing_length = FINE * setup.spacing;
    let (model, water) = (cohesion(), &setup.fluids[0]);
    let net = model.net_surface_tension(water, &resolution(&setup));
    let pressure = model.cohesion_pressure(water, &resolution(&setup));
    let work = work_of_parting::<D>(model, None, pressure);
    // What is left of two large parts, each known to 1.5 %.
    let error = (work / 2.0 - net).abs();
    assert!(error < 2.0 * lattice_error(model), "{D}D: {work} of {net}");
}

#[test]
fn under_its_cohesion_pressure_a_liquid_parts_more_easily() {
    parts_under_pressure::<2>();
    parts_under_pressure::<3>();
}

/// Young and Dupre: sigma (1 + cos theta).
#[test]
fn to_part_a_liquid_from_a_wall_takes_what_the_contact_angle_says() {
    for model in [cohesion(), soft()[1]] {
        for angle in [0.3, 0.5 * PI, 2.2] {
            let work = work_of_parting::<2>(model, Some(Adhesion::ContactAngle(angle)), 0.0);
            let ratio = work / (1.0 + f64::cos(angle));
            assert!(
                (ratio - 1.0).abs() < lattice_error(model),
                "{model:?} at {angle}: {ratio}"
            );
        }
    }
}
