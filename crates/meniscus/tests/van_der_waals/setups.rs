//! What makes no sense is refused, with the reason.

use meniscus::scheme::DensityForm;
use meniscus::{Setup, Simulation, SurfaceTension};

use crate::square;

fn refusal(change: impl Fn(&mut Setup<2>)) -> String {
    let mut setup = square::<2>(6, 0.0);
    change(&mut setup);
    Simulation::new(setup)
        .err()
        .map(|e| e.0)
        .unwrap_or_default()
}

#[test]
fn setups_that_make_no_sense_are_refused() {
    assert_eq!(refusal(|_| {}), "");
    let refusals = [
        (
            refusal(|setup| setup.scheme.density = DensityForm::Continuity),
            "summation",
        ),
        (
            refusal(|setup| setup.scheme.surface_tension = Some(SurfaceTension::default())),
            "own cohesion",
        ),
        (
            refusal(|setup| setup.scheme.artificial_viscosity = 0.1),
            "artificial viscosity",
        ),
        (
            refusal(|setup| setup.fluids.push(setup.fluids[0].clone())),
            "2 fluids",
        ),
        (
            refusal(|setup| setup.particles.iter_mut().for_each(|p| p.mass = 1.2)),
            "below 1/b",
        ),
        (
            refusal(|setup| {
                let model = setup.scheme.van_der_waals.as_mut().expect("set");
                model.temperature = 0.0;
            }),
            "temperature",
        ),
    ];
    for (found, part) in refusals {
        assert!(found.contains(part), "\"{found}\" does not say \"{part}\"");
    }
}
