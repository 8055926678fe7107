//! Normals and curvature of exact shapes.
//!
//! The model finds both in a layer under the surface, on average at a depth h, so that a
//! drop of radius R shows the curvature of the circles there: the mean of 1/r, not 1/R.

use meniscus::rates::{Dimension, Space};
use meniscus::scheme::SurfaceTension;
use meniscus::shape::Pattern;
use meniscus::theory::equivalent_radius;
use meniscus::{Domain, Setup, Simulation, Vector};

use crate::common::{fluid, periodic_lattice};
use crate::{ball, volume};

/// Means over the layer of surface-active particles no deeper than 2 h, each
/// weighted by |n| as the force is.
struct Layer {
    /// Curvature times R, one for a circle or, halved, a sphere
    curvature: f64,
    /// R / r
    position: f64,
    /// Smallest cosine between n and the way to the centre
    cosine: f64,
}

fn layer<const D: usize>(setup: Setup<D>) -> Layer
where
    Space: Dimension<D>,
{
    let radius = equivalent_radius(volume(&setup), D);
    let simulation = Simulation::new(setup).expect("a sound setup");
    let depth = 2.0 * simulation.scheme().smoothing_length;
    let surface = simulation.surface();
    let (mut weight, mut curvature, mut position) = (0.0, 0.0, 0.0);
    let mut cosine = f64::INFINITY;
    for (i, x) in simulation.particles().position.iter().enumerate() {
        let normal = surface.normal[i];
        if x.norm() > radius - depth && surface.curvature[i] != 0.0 {
            weight += normal.norm();
            curvature += normal.norm() * surface.curvature[i];
            position += normal.norm() / x.norm();
            cosine = cosine.min(-normal.dot(x) / (normal.norm() * x.norm()));
        }
    }
    Layer {
        curvature: curvature / weight * radius / (D as f64 - 1.0),
        position: position / weight * radius,
        cosine,
    }
}

#[test]
fn normals_point_inward() {
    // Between the steps of a lattice they turn by up to acos 0.98 = 11 degrees.
    let cosines = [
        layer(ball::<2>(13.0, Pattern::Cubic, 0.0)).cosine,
        layer(ball::<2>(13.0, Pattern::ClosePacked, 0.0)).cosine,
        layer(ball::<3>(8.0, Pattern::Cubic, 0.0)).cosine,
        layer(ball::<3>(8.0, Pattern::ClosePacked, 0.0)).cosine,
    ];
    assert!(cosines.iter().all(|&cosine| cosine > 0.98), "{cosines:?}");
    // The surface of rings has no steps; that a ring's particles do not stand
    // on those of the next one turns normals by less than 1e-3.
    let smooth = layer(ball::<2>(13.5, Pattern::Concentric, 0.0)).cosine;
    assert!(smooth > 1.0 - 0.5e-6, "{smooth}");
}

#[test]
fn the_curvature_of_a_circle_is_that_of_its_layer_and_converges() {
    let mut last = f64::INFINITY;
    for radius in [13.5, 27.5, 55.5] {
        let found = layer(ball::<2>(radius, Pattern::Concentric, 0.0));
        // At a depth of h = 1.5 dx, to a tenth of it.
        let expected = 1.0 / (1.0 - 1.5 / radius);
        assert!(
            (found.position / expected - 1.0).abs() < 0.15 / radius,
            "R = {radius} dx: layer at R / {}, expected R / {expected}",
            found.position
        );
        // The divergence is a mean over a kernel of a curvature that changes
        // with depth: right to h / R, of which a third is left.
        let error = found.curvature / found.position - 1.0;
        assert!(
            (0.0..0.5 / radius).contains(&error),
            "R = {radius} dx: {error}"
        );
        assert!(error < 0.6 * last, "R = {radius} dx: {error} after {last}");
        last = error;
    }
}

#[test]
fn a_stepped_circle_has_the_curvature_of_a_smooth_one_to_eight_per_cent() {
    for radius in [13.376, 18.0, 25.0, 40.0] {
        for pattern in [Pattern::Cubic, Pattern::ClosePacked] {
            let found = layer(ball::<2>(radius, pattern, 0.0));
            let error = found.curvature / found.position - 1.0;
            // Steps of a spacing are half as high as h is long, at any R / dx.
            assert!(
                (0.0..0.08).contains(&error),
                "R = {radius} dx, {pattern:?}: {error}"
            );
        }
    }
}

#[test]
fn the_curvature_of_a_sphere_is_twice_that_of_its_layer() {
    let mut last = f64::INFINITY;
    for radius in [6.0, 9.0, 14.0] {
        let found = layer(ball::<3>(radius, Pattern::Cubic, 0.0));
        let error = found.curvature / found.position - 1.0;
        // As of a circle: 0.5 / radius, or 3 % where steps prevail.
        let bound = (0.5 / radius).max(0.03);
        assert!((0.0..bound).contains(&error), "R = {radius} dx: {error}");
        // And with it, towards 2 / R.
        assert!(
            found.curvature - 1.0 < 0.75 * last,
            "R = {radius} dx: {}",
            found.curvature
        );
        last = found.curvature - 1.0;
    }
}

fn is_flat<const D: usize>(counts: [usize; D])
where
    Space: Dimension<D>,
{
    let mut setup = periodic_lattice(counts, 1.0, |_| Vector::ZERO, fluid(0.0, 1.0));
    setup.domain.periodic[D - 1] = None;
    setup.scheme.surface_tension = Some(SurfaceTension::JancikHyhlik(Default::default()));
    let simulation = Simulation::new(setup).expect("a sound setup");
    let surface = simulation.surface();
    let largest = surface
        .curvature
        .iter()
        .fold(0.0, |a: f64, k| a.max(k.abs()));
    assert!(surface.active() > 0 && surface.active() < simulation.particles().len());
    // Rounding of unit normals over h, from sums of a hundred neighbours.
    assert!(largest < 1e-11, "{D}D: {largest:e}");
    let p = simulation.particles();
    for i in 0..p.len() {
        let n = surface.normal[i];
        let side = p.position[i][D - 1] - 0.5 * counts[D - 1] as f64;
        assert!(
            n[D - 1] * side.signum() < 1e-13 && n[0].abs() < 1e-13,
            "{D}D: {n:?} at {side}"
        );
    }
}

#[test]
fn a_flat_surface_has_no_curvature_and_a_normal_across_it() {
    is_flat::<2>([12, 24]);
    is_flat::<3>([6, 6, 24]);
}

#[test]
fn liquid_without_a_surface_feels_none() {
    let mut setup = periodic_lattice([12, 12], 1.0, |_| Vector::ZERO, fluid(0.0, 1.0));
    setup.scheme.surface_tension = Some(SurfaceTension::JancikHyhlik(Default::default()));
    assert_eq!(
        setup.domain,
        Domain {
            periodic: [Some((0.0, 12.0)); 2]
        }
    );
    let simulation = Simulation::new(setup).expect("a sound setup");
    assert_eq!(simulation.surface().active(), 0);
    let p = simulation.particles();
    assert!(
        p.acceleration
            .iter()
            .all(|a| a.norm() == 0.0 || a.norm() < 1e-12)
    );
}
