//! Calibrations on disk.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use serde::Deserialize;

use crate::failure::Failure;

/// What stands in a file.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Store {
    /// One entry for each film.
    #[serde(default)]
    pub film: Vec<Entry>,
}

/// A film and its coefficient.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Entry {
    /// Of which fluid, for people.
    pub fluid: String,
    /// Surface tension asked for, N/m.
    pub asked: f64,
    /// What films show with the strength of a sharp surface, over that.
    pub by_estimate: f64,
    /// The factor on that strength.
    pub cohesion_factor: f64,
    /// Half of its 95 % interval.
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

    /// The entry for these inputs.
    pub fn find(&self, inputs: &BTreeMap<String, String>) -> Option<&Entry> {
        self.film.iter().find(|entry| entry.inputs == *inputs)
    }

    /// Puts an entry in the place of one for the same inputs.
    pub fn put(&mut self, entry: Entry) {
        self.film.retain(|other| other.inputs != entry.inputs);
        self.film.push(entry);
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
            "# Strength of pairwise forces, measured on flat films by `meniscus calibrate`.\n\
             # An entry is used where all its inputs are those of a case.\n",
        );
        for entry in &self.film {
            text += &format!(
                "\n[[film]]\nfluid = {:?}\nasked = {:?}\nby_estimate = {:?}\n\
                 cohesion_factor = {:?}\nhalf_width = {:?}\n\n[film.inputs]\n",
                entry.fluid,
                entry.asked,
                entry.by_estimate,
                entry.cohesion_factor,
                entry.half_width
            );
            for (name, value) in &entry.inputs {
                text += &format!("{name} = {value:?}\n");
            }
        }
        text
    }
}
