//! What walls feel is what the liquid loses.

use meniscus::measure::{angular_momentum, linear_momentum};
use meniscus::physics::wall::layout::Side;
use meniscus::rates::{Dimension, Space};
use meniscus::scheme::{BodyForce, Motion, PressureForm, Scheme, Slip, ViscosityForm, Wall};
use meniscus::{Fluid, Setup, Simulation, Vector};

use crate::common::noise;
use crate::setups::{layers, tank, wall_particles};

/// A jittered liquid in a tank that is shaken, with an obstacle at its bottom.
pub fn shaken<const D: usize>(pressure: PressureForm) -> Setup<D> {
    let spacing = 0.1;
    let mut liquid = Fluid::new("liquid", 1000.0);
    liquid.sound_speed = 30.0;
    liquid.viscosity = 1.0;
    let mut scheme = Scheme::new(1.5 * spacing);
    scheme.pressure = pressure;
    scheme.viscosity = ViscosityForm::MonaghanCleary;
    let mut down = [0.0; 3];
    down[D - 1] = -9.81;
    scheme.body_force = Some(BodyForce::Constant(down));
    let mut setup = tank::<D>(1.0, 1.0, 0.7, spacing, scheme, liquid);
    // The obstacle takes the place of some liquid, a support's reach from the walls.
    let mut centre = Vector([0.5; D]);
    centre[D - 1] = 0.15;
    let radius = 0.15;
    setup
        .particles
        .retain(|p| p.body == 1 || (p.position - centre).norm() > radius + 0.5 * spacing);
    for (k, particle) in setup.particles.iter_mut().enumerate() {
        if particle.body == 0 {
            for d in 0..D {
                particle.position[d] += 0.1 * spacing * noise((k * D + d) as i64);
            }
        }
    }
    let obstacle = layers(&setup.scheme, spacing)
        .ball(centre, radius, Side::Inside)
        .unwrap();
    setup
        .particles
        .extend(wall_particles(obstacle, 2, 1000.0, spacing));
    setup.scheme.walls[0].motion = Motion::Oscillation {
        velocity: [0.0; 3],
        amplitude: [0.02, 0.0, 0.0],
        frequency: 3.0,
        phase: 0.3,
    };
    setup.scheme.walls.push(Wall {
        slip: Slip::FreeSlip,
        motion: Motion::Oscillation {
            velocity: [0.0; 3],
            amplitude: [0.02, 0.0, 0.0],
            frequency: 3.0,
            phase: 0.3,
        },
        ..Wall::new(2)
    });
    setup
}

/// Linear and angular momentum of the liquid, and the rates of both by weight and walls.
fn state<const D: usize>(simulation: &Simulation<D>) -> ([f64; 6], [f64; 6]) {
    let liquid = simulation.particles().of_bodies(|body| body == 0);
    let momentum = linear_momentum(&liquid.velocity, &liquid.mass).to_3d();
    let spin = angular_momentum(
        &liquid.position,
        &liquid.velocity,
        &liquid.mass,
        Vector::ZERO,
    );
    let mut weight = liquid.clone();
    let mut down = Vector::ZERO;
    down[D - 1] = -9.81;
    weight.velocity.fill(down);
    let force = linear_momentum(&weight.velocity, &weight.mass).to_3d();
    let moment = angular_momentum(
        &weight.position,
        &weight.velocity,
        &weight.mass,
        Vector::ZERO,
    );
    let mut rate = [0.0; 6];
    for d in 0..3 {
        rate[d] = force[d];
        rate[d + 3] = moment[d];
        for load in simulation.wall_loads() {
            rate[d] -= load.force[d];
            rate[d + 3] -= load.moment[d];
        }
    }
    let state = std::array::from_fn(|k| if k < 3 { momentum[k] } else { spin[k - 3] });
    (state, rate)
}

fn budget_closes<const D: usize>(pressure: PressureForm)
where
    Space: Dimension<D>,
{
    let mut simulation = Simulation::<D>::new(shaken(pressure)).unwrap();
    let (start, mut rate) = state(&simulation);
    let mut expected = start;
    let mut scale = 0.0_f64;
    for _ in 0..60 {
        let dt = simulation.next_step();
        simulation.step().unwrap();
        let (_, next) = state(&simulation);
        for k in 0..6 {
            // What the two kicks of a step add.
            expected[k] += 0.5 * dt * (rate[k] + next[k]);
            scale = scale.max(rate[k].abs() * dt * 60.0);
        }
        rate = next;
    }
    let (end, _) = state(&simulation);
    for k in 0..6 {
        // Rounding of sums over a thousand particles.
        assert!(
            (end[k] - expected[k]).abs() < 1e-10 * scale,
            "{k}: {} for {}",
            end[k],
            expected[k]
        );
    }
}

#[test]
fn force_and_moment_on_walls_are_what_the_liquid_loses() {
    for pressure in [
        PressureForm::OverDensitySquared,
        PressureForm::OverDensityProduct,
        PressureForm::HuAdams,
    ] {
        budget_closes::<2>(pressure);
    }
    budget_closes::<3>(PressureForm::OverDensityProduct);
}
