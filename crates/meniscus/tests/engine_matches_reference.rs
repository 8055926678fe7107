//! The engine against the O(N^2) reference, on random clouds, with one smoothing length and with
//! one for each particle.
//!
//! Both run the same formulas; only the order of the sums differs. The sums
//! must agree to rounding: 1e-11 of the sum of the magnitudes of its parts,
//! bounded here by the largest sum in the cloud; in mixed precision 1e-5, since
//! parts a hundred times the sum, each right to 6e-8, may cancel in such clouds,
//! and as much more as the direction of its closest pair is wrong: mixed precision
//! holds places to 2^-26 of the kernel's support, and forces along the line of
//! centres of two particles much closer than a spacing feel it.

use meniscus::fluid::Fluid;
use meniscus::pairs::{Instructions, Pairs};
use meniscus::physics::continuity::Continuity;
use meniscus::physics::momentum::{Mixture, Momentum, OneFluid, PressureForm};
use meniscus::physics::surface_tension::curvature::{CorrectedCurvature, Curvature, Weighting};
use meniscus::physics::surface_tension::gradient::{CorrectedGradient, Gradient, Smoothed};
use meniscus::physics::viscosity::ViscosityForm;
use meniscus::smoothing::Smoothing;
use meniscus::term::{Record, Sweep, SweepWith};
use meniscus::{Domain, Kernel, PairTerm, Particle, Particles, Precision, Vector, reference};
use proptest::prelude::*;

const SPACING: f64 = 1.0;

/// How a cloud is made; all lengths in spacings.
#[derive(Clone, Debug)]
struct Cloud {
    points: Vec<[f64; 3]>,
    periodic: [bool; 3],
    size: f64,
    kernel: Kernel,
    smoothing_length: f64,
    instructions: Instructions,
    precision: Precision,
    /// Largest smoothing length of a particle over the smallest, where it varies.
    ratio: Option<f64>,
    /// Range of the second lists over the first.
    second: f64,
    /// Motion, and growth of smoothing lengths, after the lists were built, as a part of what the
    /// skin allows.
    moved: f64,
}

impl Cloud {
    fn smoothing(&self) -> Smoothing {
        match self.ratio {
            None => Smoothing::Constant(self.smoothing_length),
            Some(_) => Smoothing::Mean { factor: 1.0 },
        }
    }

    fn second(&self) -> Smoothing {
        match self.ratio {
            None => Smoothing::Constant(self.second * self.smoothing_length),
            Some(_) => Smoothing::Mean {
                factor: self.second,
            },
        }
    }
}

fn cloud() -> impl Strategy<Value = Cloud> {
    let point = || [0.0..1.0f64, 0.0..1.0, 0.0..1.0];
    let scattered = prop::collection::vec(point(), 0..120);
    let lattice = (1usize..6, 0.0..0.3f64, prop::collection::vec(point(), 216)).prop_map(
        |(n, jitter, random)| {
            (0..n * n * n)
                .map(|k| {
                    let cell = [k % n, k / n % n, k / n / n];
                    std::array::from_fn(|d| {
                        ((cell[d] as f64 + 0.5 + jitter * (random[k][d] - 0.5)) / n as f64)
                            .clamp(0.0, 0.999)
                    })
                })
                .collect::<Vec<_>>()
        },
    );
    let clusters = (
        prop::collection::vec((point(), 1usize..30), 0..5),
        prop::collection::vec(point(), 30),
    )
        .prop_map(|(centres, random)| {
            centres
                .iter()
                .flat_map(|(centre, n)| {
                    random[..*n].iter().map(|r| {
                        std::array::from_fn(|d| (centre[d] + 0.08 * (r[d] - 0.5)).clamp(0.0, 0.999))
                    })
                })
                .collect::<Vec<_>>()
        });
    (
        prop_oneof![scattered, lattice, clusters],
        any::<[bool; 3]>(),
        2.0..14.0f64,
        prop::sample::select(Kernel::ALL.to_vec()),
        1.0..2.0f64,
        prop::sample::select(vec![
            Instructions::Best,
            Instructions::Avx2,
            Instructions::Portable,
        ]),
        prop::sample::select(vec![Precision::Double, Precision::Mixed]),
        (prop::option::of(1.0..3.0f64), 1.0..2.0f64),
        0.0..0.99f64,
    )
        .prop_map(
            |(
                points,
                periodic,
                size,
                kernel,
                smoothing_length,
                instructions,
                precision,
                (ratio, second),
                moved,
            )| {
                Cloud {
                    points,
                    periodic,
                    size,
                    kernel,
                    smoothing_length,
                    instructions,
                    precision,
                    ratio,
                    second,
                    moved,
                }
            },
        )
}

