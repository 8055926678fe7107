//! Pressure against radius in a round body, and the surface tension it shows.

use crate::theory::{equivalent_radius, surface_tension_from_pressure};
use crate::vector::Vector;

use super::centre_of_mass;

/// The particles between two radii.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RadialBin {
    /// Mean distance of the particles from the centre, m.
    pub radius: f64,
    /// Mean of the field over the particles.
    pub mean: f64,
    /// How many they are.
    pub particles: usize,
}

/// Means of a field, such as pressure, over `bins` shells of equal thickness from
/// the centre out to `outer_radius` (m). Shells without particles are left out.
pub fn radial_profile<const D: usize>(
    positions: &[Vector<f64, D>],
    field: &[f64],
    centre: Vector<f64, D>,
    outer_radius: f64,
    bins: usize,
) -> Vec<RadialBin> {
    let mut profile = vec![
        RadialBin {
            radius: 0.0,
            mean: 0.0,
            particles: 0
        };
        bins
    ];
    for (&x, value) in positions.iter().zip(field) {
        let radius = (x - centre).norm();
        // Anything not below the outer radius, NaN too, finds no bin.
        let place = radius / outer_radius * bins as f64;
        if place < bins as f64 {
            let bin = &mut profile[place as usize];
            bin.radius += radius;
            bin.mean += value;
            bin.particles += 1;
        }
    }
    profile.retain_mut(|bin| {
        bin.radius /= bin.particles as f64;
        bin.mean /= bin.particles as f64;
        bin.particles > 0
    });
    profile
}

/// Surface tension measured on a rod or drop at rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StaticSurfaceTension {
    /// Radius of the circle or sphere with the body's volume, m.
    pub radius: f64,
    /// Mean pressure of the particles within half of that radius, Pa.
    pub inner_pressure: f64,
    /// Standard deviation of the pressure among them, Pa: zero in a body truly at rest.
    pub inner_deviation: f64,
    /// How many they are.
    pub particles: usize,
    /// Surface tension by Young and Laplace, N/m: p R in 2D, p R / 2 in 3D.
    pub surface_tension: f64,
}

impl StaticSurfaceTension {
    /// Measures a body of this volume (m^3; m^2 in 2D) whose surroundings have no
    /// pressure; `None` if no particle lies within half of the radius from the centre of mass.
    pub fn measure<const D: usize>(
        positions: &[Vector<f64, D>],
        masses: &[f64],
        pressures: &[f64],
        volume: f64,
    ) -> Option<Self> {
        let centre = centre_of_mass(positions, masses)?;
        let radius = equivalent_radius(volume, D);
        let inside = || {
            positions
                .iter()
                .zip(pressures)
                .filter(|&(&x, _)| (x - centre).norm() < 0.5 * radius)
                .map(|(_, &pressure)| pressure)
        };
        let particles = inside().count();
        let mean = |sum: f64| sum / particles as f64;
        let inner_pressure = mean(inside().sum());
        let spread = mean(inside().map(|p| (p - inner_pressure).powi(2)).sum());
        (particles > 0).then(|| StaticSurfaceTension {
            radius,
            inner_pressure,
            inner_deviation: spread.sqrt(),
            particles,
            surface_tension: surface_tension_from_pressure(inner_pressure, radius, D),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    /// Rings of 6 k particles at radius k about a point, and one particle there.
    fn rings(count: i32, centre: Vector<f64, 2>) -> Vec<Vector<f64, 2>> {
        (1..=count)
            .flat_map(|k| {
                (0..6 * k).map(move |i| {
                    let (sin, cos) = (PI * f64::from(i) / f64::from(3 * k)).sin_cos();
                    centre + Vector([cos, sin]) * f64::from(k)
                })
            })
            .chain([centre])
            .collect()
    }

    #[test]
    fn a_profile_recovers_a_function_of_the_radius() {
        let centre = Vector([3.0, -1.0]);
        let x = rings(10, centre);
        let field: Vec<f64> = x.iter().map(|&x| 7.0 - 2.0 * (x - centre).norm()).collect();
        // Shells thinner than one and no edge on a ring: each holds one ring or none.
        let profile = radial_profile(&x, &field, centre, 10.3, 13);
        assert_eq!(profile.len(), 11);
        for (k, bin) in profile.iter().enumerate() {
            assert_eq!(bin.particles, (6 * k).max(1));
            assert!((bin.radius - k as f64).abs() < 1e-12);
            assert!((bin.mean - (7.0 - 2.0 * k as f64)).abs() < 1e-12);
        }
        // What lies outside is not counted.
        let inner = radial_profile(&x, &field, centre, 4.5, 3);
        assert_eq!(
            inner.iter().map(|bin| bin.particles).sum::<usize>(),
            1 + 6 * (1 + 2 + 3 + 4)
        );
        assert!(radial_profile(&x, &field, centre, 4.5, 0).is_empty());
    }

    #[test]
    fn a_rod_under_its_own_surface_tension() {
        // 2 Pa inside, falling to nothing at the surface of a rod of radius 10.
        let centre = Vector([0.2, 0.1]);
        let x = rings(9, centre);
        let p: Vec<f64> = x
            .iter()
            .map(|&x| if (x - centre).norm() < 7.5 { 2.0 } else { 0.7 })
            .collect();
        let found = StaticSurfaceTension::measure(&x, &vec![1.0; x.len()], &p, 100.0 * PI).unwrap();
        assert!((found.radius - 10.0).abs() < 1e-12);
        assert!((found.surface_tension - 20.0).abs() < 1e-11);
        assert_eq!((found.inner_deviation, found.inner_pressure), (0.0, 2.0));
        assert_eq!(StaticSurfaceTension::measure::<2>(&[], &[], &[], 1.0), None);
    }

    #[test]
    fn a_drop_has_half_the_surface_tension_of_a_rod_of_the_same_pressure() {
        let x = [Vector([0.1, 0.0, 0.0]), Vector([-0.1, 0.0, 0.0])];
        let found =
            StaticSurfaceTension::measure(&x, &[1.0, 1.0], &[3.0, 5.0], 4.0 / 3.0 * PI).unwrap();
        assert!((found.surface_tension - 2.0).abs() < 1e-14);
        assert_eq!((found.particles, found.inner_deviation), (2, 1.0));
    }
}
