//! Replacing a file whole or not at all.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

use crate::error::OutputError;

/// Ending of a file that is still being written.
pub(crate) const PARTIAL: &str = ".partial";

/// The name under which `path` is written before it is renamed.
fn partial_name(path: &Path) -> PathBuf {
    let mut name = path.file_name().map_or_else(OsString::new, OsString::from);
    name.push(PARTIAL);
    path.with_file_name(name)
}

/// Writes the file at `path` through `content`, replacing what stood there
/// only once all of it has reached the disk.
///
/// The bytes go to a file beside it (`.partial` added to the name), which is
/// synced and renamed; then the folder is synced. After an error the old
/// file stands as it was and the partial one is removed.
pub fn replace_file(
    path: &Path,
    content: impl FnOnce(&mut dyn Write) -> std::io::Result<()>,
) -> Result<(), OutputError> {
    let partial = partial_name(path);
    let written = write_synced(&partial, content)
        .map_err(OutputError::system(path, "write the file"))
        .and_then(|()| {
            fs::rename(&partial, path).map_err(OutputError::system(path, "put the file in place"))
        });
    if written.is_err() {
        // The first error is the one to tell; a partial file left behind is harmless.
        let _ = fs::remove_file(&partial);
        return written;
    }
    sync_folder_of(path)
}

fn write_synced(
    path: &Path,
    content: impl FnOnce(&mut dyn Write) -> std::io::Result<()>,
) -> std::io::Result<()> {
    let mut writer = BufWriter::with_capacity(1 << 16, File::create(path)?);
    content(&mut writer)?;
    writer.flush()?;
    writer.get_ref().sync_all()
}

/// Makes a rename in the folder of `path` last through a power failure.
#[cfg(unix)]
fn sync_folder_of(path: &Path) -> Result<(), OutputError> {
    let folder = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    File::open(folder)
        .and_then(|folder| folder.sync_all())
        .map_err(OutputError::system(folder, "sync the folder"))
}

/// Other systems sync a rename by themselves and refuse to open a folder.
#[cfg(not(unix))]
fn sync_folder_of(_path: &Path) -> Result<(), OutputError> {
    Ok(())
}
