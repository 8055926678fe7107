//! `meniscus new`: a case file to start from.

use std::io::{ErrorKind, Write};
use std::path::Path;
use std::process::ExitCode;

use crate::failure::Failure;
use crate::terminal::Voice;

/// Writes NAME.toml, where nothing of that name stands yet.
pub fn write(name: &Path, voice: Voice) -> Result<ExitCode, Failure> {
    let Some(file) = name.file_name().map(|file| file.to_string_lossy()) else {
        return Err(Failure::new(format!(
            "{:?} is not the name of a case; try: meniscus new drop",
            name.display().to_string()
        )));
    };
    let stem = file.strip_suffix(".toml").unwrap_or(&file);
    let path = name.with_file_name(format!("{stem}.toml"));
    let shown = path.display();
    std::fs::File::create_new(&path)
        .and_then(|mut file| file.write_all(meniscus_case::template(stem).as_bytes()))
        .map_err(|error| {
            Failure::new(match error.kind() {
                ErrorKind::AlreadyExists => {
                    format!("{shown} exists already, and stays as it is; choose another name")
                }
                _ => format!("cannot write {shown}: {error}"),
            })
        })?;
    voice.say(&format!("wrote {shown}; try: meniscus check {shown}"));
    Ok(ExitCode::SUCCESS)
}
