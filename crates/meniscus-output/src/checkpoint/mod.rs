//! Checkpoints: the whole state of a run, from which it goes on.
//!
//! [`container`] is the layout of one file, with magic, versions, lengths and
//! checksum. [`Checkpoints`] is the folder: it writes a new file beside the
//! older ones, keeps the last few, and finds the latest that is whole.

mod container;

use std::fs;
use std::path::{Path, PathBuf};

use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::error::{OutputError, Problem};
use crate::replace::{PARTIAL, replace_file};

/// How many checkpoints a folder keeps: the latest, and one to fall back on.
const KEPT: usize = 2;

/// A state read back.
#[derive(Clone, Debug, PartialEq)]
pub struct Checkpoint<State> {
    /// Steps done.
    pub step: u64,
    /// Simulated time, s.
    pub time: f64,
    /// The state.
    pub state: State,
}

/// The latest checkpoint that could be read.
#[derive(Debug)]
pub struct Restored<State> {
    /// Its content.
    pub checkpoint: Checkpoint<State>,
    /// Its file.
    pub path: PathBuf,
    /// Later ones that could not be read, latest first, each with its reason.
    pub passed_over: Vec<OutputError>,
}

/// A folder of checkpoints of one run.
#[derive(Clone, Debug)]
pub struct Checkpoints {
    folder: PathBuf,
    state_version: u32,
}

impl Checkpoints {
    /// The checkpoints in `folder`, which is created where it is missing.
    ///
    /// `state_version` numbers the layout of the state. The file does not
    /// describe its own layout, so the program that changes the state's
    /// fields counts this up, and files of another number are refused.
    pub fn open(folder: &Path, state_version: u32) -> Result<Self, OutputError> {
        fs::create_dir_all(folder).map_err(OutputError::system(folder, "create the folder"))?;
        Ok(Checkpoints {
            folder: folder.to_path_buf(),
            state_version,
        })
    }

    /// Writes a checkpoint and gives its path.
    ///
    /// Once the new file stands whole on the disk, all but the two latest are
    /// removed, and with them any of a later step: those belong to a course
    /// of the run that a resume has left. After an error the older
    /// checkpoints stand untouched.
    pub fn save<State: Serialize>(
        &self,
        step: u64,
        time: f64,
        state: &State,
    ) -> Result<PathBuf, OutputError> {
        let path = self.folder.join(file_name(step));
        let bytes = container::pack(self.state_version, step, time, state)
            .map_err(|problem| OutputError::new(&path, problem))?;
        replace_file(&path, |out| out.write_all(&bytes))?;
        self.remove_old(step)?;
        Ok(path)
    }

    /// Reads one checkpoint, refusing a file that is not whole.
    pub fn load<State: DeserializeOwned>(
        &self,
        path: &Path,
    ) -> Result<Checkpoint<State>, OutputError> {
        let bytes = fs::read(path).map_err(OutputError::system(path, "read the file"))?;
        container::unpack(self.state_version, &bytes)
            .map_err(|problem| OutputError::new(path, problem))
    }

    /// Reads the latest checkpoint that is whole.
    pub fn latest_good<State: DeserializeOwned>(&self) -> Result<Restored<State>, OutputError> {
        let mut passed_over = Vec::new();
        for (_, path) in self.list()? {
            match self.load(&path) {
                Ok(checkpoint) => {
                    return Ok(Restored {
                        checkpoint,
                        path,
                        passed_over,
                    });
                }
                Err(error) => passed_over.push(error),
            }
        }
        let problem = Problem::NoGoodCheckpoint(passed_over);
        Err(OutputError::new(&self.folder, problem))
    }

    /// Steps and files of the checkpoints, latest first.
    fn list(&self) -> Result<Vec<(u64, PathBuf)>, OutputError> {
        let mut found = Vec::new();
        for name in self.names()? {
            if let Some(step) = step_of(&name) {
                found.push((step, self.folder.join(name)));
            }
        }
        found.sort_by_key(|(step, _)| std::cmp::Reverse(*step));
        Ok(found)
    }

    fn names(&self) -> Result<Vec<String>, OutputError> {
        let list = || OutputError::system(&self.folder, "list the folder");
        let mut names = Vec::new();
        for entry in fs::read_dir(&self.folder).map_err(list())? {
            let entry = entry.map_err(list())?;
            // A name that is not text is none of ours.
            names.extend(entry.file_name().into_string().ok());
        }
        Ok(names)
    }

    fn remove_old(&self, step: u64) -> Result<(), OutputError> {
        let mut kept = 0;
        let mut old = Vec::new();
        for (found, path) in self.list()? {
            if found <= step && kept < KEPT {
                kept += 1;
            } else {
                old.push(path);
            }
        }
        let broken_off = |name: &String| name.ends_with(PARTIAL) && is_ours(name);
        let partial = self.names()?.into_iter().filter(broken_off);
        old.extend(partial.map(|name| self.folder.join(name)));
        for path in old {
            fs::remove_file(&path)
                .map_err(OutputError::system(&path, "remove an old checkpoint"))?;
        }
        Ok(())
    }
}

fn file_name(step: u64) -> String {
    format!("step-{step:012}.checkpoint")
}

fn step_of(name: &str) -> Option<u64> {
    let digits = name.strip_prefix("step-")?.strip_suffix(".checkpoint")?;
    digits.parse().ok()
}

/// Whether Meniscus gives this name to a file of the folder of checkpoints.
pub(crate) fn is_ours(name: &str) -> bool {
    step_of(name.strip_suffix(PARTIAL).unwrap_or(name)).is_some()
}
