//! Dimensionless numbers that apply to a case.

use meniscus::scheme::BodyForce;
use meniscus::theory;
use meniscus_case::Case;

/// A dimensionless number.
pub struct Number {
    /// Its symbol.
    pub name: &'static str,
    /// Its value.
    pub value: f64,
    /// What it compares.
    pub meaning: &'static str,
}

/// Numbers of the first body: its diameter D (of the disc or ball of equal
/// volume), its fluid's properties, the largest speed U at the start.
///
/// Viscosity is what acts in the run, laminar and artificial together; where
/// the fluid has some of its own, the numbers with that alone follow.
pub fn of(case: &Case) -> Vec<Number> {
    let Some(body) = case.bodies.first() else {
        return Vec::new();
    };
    let fluid = &case.fluids[body.fluid];
    let diameter = 2.0 * theory::equivalent_radius(body.volume, case.dimension);
    let (rho, sigma) = (fluid.density, fluid.surface_tension);
    let speed = case.speeds.initial;
    let gravity = match &case.scheme.body_force {
        Some(BodyForce::Constant(g)) => g.iter().map(|g| g * g).sum::<f64>().sqrt(),
        _ => 0.0,
    };
    let mut numbers = Vec::new();
    let mut add = |applies: bool, name, value: f64, meaning| {
        if applies && value.is_finite() {
            numbers.push(Number {
                name,
                value,
                meaning,
            });
        }
    };
    let acting = rho * effective_viscosity(case, body.fluid);
    let laplace = |mu| theory::laplace_number(sigma, rho, diameter, mu);
    let reynolds = |mu| theory::reynolds_number(rho, speed, diameter, mu);
    let (tension, moving) = (sigma > 0.0, speed > 0.0);
    add(
        tension && acting > 0.0,
        "La",
        laplace(acting),
        "sigma rho D / mu^2: surface tension and inertia against viscosity",
    );
    add(
        tension && acting > 0.0,
        "Oh",
        theory::ohnesorge_number(sigma, rho, diameter, acting),
        "mu / sqrt(sigma rho D): viscosity against surface tension and inertia",
    );
    add(
        tension && moving,
        "We",
        theory::weber_number(rho, speed, diameter, sigma),
        "rho U^2 D / sigma: inertia against surface tension",
    );
    add(
        moving && acting > 0.0,
        "Re",
        reynolds(acting),
        "rho U D / mu: inertia against viscosity",
    );
    let own = fluid.viscosity;
    let both = own > 0.0 && own < acting;
    let meaning = "La without the artificial viscosity";
    add(tension && both, "La laminar", laplace(own), meaning);
    let meaning = "Re without the artificial viscosity";
    add(moving && both, "Re laminar", reynolds(own), meaning);
    add(
        tension && gravity > 0.0,
        "Bo",
        theory::bond_number(rho, gravity, diameter, sigma),
        "rho g D^2 / sigma: gravity against surface tension",
    );
    add(
        case.speeds.largest() > 0.0,
        "Ma",
        case.speeds.largest() / fluid.sound_speed,
        "largest expected speed over the numerical speed of sound",
    );
    numbers
}

/// Kinematic viscosity of a fluid, laminar and artificial together, m^2/s.
pub fn effective_viscosity(case: &Case, fluid: usize) -> f64 {
    let fluid = &case.fluids[fluid];
    // It acts on approaching pairs only, which are half of them.
    let artificial = 0.5
        * theory::artificial_kinematic_viscosity(
            case.scheme.artificial_viscosity,
            fluid.sound_speed,
            case.scheme.smoothing_length,
            case.dimension,
        );
    artificial + fluid.viscosity / fluid.density
}

/// Relative change of density that the case should show: (U / c)^2, with the
/// largest speed scale U.
pub fn expected_density_error(case: &Case) -> f64 {
    case.fluids
        .iter()
        .map(|fluid| (case.speeds.largest() / fluid.sound_speed).powi(2))
        .fold(0.0, f64::max)
}
