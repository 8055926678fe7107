//! The folder of one run.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{Read, Write};
use std::path::{Path, PathBuf};

use serde::Serialize;

use crate::error::{OutputError, Problem};
use crate::replace::{PARTIAL, replace_file};
use crate::{checkpoint, collection};

const CASE: &str = "case.toml";
const RUN: &str = "run.json";
const SERIES: &str = "series.csv";
const REPORT: &str = "report.html";
const FRAMES: &str = "frames";
const CHECKPOINTS: &str = "checkpoints";
const FIGURES: &str = "figures";
const LOCK: &str = ".meniscus.lock";
/// Names of the figures that Meniscus wrote: others in that folder are the user's.
const FIGURE_LIST: &str = ".written";

/// The folder of one run, locked against other processes while this lives.
///
/// | name | content |
/// |---|---|
/// | `case.toml` | the case with every default written out |
/// | `run.json` | version, machine, seed, timings, dimensionless numbers |
/// | `series.csv` | time series |
/// | `frames/` | frames for ParaView |
/// | `checkpoints/` | states from which the run goes on |
/// | `figures/` | each figure as SVG and PNG |
/// | `report.html` | the report |
#[derive(Debug)]
pub struct RunFolder {
    root: PathBuf,
    _lock: File,
}

impl RunFolder {
    /// Makes the folder of a new run and writes the case into it.
    ///
    /// A folder that holds a run already is refused, unless `force` is set:
    /// then the files that Meniscus wrote there are removed first, and no
    /// others.
    pub fn create(root: &Path, case: &str, force: bool) -> Result<Self, OutputError> {
        fs::create_dir_all(root).map_err(OutputError::system(root, "create the folder"))?;
        let folder = Self::lock(root)?;
        let known = [CASE, RUN, SERIES, REPORT, FRAMES, CHECKPOINTS, FIGURES];
        if let Some(found) = known.iter().find(|name| root.join(name).exists()) {
            if !force {
                let found = (*found).to_owned();
                return Err(OutputError::new(root, Problem::HoldsARun { found }));
            }
            folder.remove_run()?;
        }
        for part in [FRAMES, CHECKPOINTS, FIGURES] {
            let path = root.join(part);
            fs::create_dir_all(&path).map_err(OutputError::system(&path, "create the folder"))?;
        }
        replace_file(&root.join(CASE), |out| out.write_all(case.as_bytes()))?;
        Ok(folder)
    }

    /// Opens the folder of a run to go on with it.
    pub fn open(root: &Path) -> Result<Self, OutputError> {
        if !root.join(CASE).is_file() {
            return Err(OutputError::new(root, Problem::NoRun));
        }
        Self::lock(root)
    }

