//! What a van der Waals fluid asks of a setup.

use super::{Setup, SetupError};
use crate::particles::Particles;
use crate::physics::momentum::PressureForm;
use crate::physics::viscosity::ViscosityForm;
use crate::scheme::{DensityForm, VanDerWaals};

pub(super) fn validate<const D: usize>(setup: &Setup<D>) -> Result<(), SetupError> {
    let scheme = &setup.scheme;
    let Some(model) = &scheme.van_der_waals else {
        return Ok(());
    };
    let complain = |what: String| Err(SetupError(format!("a van der Waals fluid {what}")));
    let [fluid] = &setup.fluids[..] else {
        return complain(format!(
            "is alone: its equation of state holds for all particles, and there are {} fluids",
            setup.fluids.len()
        ));
    };
    if scheme.density != DensityForm::Summation {
        return complain(
            "has its density by summation: continuity would not know what evaporates".into(),
        );
    }
    if scheme.surface_tension.is_some() {
        return complain(
            "has its surface tension from its own cohesion: leave out the model of it".into(),
        );
    }
    if !scheme.walls.is_empty() {
        return complain(
            "has no walls: their pressure is made for a liquid that is hardly compressed".into(),
        );
    }
    if scheme.artificial_viscosity != 0.0 {
        return complain(
            "has no artificial viscosity, whose heat would be lost: give a viscosity".into(),
        );
    }
    if scheme.viscosity != ViscosityForm::Stress {
        return complain(
            "has the viscous force of the whole stress: viscosity = \"stress\"".into(),
        );
    }
    if scheme.pressure != PressureForm::OverDensitySquared {
        return complain("has one form of the pressure gradient: over-density-squared".into());
    }
    if model.cohesion_adapts && scheme.adaptive_smoothing.is_none() {
        return complain(
            "has a range of cohesion that adapts where smoothing lengths do: ask for adaptive smoothing"
                .into(),
        );
    }
    let VanDerWaals {
        substance,
        temperature,
        conductivity,
        bulk_viscosity,
        cohesion_range,
        ..
    } = *model;
    for (name, value) in [
        ("gas constant", substance.gas_constant),
        ("excluded volume b", substance.excluded_volume),
        ("number of degrees of freedom", substance.degrees_of_freedom),
        ("temperature at the start", temperature),
    ] {
        if !(value > 0.0 && value.is_finite()) {
            return complain(format!(
                "has a {name} that must be positive and finite, found {value}"
            ));
        }
    }
    for (name, value) in [
        ("cohesion a", substance.cohesion),
        ("heat conductivity", conductivity),
        ("bulk viscosity", bulk_viscosity),
    ] {
        if !(value >= 0.0 && value.is_finite()) {
            return complain(format!(
                "has a {name} that must be finite and not negative, found {value}"
            ));
        }
    }
    let highest = 1.0 / substance.excluded_volume;
    if fluid.density >= highest {
        return complain(format!(
            "stays below density 1/b = {highest:.4}, found {}",
            fluid.density
        ));
    }
    if !(1.0..=4.0).contains(&cohesion_range) {
        return complain(format!(
            "has cohesion over 1 to 4 smoothing lengths, usually 2, found {cohesion_range}"
        ));
    }
    Ok(())
}

/// Whether the summed density leaves room for the molecules.
pub(crate) fn check_density<const D: usize>(
    model: &VanDerWaals,
    particles: &Particles<D>,
) -> Result<(), SetupError> {
    let highest = 1.0 / model.substance.excluded_volume;
    let worst = (0..particles.len())
        .max_by(|&i, &j| particles.density[i].total_cmp(&particles.density[j]))
        .filter(|&i| particles.density[i] >= highest);
    match worst {
        Some(i) => Err(SetupError(format!(
            "particle {} has density {:.4}, by summation; a van der Waals fluid stays below 1/b = {highest:.4}: \
             raise the spacing or lower the density",
            particles.id[i], particles.density[i]
        ))),
        None => Ok(()),
    }
}
