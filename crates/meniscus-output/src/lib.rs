//! The files of a run.
//!
//! A run lives in one folder, [`RunFolder`], that two processes cannot write
//! at once and that never mixes two runs. In it stand the time series
//! ([`SeriesWriter`], CSV), the frames that ParaView opens ([`FrameWriter`],
//! VTU files and their `.pvd` collection) and the [`Checkpoints`] from which
//! the run goes on. Everything here works on plain numbers in SI units and
//! knows nothing of the simulation.
//!
//! A resumed run continues the same files: series and frames are cut back to
//! the checkpoint's time first. A run should therefore write the row and the
//! frame of an instant before the checkpoint of that instant.
//!
//! Whole files are written under another name, synced and renamed
//! ([`replace_file`]), so that a reader, or a run after a crash, finds either
//! the old file or the new one and never half of one.

mod checkpoint;
mod collection;
mod error;
mod frame;
mod replace;
mod run_folder;
mod series;
mod vtu;
mod vtu_read;

pub use checkpoint::{Checkpoint, Checkpoints, Restored};
pub use collection::{FrameReader, FrameWriter};
pub use error::{OutputError, Problem};
pub use frame::{Field, Frame};
pub use replace::replace_file;
pub use run_folder::RunFolder;
pub use series::{Column, Series, SeriesWriter};
