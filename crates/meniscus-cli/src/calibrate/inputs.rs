//! What a film depends on: a coefficient holds for these inputs, and for no others.

use std::collections::BTreeMap;

use meniscus::physics::surface_tension::pairwise::Pairwise;
use meniscus::physics::surface_tension::pairwise::akinci::{Curvature, Normalisation, Reading};
use meniscus::scheme::{Fluid, VanDerWaals};

use super::film::Film;

/// Which films these are: another way of making them is another number.
const PROTOCOL: u32 = 1;

impl Film {
    /// Everything that its tension over the one asked for depends on: in units of density, spacing and
    /// surface tension, so that it is the same film at any scale.
    pub fn inputs(&self) -> BTreeMap<String, String> {
        let mut inputs = BTreeMap::from(
            [
                ("protocol", PROTOCOL.to_string()),
                ("dimension", self.dimension.to_string()),
                ("kernel", self.scheme.kernel.name().to_owned()),
                (
                    "smoothing_length_over_spacing",
                    number(self.scheme.smoothing_length / self.spacing),
                ),
                ("density_form", format!("{:?}", self.scheme.density)),
                ("pressure_form", format!("{:?}", self.scheme.pressure)),
            ]
            .map(|(name, value)| (name.to_owned(), value)),
        );
        if let Some(model) = self.pairwise() {
            inputs.extend(self.of_pairs(model));
        }
        if let Some(model) = &self.scheme.van_der_waals {
            inputs.extend(self.of_molecules(model));
        }
        if let Some(foot) = self.foot {
            let degrees = foot.contact_angle.to_degrees();
            inputs.insert("contact_angle".into(), format!("{degrees:.6} deg"));
            inputs.insert("bears".into(), format!("{:?}", foot.bearing));
        }
        inputs
    }

    /// Of pairwise forces.
    fn of_pairs(&self, model: Pairwise) -> BTreeMap<String, String> {
        let Fluid {
            density,
            surface_tension,
            ..
        } = self.fluid;
        let pressure = surface_tension / self.spacing;
        let speed = (pressure / density).sqrt();
        let fluid = self.liquid(1.0);
        let mut inputs = BTreeMap::from(
            [
                ("model", model.name().to_owned()),
                (
                    "sound_speed_over_capillary_speed",
                    number(fluid.sound_speed / speed),
                ),
                (
                    "sound_speed",
                    if self.speeds.is_some() {
                        "default"
                    } else {
                        "given"
                    }
                    .to_owned(),
                ),
                ("stiffness_exponent", number(fluid.stiffness_exponent)),
                (
                    "background_pressure_over_capillary_pressure",
                    number(fluid.background_pressure / pressure),
                ),
                (
                    "density_diffusion",
                    format!("{:?}", self.scheme.density_diffusion),
                ),
                ("velocity_smoothing", number(self.scheme.velocity_smoothing)),
            ]
            .map(|(name, value)| (name.to_owned(), value)),
        );
        if let Pairwise::LennardJones(model) = model {
            let ratio = number(model.rest_distance / self.spacing);
            inputs.insert("rest_distance_over_spacing".into(), ratio);
        }
        if let Some(akinci) = model.akinci() {
            inputs.insert("akinci".into(), format!("{akinci:?}"));
            // As printed these are out of units, and know what a metre is.
            if akinci.curvature != Curvature::None
                || akinci.normalisation == Normalisation::Printed
                || akinci.reading == Reading::Acceleration
            {
                inputs.insert("density".into(), number(density));
                inputs.insert("spacing".into(), number(self.spacing));
                inputs.insert("surface_tension".into(), number(surface_tension));
            }
        }
        if let Pairwise::GaussianPair(form) = model {
            inputs.insert("form".into(), format!("{form:?}"));
        }
        inputs
    }

    /// Of a van der Waals fluid, whose strength alone sets density, surface tension and temperature apart.
    fn of_molecules(&self, model: &VanDerWaals) -> BTreeMap<String, String> {
        let reduced = model.temperature / model.substance.critical_point().temperature;
        let range = if model.cohesion_adapts {
            "adaptive"
        } else {
            "fixed"
        };
        BTreeMap::from(
            [
                ("model", "van-der-waals".to_owned()),
                ("reduced_temperature", number(reduced)),
                ("cohesion_range", number(model.cohesion_range)),
                ("cohesion_smoothing", range.to_owned()),
                (
                    "adaptive_smoothing",
                    format!("{:?}", self.scheme.adaptive_smoothing),
                ),
            ]
            .map(|(name, value)| (name.to_owned(), value)),
        )
    }
}

fn number(value: f64) -> String {
    format!("{value:.9e}")
}
