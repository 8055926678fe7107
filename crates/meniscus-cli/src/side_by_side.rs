//! The last frames of several cases of a paper in one picture.

use std::path::{Path, PathBuf};

use meniscus_output::FrameReader;
use meniscus_report::{ParticlePictures, Snapshot};
use serde::Deserialize;

use crate::batch::Job;
use crate::failure::Failure;
use crate::table::capital;

/// A picture that `reproduction.toml` asks for.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SideBySide {
    /// Name of its files.
    name: String,
    /// Case files, panel by panel; those of numbers.
    cases: Vec<String>,
    /// The field that colours the particles.
    field: String,
    /// Its unit.
    unit: String,
}

/// Where a case leaves its frames, and how large its particles are, m.
pub struct Panel {
    case: String,
    frames: PathBuf,
    spacing: f64,
}

impl Panel {
    /// Of a job that is yet to run.
    pub fn of(job: &Job) -> Self {
        Self {
            case: job.name.clone(),
            frames: job.folder.frames_folder(),
            spacing: job.case.spacing,
        }
    }
}

impl SideBySide {
    /// Draws it into `root`, and says where.
    ///
    /// # Errors
    /// If a case left no frames, or a file cannot be written.
    pub fn draw(&self, panels: &[Panel], root: &Path) -> Result<PathBuf, Failure> {
        let titles = self
            .cases
            .iter()
            .map(|case| case.trim_end_matches(".toml").to_owned());
        let mut pictures =
            ParticlePictures::new(&capital(&self.field), &self.unit).titled(titles.collect());
        for case in &self.cases {
            let missing = || Failure::new(format!("picture {}: {case} left no frame", self.name));
            let panel = (panels.iter().find(|panel| &panel.case == case)).ok_or_else(missing)?;
            let reader = FrameReader::open(&panel.frames)?;
            let last = reader.times().len().checked_sub(1).ok_or_else(missing)?;
            let frame = reader.read(last)?;
            let field = frame.fields.iter().find(|field| field.name == self.field);
            pictures = pictures.with(Snapshot {
                time: frame.time,
                positions: frame.positions.clone(),
                diameter: panel.spacing,
                values: field.map_or_else(Vec::new, |field| field.values.clone()),
            });
        }
        let figure = pictures.figure(&self.name, "");
        let broken = |error| Failure::new(format!("cannot draw {}: {error}", self.name));
        let path = root.join(format!("{}.png", self.name));
        let unwritten = |error| Failure::new(format!("cannot write {}: {error}", path.display()));
        std::fs::write(&path, figure.png().map_err(broken)?).map_err(unwritten)?;
        let svg = figure.svg().map_err(broken)?;
        std::fs::write(path.with_extension("svg"), svg).map_err(unwritten)?;
        Ok(path)
    }
}
