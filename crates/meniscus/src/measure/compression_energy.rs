//! The energy stored by compressing a liquid that follows Tait's equation of state.

use crate::fluid::Fluid;

/// Energy of compression per mass, J/kg: the integral of p / rho^2 from the
/// reference density rho_0 to rho, where
/// p = (rho_0 c^2 / gamma) ((rho / rho_0)^gamma - 1) + p_b.
///
/// In x = rho / rho_0 it is
/// `(c^2 / gamma) ((x^(gamma - 1) - 1) / (gamma - 1) + 1/x - 1) + (p_b / rho_0) (1 - 1/x)`,
/// where for gamma = 1 the first fraction is ln x. Without background pressure it is
/// never negative, and about c^2 (x - 1)^2 / 2 near x = 1. Density in kg/m^3.
pub fn specific_compression_energy(density: f64, fluid: &Fluid) -> f64 {
    // With l = ln x the terms that cancel near x = 1 are exact: expm1, not powers.
    let l = ((density - fluid.density) / fluid.density).ln_1p();
    let beyond = fluid.stiffness_exponent - 1.0;
    let power = if beyond == 0.0 {
        l
    } else {
        (beyond * l).exp_m1() / beyond
    };
    let inverse = (-l).exp_m1();
    fluid.sound_speed.powi(2) / fluid.stiffness_exponent * (power + inverse)
        - fluid.background_pressure / fluid.density * inverse
}

/// Energy of compression of all particles of one fluid, J; see
/// [`specific_compression_energy`].
pub fn compression_energy(masses: &[f64], densities: &[f64], fluid: &Fluid) -> f64 {
    masses
        .iter()
        .zip(densities)
        .map(|(m, &density)| m * specific_compression_energy(density, fluid))
        .sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn water(stiffness_exponent: f64, background_pressure: f64) -> Fluid {
        Fluid {
            sound_speed: 5.0,
            stiffness_exponent,
            background_pressure,
            ..Fluid::new("water", 1000.0)
        }
    }

    #[test]
    fn work_done_on_the_liquid_is_stored() {
        // dE = p / rho^2 d rho, by Simpson's rule; its error is below 1e-12 here.
        for (gamma, background) in [(7.0, 0.0), (1.0, 0.0), (7.0, 2000.0), (1.4, 50.0)] {
            let fluid = water(gamma, background);
            for end in [900.0, 990.0, 1000.0, 1003.0, 1100.0] {
                let f = |rho: f64| {
                    let x: f64 = rho / 1000.0;
                    (1000.0 * 25.0 / gamma * (x.powf(gamma) - 1.0) + background) / (rho * rho)
                };
                let n = 1000;
                let step = (end - 1000.0) / f64::from(n);
                let work: f64 = (0..n)
                    .map(|i| {
                        let rho = 1000.0 + f64::from(i) * step;
                        step / 6.0 * (f(rho) + 4.0 * f(rho + 0.5 * step) + f(rho + step))
                    })
                    .sum();
                let energy = specific_compression_energy(end, &fluid);
                assert!(
                    (energy - work).abs() <= 1e-10 * work.abs(),
                    "{gamma}, {end}: {energy}"
                );
            }
        }
    }

    #[test]
    fn a_small_compression_is_a_spring() {
        // c^2 (x - 1)^2 / 2 up to a relative (gamma - 5) (x - 1) / 3, to be resolved although
        // each term of the formula is a hundred million times larger.
        let energy = specific_compression_energy(1000.0 * (1.0 + 1e-8), &water(7.0, 0.0));
        assert!((energy / (25.0 * 0.5e-16) - 1.0).abs() < 1e-7, "{energy:e}");
        assert_eq!(specific_compression_energy(1000.0, &water(7.0, 500.0)), 0.0);
    }

    #[test]
    fn energies_add_up_by_mass() {
        let fluid = water(7.0, 0.0);
        let total = compression_energy(&[2.0, 3.0], &[1000.0, 1010.0], &fluid);
        assert_eq!(total, 3.0 * specific_compression_energy(1010.0, &fluid));
    }
}
