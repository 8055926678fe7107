//! The models that are appraised.

/// A model of surface tension, with the settings that a user gets who names it.
#[derive(Clone, Copy, Debug)]
pub struct Model {
    /// Its name in a case file.
    pub name: &'static str,
    /// Whether it knows contact angles.
    pub wets: bool,
}

const fn model(name: &'static str, wets: bool) -> Model {
    Model { name, wets }
}

/// All models of a free surface.
pub const MODELS: [Model; 10] = [
    model("capillary-pressure", true),
    model("balanced", true),
    model("jancik-hyhlik", false),
    model("continuum", false),
    model("total-variation", true),
    model("akinci", true),
    model("cosine", true),
    model("gaussian-pair", true),
    model("kordilla", true),
    model("lennard-jones", true),
];

impl Model {
    /// The lines of a case's `[physics]` that choose it.
    pub fn physics(&self) -> String {
        format!("surface_tension = \"{}\"\n", self.name)
    }
}

/// Looks a model up by name, for the command line.
///
/// # Errors
/// The names that there are.
pub fn by_name(name: &str) -> Result<Model, String> {
    (MODELS.iter().find(|model| model.name == name).copied()).ok_or_else(|| {
        let names: Vec<&str> = MODELS.iter().map(|model| model.name).collect();
        format!("no such model; there are {}", names.join(", "))
    })
}
