//! Calibrations on disk.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use serde::Deserialize;

use crate::failure::Failure;

/// What stands in a file.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Store {
    /// Cohesion of fluids, by free films.
    #[serde(default)]
    pub fluid: Vec<Entry>,
    /// Adhesion of walls, by films on them.
    #[serde(default)]
    pub wall: Vec<Entry>,
}

/// The coefficient of a fluid or of a wall.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Entry {
    /// Whose, for people.
    pub name: String,
    /// What is asked for: surface tension, N/m, or contact angle, degrees.
    pub asked: f64,
    /// What films show with the strength of a sharp surface.
    pub by_estimate: f64,
    /// The factor on that strength with which they show what is asked for.
    pub factor: f64,
    /// Half of its 95 % interval.
    pub factor_half_width: f64,
    /// Half of the 95 % interval of what films show with it.
    pub half_width: f64,
    /// What it is for.
    pub inputs: BTreeMap<String, String>,
}

/// The file beside a case file.
pub fn beside(case: &Path) -> PathBuf {
    case.with_extension("calibration.toml")
}

impl Store {
    /// Reads a file; an empty store where there is none.
    ///
    /// # Errors
    /// If it is there, and not what was written.
    pub fn read(path: &Path) -> Result<Self, Failure> {
        let reason = match std::fs::read_to_string(path) {
            Ok(text) => match toml::from_str(&text) {
                Ok(store) => return Ok(store),
                Err(error) => error.to_string(),
            },
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => {
                return Ok(Self::default());
            }
            Err(error) => error.to_string(),
        };
        Err(Failure::new(format!(
            "cannot read {}: {reason}; remove it, and it is measured anew",
            path.display()
        )))
    }

    /// Writes the file.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn write(&self, path: &Path) -> Result<(), Failure> {
        let text = self.text();
        if let Some(folder) = path
            .parent()
            .filter(|folder| !folder.as_os_str().is_empty())
        {
            std::fs::create_dir_all(folder).map_err(|error| {
                Failure::new(format!("cannot make {}: {error}", folder.display()))
            })?;
        }
        meniscus_output::replace_file(path, |out| std::io::Write::write_all(out, text.as_bytes()))?;
        Ok(())
    }

    fn text(&self) -> String {
        let mut text = String::from(
            "# Strength of cohesion and adhesion, measured on flat films by `meniscus calibrate`.\n\
             # An entry is used where all its inputs are those of a case.\n",
        );
        let sections = [("fluid", &self.fluid), ("wall", &self.wall)];
        for (section, entries) in sections {
            for entry in entries {
                text += &entry.text(section);
            }
        }
        text
    }
}

impl Entry {
    fn text(&self, section: &str) -> String {
        let Self {
            name,
            asked,
            by_estimate,
            factor,
            factor_half_width,
            half_width,
            inputs,
        } = self;
        let unit = if section == "fluid" { "N/m" } else { "degrees" };
        let mut text = format!(
            "\n[[{section}]]\nname = {name:?}\nasked = {asked:?} # {unit}\nby_estimate = {by_estimate:?}\n\
             factor = {factor:?}\nfactor_half_width = {factor_half_width:?}\nhalf_width = {half_width:?}\n\n\
             [{section}.inputs]\n"
        );
        for (name, value) in inputs {
            text += &format!("{name} = {value:?}\n");
        }
        text
    }
}

/// The entry for these inputs.
pub fn find<'a>(entries: &'a [Entry], inputs: &BTreeMap<String, String>) -> Option<&'a Entry> {
    entries.iter().find(|entry| entry.inputs == *inputs)
}

/// Puts an entry in the place of one for the same inputs.
pub fn put(entries: &mut Vec<Entry>, entry: Entry) {
    entries.retain(|other| other.inputs != entry.inputs);
    entries.push(entry);
}
