//! What can go wrong with a file, and where.

use std::error::Error;
use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

/// A failure at one path.
#[derive(Debug)]
pub struct OutputError {
    /// The file or folder concerned.
    pub path: PathBuf,
    /// What is wrong with it.
    pub problem: Problem,
}

/// What is wrong with a file or folder.
#[derive(Debug)]
pub enum Problem {
    /// The system refused.
    System {
        /// What was being done, as in "create the folder".
        doing: &'static str,
        /// The system's reason.
        cause: io::Error,
    },
    /// The folder already holds a run.
    HoldsARun {
        /// The file or folder by which it was recognised.
        found: String,
    },
    /// Another process is writing into the folder.
    InUse {
        /// What that process left in the lock file about itself.
        owner: String,
    },
    /// The folder holds no run that could go on.
    NoRun,
    /// The file is not a checkpoint at all.
    NotACheckpoint,
    /// The file ends early, or goes on after its end.
    WrongLength {
        /// Length that its header promises, bytes.
        expected: u64,
        /// Length found, bytes.
        found: u64,
    },
    /// The content was damaged after it was written.
    WrongChecksum,
    /// Written in a container layout that this program does not know.
    UnknownFormat {
        /// Version in the file.
        found: u32,
        /// Version this program reads.
        known: u32,
    },
    /// Written with another layout of the state.
    OtherState {
        /// Layout version in the file.
        found: u32,
        /// Layout version this program reads.
        known: u32,
    },
    /// The state could not be packed or unpacked.
    State(String),
    /// No checkpoint of the folder can be read; each with its reason.
    NoGoodCheckpoint(Vec<OutputError>),
    /// A line of a text file is not what it should be.
    BadLine {
        /// Line number, from 1.
        line: usize,
        /// What was found and what would be right.
        reason: String,
    },
    /// The values handed over cannot be written.
    BadData(String),
}

impl OutputError {
    pub(crate) fn new(path: &Path, problem: Problem) -> Self {
        OutputError {
            path: path.to_path_buf(),
            problem,
        }
    }

    /// For `map_err`: the system's refusal while doing something to `path`.
    pub(crate) fn system(
        path: &Path,
        doing: &'static str,
    ) -> impl FnOnce(io::Error) -> OutputError {
        move |cause| OutputError::new(path, Problem::System { doing, cause })
    }
}

impl fmt::Display for OutputError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let path = self.path.display();
        match &self.problem {
            Problem::System { doing, cause } => write!(f, "{path}: could not {doing}: {cause}"),
            Problem::HoldsARun { found } => write!(
                f,
                "{path}: already holds a run (found {found}). Give this run another name \
                 or another folder with --out, or replace the old run with --force"
            ),
            Problem::InUse { owner } => write!(
                f,
                "{path}: another run is writing into this folder ({owner}). \
                 Wait until it ends, or choose another folder with --out"
            ),
            Problem::NoRun => write!(
                f,
                "{path}: holds no run to go on with (no case.toml in it); \
                 give the folder that `meniscus run` wrote"
            ),
            Problem::NotACheckpoint => write!(f, "{path}: is not a Meniscus checkpoint"),
            Problem::WrongLength { expected, found } if found < expected => write!(
                f,
                "{path}: truncated: {found} bytes where the whole file has {expected}"
            ),
            Problem::WrongLength { expected, found } => write!(
                f,
                "{path}: {found} bytes where the checkpoint ends after {expected}: \
                 something was written behind it"
            ),
            Problem::WrongChecksum => {
                write!(f, "{path}: damaged: its checksum does not fit its content")
            }
            Problem::UnknownFormat { found, known } => write!(
                f,
                "{path}: checkpoint format {found}, and this program reads format {known}: \
                 use the program version that wrote it"
            ),
            Problem::OtherState { found, known } => write!(
                f,
                "{path}: holds state layout {found}, and this program reads layout {known}: \
                 use the program version that wrote it"
            ),
            Problem::State(reason) => write!(f, "{path}: state: {reason}"),
            Problem::NoGoodCheckpoint(tried) if tried.is_empty() => {
                write!(f, "{path}: holds no checkpoint")
            }
            Problem::NoGoodCheckpoint(tried) => {
                write!(f, "{path}: no checkpoint can be read")?;
                tried.iter().try_for_each(|error| write!(f, "\n  {error}"))
            }
            Problem::BadLine { line, reason } => write!(f, "{path}:{line}: {reason}"),
            Problem::BadData(reason) => write!(f, "{path}: cannot be written: {reason}"),
        }
    }
}

impl Error for OutputError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match &self.problem {
            Problem::System { cause, .. } => Some(cause),
            _ => None,
        }
    }
}
