//! Pressure against density.

use meniscus::fluid::Fluid;
use meniscus::physics::equation_of_state::Tait;

use crate::common::fluid;

/// A liquid whose bulk modulus rho c^2 grows as rho^gamma has
/// c = c_0 (rho / rho_0)^((gamma - 1) / 2), and p_b at its reference density.
#[test]
fn the_speed_of_sound_grows_with_density() {
    for gamma in [1.0, 1.4, 2.0, 7.0] {
        let liquid = Tait::new(&Fluid {
            density: 900.0,
            sound_speed: 30.0,
            stiffness_exponent: gamma,
            background_pressure: 250.0,
            ..fluid(0.0, 0.0)
        });
        assert_eq!(liquid.pressure(900.0), 250.0);
        for ratio in [0.5, 0.9, 1.0, 1.1, 2.0] {
            let density: f64 = 900.0 * ratio;
            // Slope by differences: their error is (gamma step / rho)^2 / 6.
            let step = 1e-4 * density;
            let rise = liquid.pressure(density + step) - liquid.pressure(density - step);
            let speed = (rise / (2.0 * step)).sqrt();
            let expected = 30.0 * f64::powf(ratio, 0.5 * (gamma - 1.0));
            assert!(
                (speed / expected - 1.0).abs() < 1e-6,
                "{gamma}, {ratio}: {speed}, {expected}"
            );
        }
    }
}