    fn lock(root: &Path) -> Result<Self, OutputError> {
        let path = root.join(LOCK);
        let mut lock = OpenOptions::new()
            .read(true)
            .write(true)
            .create(true)
            .truncate(false)
            .open(&path)
            .map_err(OutputError::system(&path, "open the lock file"))?;
        match lock.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => {
                let mut owner = String::new();
                let readable = lock.read_to_string(&mut owner).is_ok() && !owner.is_empty();
                let owner = if readable {
                    owner
                } else {
                    "unnamed".to_owned()
                };
                return Err(OutputError::new(root, Problem::InUse { owner }));
            }
            Err(TryLockError::Error(cause)) => {
                return Err(OutputError::system(&path, "lock the folder")(cause));
            }
        }
        lock.set_len(0)
            .and_then(|()| write!(lock, "process {}", std::process::id()))
            .map_err(OutputError::system(&path, "write the lock file"))?;
        Ok(RunFolder {
            root: root.to_path_buf(),
            _lock: lock,
        })
    }

    /// The folder itself.
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// The case as it was run.
    pub fn case_file(&self) -> PathBuf {
        self.root.join(CASE)
    }

    /// Where the time series stands.
    pub fn series_file(&self) -> PathBuf {
        self.root.join(SERIES)
    }

    /// Where the frames stand.
    pub fn frames_folder(&self) -> PathBuf {
        self.root.join(FRAMES)
    }

    /// Where the checkpoints stand.
    pub fn checkpoints_folder(&self) -> PathBuf {
        self.root.join(CHECKPOINTS)
    }

    /// Reads the case back.
    pub fn read_case(&self) -> Result<String, OutputError> {
        let path = self.case_file();
        fs::read_to_string(&path).map_err(OutputError::system(&path, "read the case"))
    }

    /// Writes or replaces `run.json`.
    pub fn write_run(&self, run: &impl Serialize) -> Result<(), OutputError> {
        let path = self.root.join(RUN);
        let text = serde_json::to_string_pretty(run)
            .map_err(|e| OutputError::new(&path, Problem::BadData(e.to_string())))?;
        replace_file(&path, |out| writeln!(out, "{text}"))
    }

    /// Writes or replaces a file of `figures/`; gives its path.
    pub fn write_figure(&self, name: &str, content: &[u8]) -> Result<PathBuf, OutputError> {
        let folder = self.root.join(FIGURES);
        let path = folder.join(name);
        if Path::new(name).file_name() != Some(name.as_ref()) || name.contains(char::is_control) {
            let reason = format!("{name:?} is not the plain name of a file");
            return Err(OutputError::new(&folder, Problem::BadData(reason)));
        }
        fs::create_dir_all(&folder).map_err(OutputError::system(&folder, "create the folder"))?;
        // Listed before it is written: what stands there after a crash is known as ours.
        let mut listed = self.listed_figures();
        if !listed.iter().any(|known| known == name) {
            listed.push(name.to_owned());
            replace_file(&folder.join(FIGURE_LIST), |out| {
                listed.iter().try_for_each(|known| writeln!(out, "{known}"))
            })?;
        }
        replace_file(&path, |out| out.write_all(content))?;
        Ok(path)
    }

    /// Writes or replaces the report; gives its path.
    pub fn write_report(&self, html: &str) -> Result<PathBuf, OutputError> {
        let path = self.root.join(REPORT);
        replace_file(&path, |out| out.write_all(html.as_bytes()))?;
        Ok(path)
    }

    fn listed_figures(&self) -> Vec<String> {
        let list = self.root.join(FIGURES).join(FIGURE_LIST);
        let text = fs::read_to_string(list).unwrap_or_default();
        text.lines().map(str::to_owned).collect()
    }

    /// Removes what Meniscus wrote, by its names, and folders left empty.
    fn remove_run(&self) -> Result<(), OutputError> {
        let figures = self.listed_figures();
        let of_figures = |name: &str| name == FIGURE_LIST || figures.iter().any(|f| f == name);
        remove_matching(&self.root.join(FIGURES), &of_figures)?;
        remove_matching(&self.root.join(FRAMES), &collection::is_ours)?;
        remove_matching(&self.root.join(CHECKPOINTS), &checkpoint::is_ours)?;
        let of_root = |name: &str| [CASE, RUN, SERIES, REPORT].contains(&name);
        remove_matching(&self.root, &of_root)
    }
}

/// Removes the files of a folder that `ours` knows by name, half-written ones
/// too, and the folder itself if nothing else is in it.
fn remove_matching(folder: &Path, ours: &dyn Fn(&str) -> bool) -> Result<(), OutputError> {
    if !folder.is_dir() {
        return Ok(());
    }
    let list = || OutputError::system(folder, "list the folder");
    for entry in fs::read_dir(folder).map_err(list())? {
        let entry = entry.map_err(list())?;
        let name = entry.file_name();
        let Some(name) = name.to_str() else { continue };
        if ours(name.strip_suffix(PARTIAL).unwrap_or(name)) && !entry.path().is_dir() {
            let path = entry.path();
            fs::remove_file(&path).map_err(OutputError::system(&path, "remove the old file"))?;
        }
    }
    // Fails where the user's own files stand, which is right.
    let _ = fs::remove_dir(folder);
    Ok(())
}
