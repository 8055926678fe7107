//! The frames of a run and the `.pvd` file that lists them with their times.

use std::fs;
use std::path::{Path, PathBuf};

use crate::error::{OutputError, Problem};
use crate::frame::Frame;
use crate::replace::replace_file;
use crate::{vtu, vtu_read};

/// The collection that ParaView opens.
const COLLECTION: &str = "frames.pvd";

/// Writes the frames of a run into one folder.
///
/// `frames.pvd` lists every frame with its time and is whole after each
/// [`write`](FrameWriter::write), so that ParaView may open it during the run.
#[derive(Debug)]
pub struct FrameWriter {
    folder: PathBuf,
    /// Times of the frames written, growing; frame n is file n.
    times: Vec<f64>,
}

impl FrameWriter {
    /// Starts an empty collection, creating the folder where it is missing.
    pub fn create(folder: &Path) -> Result<Self, OutputError> {
        fs::create_dir_all(folder).map_err(OutputError::system(folder, "create the folder"))?;
        let writer = FrameWriter {
            folder: folder.to_path_buf(),
            times: Vec::new(),
        };
        writer.write_collection()?;
        Ok(writer)
    }

    /// Continues the collection after a resume at `time`, s: later frames are
    /// dropped from it and their files removed.
    pub fn resume(folder: &Path, time: f64) -> Result<Self, OutputError> {
        let mut times = read_collection(folder)?;
        times.retain(|&t| t <= time);
        let writer = FrameWriter {
            folder: folder.to_path_buf(),
            times,
        };
        writer.write_collection()?;
        writer.remove_unlisted()?;
        Ok(writer)
    }

    /// Writes a frame and adds it to the collection; gives its path.
    ///
    /// A frame at the time of the last one takes its place; an earlier one,
    /// or one whose fields do not fit its particles, is refused.
    pub fn write(&mut self, frame: &Frame) -> Result<PathBuf, OutputError> {
        let mut index = self.times.len();
        let mut fault = frame.fault();
        if let Some(&last) = self.times.last() {
            if frame.time == last {
                index -= 1;
            } else if frame.time < last {
                fault = Some(format!("a frame at {} s after one at {last} s", frame.time));
            }
        }
        let path = self.folder.join(frame_name(index));
        if let Some(reason) = fault {
            return Err(OutputError::new(&path, Problem::BadData(reason)));
        }
        replace_file(&path, |out| vtu::write(out, frame))?;
        self.times.truncate(index);
        self.times.push(frame.time);
        self.write_collection()?;
        Ok(path)
    }

    /// Times of the frames in the collection, s.
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// The file that ParaView opens.
    pub fn collection(&self) -> PathBuf {
        self.folder.join(COLLECTION)
    }

    fn write_collection(&self) -> Result<(), OutputError> {
        replace_file(&self.collection(), |out| {
            writeln!(out, r#"<?xml version="1.0"?>"#)?;
            writeln!(
                out,
                r#"<VTKFile type="Collection" version="0.1" byte_order="LittleEndian">"#
            )?;
            writeln!(out, "<Collection>")?;
            for (index, time) in self.times.iter().enumerate() {
                let name = frame_name(index);
                writeln!(
                    out,
                    r#"<DataSet timestep="{time:e}" part="0" file="{name}"/>"#
                )?;
            }
            writeln!(out, "</Collection>\n</VTKFile>")
        })
    }

    /// Removes frames that a run later than the checkpoint has left.
    fn remove_unlisted(&self) -> Result<(), OutputError> {
        let doing = "remove a frame later than the checkpoint";
        let mut index = self.times.len();
        loop {
            let path = self.folder.join(frame_name(index));
            match fs::remove_file(&path) {
                Ok(()) => index += 1,
                Err(cause) if cause.kind() == std::io::ErrorKind::NotFound => return Ok(()),
                Err(cause) => {
                    return Err(OutputError::new(&path, Problem::System { doing, cause }));
                }
            }
        }
    }
}

/// Reads back the frames of a run.
#[derive(Debug)]
pub struct FrameReader {
    folder: PathBuf,
    times: Vec<f64>,
}

impl FrameReader {
    /// The frames that the collection in `folder` lists.
    pub fn open(folder: &Path) -> Result<Self, OutputError> {
        Ok(FrameReader {
            folder: folder.to_path_buf(),
            times: read_collection(folder)?,
        })
    }

    /// Times of the frames, s, growing.
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// Reads frame `index`, from 0.
    pub fn read(&self, index: usize) -> Result<Frame, OutputError> {
        let path = self.folder.join(frame_name(index));
        let text =
            fs::read_to_string(&path).map_err(OutputError::system(&path, "read the frame"))?;
        vtu_read::read(&text).map_err(|reason| OutputError::new(&path, Problem::BadData(reason)))
    }
}

/// Times of the frames of the collection in `folder`, s.
fn read_collection(folder: &Path) -> Result<Vec<f64>, OutputError> {
    let path = folder.join(COLLECTION);
    let text =
        fs::read_to_string(&path).map_err(OutputError::system(&path, "read the collection"))?;
    parse_collection(&text).map_err(|p| OutputError::new(&path, p))
}

fn frame_name(index: usize) -> String {
    format!("frame-{index:06}.vtu")
}

/// Whether Meniscus gives this name to a file of the folder of frames.
pub(crate) fn is_ours(name: &str) -> bool {
    let index = name
        .strip_prefix("frame-")
        .and_then(|rest| rest.strip_suffix(".vtu"));
    name == COLLECTION
        || index.is_some_and(|i| i.len() >= 6 && i.bytes().all(|b| b.is_ascii_digit()))
}

/// The times in a collection that Meniscus wrote.
fn parse_collection(text: &str) -> Result<Vec<f64>, Problem> {
    let mut times = Vec::new();
    for (i, line) in text.lines().enumerate() {
        let Some(rest) = line.strip_prefix("<DataSet timestep=\"") else {
            continue;
        };
        let time = rest.split('"').next().and_then(|t| t.parse().ok());
        let expected = format!("file=\"{}\"", frame_name(times.len()));
        match time {
            Some(time) if line.contains(&expected) => times.push(time),
            _ => {
                return Err(Problem::BadLine {
                    line: i + 1,
                    reason: format!("expected a time and {expected}, found {line:?}"),
                });
            }
        }
    }
    if text.trim_end().ends_with("</VTKFile>") {
        Ok(times)
    } else {
        Err(Problem::BadLine {
            line: text.lines().count(),
            reason: "the collection ends early; </VTKFile> closes a whole one".to_owned(),
        })
    }
}
