//! A liquid at rest in a tank.

use meniscus::rates::{Dimension, Space};
use meniscus::scheme::{BodyForce, DensityDiffusion, DiffusionForm, Motion, PressureForm, Scheme};
use meniscus::{Fluid, Simulation, Vector};

use crate::setups::tank;

const DEPTH: f64 = 1.0;
const GRAVITY: f64 = 9.81;

/// A tank of a liquid of this density, one across and 1.25 high, after it has come to rest.
pub fn at_rest<const D: usize>(
    spacing: f64,
    density: f64,
    time: f64,
    change: impl Fn(&mut Scheme),
) -> Simulation<D>
where
    Space: Dimension<D>,
{
    let mut liquid = Fluid::new("liquid", density);
    liquid.sound_speed = 10.0 * (GRAVITY * DEPTH).sqrt();
    let mut scheme = Scheme::new(2.0 * spacing);
    scheme.pressure = PressureForm::OverDensityProduct;
    let mut down = [0.0; 3];
    down[D - 1] = -GRAVITY;
    scheme.body_force = Some(BodyForce::Constant(down));
    scheme.damping = 10.0;
    change(&mut scheme);
    let setup = tank::<D>(1.0, 1.25, DEPTH, spacing, scheme, liquid);
    let mut simulation = Simulation::new(setup).unwrap();
    simulation.advance_to(time).unwrap();
    simulation
}

/// delta-SPH as it is used most.
fn smoothed(scheme: &mut Scheme) {
    scheme.density_diffusion = Some(DensityDiffusion {
        form: DiffusionForm::Antuono,
        strength: 0.1,
    });
}

/// The largest difference of pressure from the weight above, over that of the whole depth.
pub fn worst<const D: usize>(simulation: &Simulation<D>, density: f64) -> f64 {
    let p = simulation.particles();
    let weight = density * GRAVITY;
    (0..p.len())
        .filter(|&i| !simulation.is_wall(p.body[i]))
        .map(|i| p.pressure[i] - weight * (DEPTH - p.position[i][D - 1]))
        .fold(0.0, |worst: f64, error| worst.max(error.abs()))
        / (weight * DEPTH)
}

#[test]
fn pressure_is_the_weight_of_what_lies_above_also_in_corners() {
    let density = 1000.0;
    let simulation = at_rest::<2>(0.04, density, 2.5, smoothed);
    let error = worst(&simulation, density);

    assert!(error < 0.02, "{error}");
    // The tank carries the weight, a bottom of length 1 in the middle; what moves still,
    // at less than 1e-4 of the speed of sound, is a thousandth of it.
    let load = simulation.wall_loads()[0];
    let weight = density * GRAVITY * DEPTH;
    assert!((load.force[1] / -weight - 1.0).abs() < 1e-3, "{load:?}");
    assert!(
        (load.moment[2] / (-0.5 * weight) - 1.0).abs() < 1e-3,
        "{load:?}"
    );
    assert!(load.force[0].abs() < 1e-3 * weight, "{load:?}");
    // The liquid stays: none has left its tank or climbed.
    let p = simulation.particles();
    for i in (0..p.len()).filter(|&i| !simulation.is_wall(p.body[i])) {
        let Vector([x, y]) = p.position[i];
        assert!((0.0..1.0).contains(&x) && (0.0..DEPTH).contains(&y));
    }
}

#[test]
fn a_rocked_tank_lets_no_liquid_into_its_walls() {
    let spacing = 0.025;
    let mut liquid = Fluid::new("liquid", 1000.0);
    liquid.sound_speed = 19.18;
    let mut scheme = Scheme::new(2.0 * spacing);
    scheme.pressure = PressureForm::OverDensityProduct;
    scheme.body_force = Some(BodyForce::Constant([0.0, -GRAVITY, 0.0]));
    let mut setup = tank::<2>(1.0, 0.8, 0.4, spacing, scheme, liquid);
    // Near the first mode of sloshing: waves of a fifth of the depth.
    let motion = Motion::Oscillation {
        velocity: [0.0; 3],
        amplitude: [0.02, 0.0, 0.0],
        frequency: 0.8,
        phase: 0.0,
    };
    setup.scheme.walls[0].motion = motion.clone();
    let mut simulation = Simulation::new(setup).unwrap();
    let mut highest: f64 = 0.0;
    for k in 1..=30 {
        simulation.advance_to(0.1 * f64::from(k)).unwrap();
        let left = motion.at(Vector([0.0, 0.0]), simulation.time()).position[0];
        let p = simulation.particles();
        for i in (0..p.len()).filter(|&i| !simulation.is_wall(p.body[i])) {
            let Vector([x, y]) = p.position[i];
            // The waves press single particles nearer than half a spacing to the wall's own,
            // whose first lie that far behind its surface: none passes these.
            let room = left - 0.5 * spacing..left + 1.0 + 0.5 * spacing;
            assert!(room.contains(&x) && y > 0.0, "{x} {y}");
            highest = highest.max(y);
        }
    }
    assert!(highest > 0.48, "{highest}");
}

#[test]
fn a_tank_in_three_dimensions_carries_its_liquid() {
    let simulation = at_rest::<3>(0.1, 1000.0, 1.5, smoothed);
    let error = worst(&simulation, 1000.0);
    // Ten particles deep: half a spacing's head is 5 %.

    assert!(error < 0.05, "{error}");
    let load = simulation.wall_loads()[0].force[2];
    assert!(
        (load / (-1000.0 * GRAVITY * DEPTH) - 1.0).abs() < 1e-3,
        "{load}"
    );
}