fn particles<const D: usize>(cloud: &Cloud) -> Particles<D> {
    let start: Vec<_> = (cloud.points.iter().enumerate())
        .map(|(k, point)| Particle {
            position: Vector(std::array::from_fn(|d| point[d] * cloud.size)),
            velocity: Vector(std::array::from_fn(|d| ((k * 7 + d * 3) as f64).sin())),
            mass: 1.0 + 0.3 * (k as f64).cos(),
            fluid: (k % 2) as u16,
            body: 0,
        })
        .collect();
    let mut particles = Particles::new(&start);
    for k in 0..particles.len() {
        particles.density[k] = 1.0 + 0.2 * (3.0 * k as f64).sin();
        particles.pressure[k] = (5.0 * k as f64).cos();
        let ratio = cloud.ratio.unwrap_or(1.0);
        let part = (11.0 * k as f64).sin().abs();
        particles.smoothing_length[k] = cloud.smoothing_length * ratio.powf(part - 0.5);
    }
    particles
}

/// Least distance of two particles that are not at one place, images included.
fn closest<const D: usize>(domain: &Domain<D>, particles: &Particles<D>) -> f64 {
    let mut least = f64::INFINITY;
    for (i, x) in particles.position.iter().enumerate() {
        for y in &particles.position[..i] {
            let mut offset = *x - *y;
            for (x, axis) in offset.0.iter_mut().zip(domain.periodic) {
                if let Some((low, high)) = axis {
                    *x -= ((*x / (high - low)).round()) * (high - low);
                }
            }
            let distance = offset.norm();
            if distance > 0.0 {
                least = least.min(distance);
            }
        }
    }
    least
}

fn compare<T: PairTerm<D>, const D: usize>(
    name: &str,
    term: &T,
    cloud: &Cloud,
    domain: &Domain<D>,
    pairs: &mut Pairs<D>,
    particles: &Particles<D>,
) -> Result<(), TestCaseError> {
    let mut fast = Vec::new();
    pairs.sweep(term, particles, |_| true, &mut fast);
    let smoothing = cloud.smoothing();
    let slow = reference::sums(term, cloud.kernel, smoothing, domain, particles);
    agree::<T, D>(name, cloud, domain, particles, &fast, &slow)
}

fn agree<T: PairTerm<D>, const D: usize>(
    name: &str,
    cloud: &Cloud,
    domain: &Domain<D>,
    particles: &Particles<D>,
    fast: &[T::Sum<f64>],
    slow: &[T::Sum<f64>],
) -> Result<(), TestCaseError> {
    prop_assert_eq!(fast.len(), slow.len());
    let reals = |sum: &T::Sum<f64>| {
        let mut out = Vec::new();
        sum.write(&mut |value| out.push(value));
        out
    };
    let scale = slow
        .iter()
        .flat_map(reals)
        .fold(1.0, |a: f64, b| a.max(b.abs()));
    let tolerance = match cloud.precision {
        Precision::Double => 1e-11,
        Precision::Mixed => {
            let ratio = cloud.ratio.unwrap_or(1.0).sqrt();
            let reach = cloud.kernel.support() * cloud.smoothing_length * ratio * cloud.second;
            let quantum = reach * 2.0_f64.powi(-26);
            1e-5 + 10.0 * quantum / closest(domain, particles)
        }
    };
    for (i, (fast, slow)) in fast.iter().zip(slow).enumerate() {
        for (fast, slow) in reals(fast).iter().zip(reals(slow)) {
            prop_assert!(
                (fast - slow).abs() <= tolerance * scale,
                "{name}, particle {i} of {}: engine {fast:e}, reference {slow:e}",
                particles.len()
            );
        }
    }
    Ok(())
}

fn fluid(density: f64) -> Fluid {
    Fluid {
        sound_speed: 3.0 * density,
        viscosity: 0.1 * density,
        surface_tension: 1.0,
        ..Fluid::new("fluid", density)
    }
}

