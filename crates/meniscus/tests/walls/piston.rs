//! A piston that compresses a liquid.

use meniscus::physics::equation_of_state::Tait;
use meniscus::scheme::{Motion, PressureForm, Scheme, Wall};
use meniscus::{Fluid, Simulation};

use crate::setups::channel;

/// Force per area on the resting wall and on the piston, and the range of pressure, over what
/// the equation of state has for the volume that is left.
fn compressed(spacing: f64) -> [f64; 4] {
    let liquid = Fluid::new("liquid", 1.0);
    let mut scheme = Scheme::new(1.5 * spacing);
    scheme.pressure = PressureForm::OverDensityProduct;
    let mut piston = Wall::new(2);
    // Down by a hundredth in half a period, from rest to rest, slowly against sound.
    piston.motion = Motion::Oscillation {
        amplitude: [0.0, -0.005, 0.0],
        frequency: 0.25,
        phase: -std::f64::consts::FRAC_PI_2,
    };
    let setup = channel(8, spacing, scheme, liquid.clone(), [Wall::new(1), piston]);
    let mut simulation = Simulation::new(setup).unwrap();
    simulation.advance_to(2.0).unwrap();
    let exact = Tait::new(&liquid).pressure(liquid.density / 0.99);
    let p = simulation.particles().of_bodies(|body| body == 0);
    let area = 8.0 * spacing;
    let load = |wall: usize| simulation.wall_loads()[wall].force[1] / area;
    let least = p.pressure.iter().copied().fold(f64::INFINITY, f64::min);
    let most = p.pressure.iter().copied().fold(0.0, f64::max);
    [-load(0), load(1), least, most].map(|pressure| pressure / exact)
}

#[test]
fn a_piston_raises_pressure_by_the_equation_of_state() {
    let (coarse, fine) = (compressed(0.05), compressed(0.025));
    for k in 0..4 {
        // The liquid next to a wall is compressed less than its neighbours, since the wall's
        // velocity does not go on changing behind its surface: an error in proportion to
        // the smoothing length, beyond which nothing is left.
        let limit = 2.0 * fine[k] - coarse[k];
        assert!((limit - 1.0).abs() < 0.02, "{k}: {coarse:?} {fine:?}");
        assert!((fine[k] - 1.0).abs() < 0.05, "{k}: {fine:?}");
    }
}
