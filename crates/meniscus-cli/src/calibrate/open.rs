//! What a case leaves to be measured: cohesion first, since adhesion is measured with it.

use std::collections::BTreeMap;

use meniscus_case::{Case, Coefficients};

use super::film::Film;
use super::search::{self, Found};
use super::sentence;
use super::store::{Entry, Store, find, put};
use crate::failure::Failure;

/// Whose coefficient.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Whose {
    /// The cohesion of a fluid.
    Fluid,
    /// The adhesion of a wall.
    Wall,
}

impl Whose {
    /// What it is, before a name.
    pub fn what(self) -> &'static str {
        match self {
            Whose::Fluid => "cohesion of",
            Whose::Wall => "adhesion of",
        }
    }

    /// The key that takes it in a case file, and where.
    fn key(self, name: &str) -> String {
        match self {
            Whose::Fluid => format!("cohesion_factor = 1 in [fluid.{name}]"),
            Whose::Wall => format!("adhesion_factor = 1 for \"{name}\""),
        }
    }
}

/// How a case stands.
#[derive(Debug, Default)]
pub struct Open {
    /// What is known.
    pub coefficients: Coefficients,
    /// The same, as it stands in the store.
    pub found: Vec<(Whose, Entry)>,
    /// What is not known, such as "cohesion of water".
    pub missing: Vec<String>,
    /// How many were measured now.
    pub measured: usize,
}

/// Looks up all coefficients of a case; those that the store has not are measured, where somebody is to be told of it.
///
/// # Errors
/// If one cannot be measured.
pub fn complete(
    case: &Case,
    store: &mut Store,
    measure: Option<&dyn Fn(&str)>,
) -> Result<Open, Failure> {
    let mut open = Open::default();
    let mut cohesion: Vec<Option<f64>> = Vec::new();
    for (index, given) in case.given.cohesion.iter().enumerate() {
        let fluid = &case.fluids[index];
        let film = Film::new(case, index).filter(|_| !given);
        let Some(film) = film else {
            cohesion.push(Some(fluid.cohesion_factor));
            continue;
        };
        let inputs = film.inputs();
        let asked = fluid.surface_tension;
        let search = || search::cohesion(&film);
        let entry = open.look_up(
            (Whose::Fluid, &fluid.name, asked, 1.0),
            inputs,
            &mut store.fluid,
            measure,
            search,
        )?;
        cohesion.push(entry.as_ref().map(|entry| entry.factor));
        if let Some(entry) = entry {
            let name = fluid.name.clone();
            open.coefficients.cohesion.insert(name, entry.factor);
        }
    }
    for (index, given) in case.given.adhesion.iter().enumerate() {
        let (wall, film) = (&case.walls[index], Film::on_wall(case, index));
        let Some((film, foot)) = film.and_then(|film| Some((film.clone(), film.foot?))) else {
            continue;
        };
        if *given {
            continue;
        }
        let Some(cohesion) = cohesion[wall.fluid] else {
            open.missing.push(format!("adhesion of {}", wall.name));
            continue;
        };
        let mut inputs = film.inputs();
        inputs.insert("cohesion_factor".into(), format!("{cohesion:.9e}"));
        let degree = 1.0_f64.to_radians();
        let asked = foot.contact_angle / degree;
        let search = || search::adhesion(&film, foot, cohesion);
        let entry = open.look_up(
            (Whose::Wall, &wall.name, asked, degree),
            inputs,
            &mut store.wall,
            measure,
            search,
        )?;
        if let Some(entry) = entry {
            open.coefficients.adhesion.insert(index, entry.factor);
        }
    }
    Ok(open)
}

impl Open {
    /// One coefficient: whose, its name, what is asked for and the unit of that in SI.
    fn look_up(
        &mut self,
        (whose, name, asked, unit): (Whose, &str, f64, f64),
        inputs: BTreeMap<String, String>,
        entries: &mut Vec<Entry>,
        measure: Option<&dyn Fn(&str)>,
        search: impl FnOnce() -> Result<Found, Failure>,
    ) -> Result<Option<Entry>, Failure> {
        let what = format!("{} {name}", whose.what());
        let entry = match (find(entries, &inputs), measure) {
            (Some(entry), _) => entry.clone(),
            (None, None) => {
                self.missing.push(what);
                return Ok(None);
            }
            (None, Some(tell)) => {
                tell(&format!("measuring the {what} on flat films ..."));
                let found = search().map_err(|failure| {
                    Failure::new(format!(
                        "{}\nto run with the strength of a sharp surface all the same: {}",
                        failure.message(),
                        whose.key(name)
                    ))
                })?;
                let entry = Entry {
                    name: name.to_owned(),
                    asked,
                    by_estimate: found.by_estimate / unit,
                    factor: found.factor.value,
                    factor_half_width: found.factor.half_width,
                    half_width: found.half_width / unit,
                    inputs,
                };
                tell(&sentence(whose, &entry));
                put(entries, entry.clone());
                self.measured += 1;
                entry
            }
        };
        self.found.push((whose, entry.clone()));
        Ok(Some(entry))
    }
}