fn check<const D: usize>(cloud: &Cloud) -> Result<(), TestCaseError> {
    let skin = 0.3 * SPACING;
    let domain = Domain {
        periodic: std::array::from_fn(|d| cloud.periodic[d].then_some((0.0, cloud.size))),
    };
    let mut particles = particles::<D>(cloud);
    let mut pairs = Pairs::new(cloud.kernel, cloud.smoothing(), SPACING, skin, domain);
    pairs.hold_also(cloud.smoothing_length);
    pairs.set_second(cloud.kernel, cloud.second());
    pairs.set_instructions(cloud.instructions);
    pairs.set_precision(cloud.precision);
    pairs.rebuild(&mut particles);
    prop_assert!(!pairs.is_stale(&particles));
    for k in 0..particles.len() {
        let angle = k as f64;
        // One part of the skin for motion, the rest for growth, as the second lists see it.
        let part = match cloud.ratio {
            None => 1.0,
            Some(_) => (2.0 * angle).cos().abs(),
        };
        let allowed = 0.5 * skin * cloud.moved;
        let step = part * allowed;
        let growth = (1.0 - part) * allowed / (0.5 * cloud.kernel.support() * cloud.second);
        let shrinks = k % 3 == 0;
        particles.smoothing_length[k] *= if shrinks { 0.9 } else { 1.0 };
        particles.smoothing_length[k] += if shrinks { 0.0 } else { growth };
        particles.position[k][0] += step * angle.cos();
        particles.position[k][1] += step * angle.sin();
    }
    prop_assert!(!pairs.is_stale(&particles));

    let fluids = [fluid(1.0), fluid(0.5)];
    let colour: Vec<f64> = (0..particles.len()).map(|k| (k as f64).sin()).collect();
    let normal: Vec<Vector<f64, D>> = (0..particles.len())
        .map(|k| Vector(std::array::from_fn(|d| ((k + d) as f64).sin() - 0.5)))
        .collect();
    let p = &particles;
    compare("continuity", &Continuity, cloud, &domain, &mut pairs, p)?;
    let mut also = Vec::new();
    let constant = Smoothing::Constant(cloud.smoothing_length);
    pairs.sweep_with(constant, &Continuity, p, |_| true, &mut also);
    let slow = reference::sums(&Continuity, cloud.kernel, constant, &domain, p);
    agree::<Continuity, D>("constant length", cloud, &domain, p, &also, &slow)?;
    let second = pairs.second().expect("lists of a second range");
    second.sweep(&Continuity, p, |_| true, &mut also);
    let slow = reference::sums(&Continuity, cloud.kernel, cloud.second(), &domain, p);
    agree::<Continuity, D>("second range", cloud, &domain, p, &also, &slow)?;
    let smoothed = Smoothed { weighted: &colour };
    compare("colour", &smoothed, cloud, &domain, &mut pairs, p)?;
    let gradient = Gradient { values: &colour };
    compare("gradient", &gradient, cloud, &domain, &mut pairs, p)?;
    let corrected = CorrectedGradient { values: &colour };
    compare("CSPM", &corrected, cloud, &domain, &mut pairs, p)?;
    let curvature = Curvature {
        normal: &normal,
        shortest: 0.5,
        weighting: Weighting::NormalLength,
    };
    compare("curvature", &curvature, cloud, &domain, &mut pairs, p)?;
    let corrected = CorrectedCurvature(curvature);
    compare("CSPM curvature", &corrected, cloud, &domain, &mut pairs, p)?;
    let forms = [
        (PressureForm::OverDensitySquared, ViscosityForm::Morris),
        (
            PressureForm::OverDensityProduct,
            ViscosityForm::MonaghanCleary,
        ),
        (PressureForm::HuAdams, ViscosityForm::Morris),
    ];
    for (pressure, viscosity) in forms {
        let momentum = Momentum {
            material: Mixture(&fluids),
            pressure: Some(pressure),
            artificial_viscosity: 0.1,
            viscosity: Some(viscosity),
            smoothing_length: cloud.smoothing_length,
        };
        compare("momentum", &momentum, cloud, &domain, &mut pairs, p)?;
        let material = OneFluid::new(1.3, &fluids[0]);
        let Momentum {
            artificial_viscosity,
            smoothing_length,
            ..
        } = momentum;
        let momentum = Momentum {
            material,
            pressure: Some(pressure),
            artificial_viscosity,
            viscosity: Some(viscosity),
            smoothing_length,
        };
        compare(
            "momentum of one fluid",
            &momentum,
            cloud,
            &domain,
            &mut pairs,
            p,
        )?;
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn engine_matches_reference_in_2d(cloud in cloud()) {
        check::<2>(&cloud)?;
    }

    #[test]
    fn engine_matches_reference_in_3d(cloud in cloud()) {
        check::<3>(&cloud)?;
    }
}
