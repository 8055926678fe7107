//! Time series as CSV.
//!
//! The first line names the columns with their units, `time [s],energy [J/m]`;
//! each further line is one sample. The first column is the time, which
//! grows from row to row. Numbers are printed with as many digits as bring
//! back the same bits.

use std::fs::{self, File, OpenOptions};
use std::io::{Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use crate::error::{OutputError, Problem};

/// A column of a series.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Column {
    /// Name, as in `kinetic energy`.
    pub name: String,
    /// Unit, as in `J/m`; empty for a plain number.
    pub unit: String,
}

impl Column {
    /// A column by name and unit.
    pub fn new(name: &str, unit: &str) -> Self {
        Column {
            name: name.to_owned(),
            unit: unit.to_owned(),
        }
    }

    pub(crate) fn parse(text: &str) -> Self {
        match text.strip_suffix(']').and_then(|t| t.rsplit_once(" [")) {
            Some((name, unit)) => Column::new(name, unit),
            None => Column::new(text, ""),
        }
    }
}

/// `name [unit]`, or the bare name of a plain number.
pub(crate) fn label(name: &str, unit: &str) -> String {
    if unit.is_empty() {
        name.to_owned()
    } else {
        format!("{name} [{unit}]")
    }
}

/// Appends samples to a series, each on disk before the call returns.
#[derive(Debug)]
pub struct SeriesWriter {
    path: PathBuf,
    file: File,
    columns: usize,
    /// Time of the last row and where the row begins, bytes.
    last: Option<(f64, u64)>,
    /// End of the last row, bytes.
    end: u64,
}

impl SeriesWriter {
    /// Starts a new series; the first column is the time in seconds.
    ///
    /// Refuses names that would break a line of CSV (a comma, a quote, a line
    /// break) and names given twice.
    pub fn create(path: &Path, columns: &[Column]) -> Result<Self, OutputError> {
        let header = header(columns).map_err(|p| OutputError::new(path, p))?;
        let mut file = File::create(path).map_err(OutputError::system(path, "create the file"))?;
        file.write_all(header.as_bytes())
            .map_err(OutputError::system(path, "write the header"))?;
        Ok(SeriesWriter {
            path: path.to_path_buf(),
            file,
            columns: columns.len(),
            last: None,
            end: header.len() as u64,
        })
    }

    /// Continues a series after a resume at `time`: rows later than that, and
    /// a row broken off by a crash, are cut away.
    ///
    /// The columns must be those in the file.
    pub fn resume(path: &Path, columns: &[Column], time: f64) -> Result<Self, OutputError> {
        let header = header(columns).map_err(|p| OutputError::new(path, p))?;
        let text = read(path)?;
        if !text.starts_with(&header) {
            return Err(OutputError::new(
                path,
                Problem::BadLine {
                    line: 1,
                    reason: format!(
                        "the columns are {:?}; the run to go on with writes {:?}",
                        text.lines().next().unwrap_or(""),
                        header.trim_end()
                    ),
                },
            ));
        }
        let mut end = header.len();
        let mut last = None;
        for row in text[end..].split_inclusive('\n') {
            let first = row.split(',').next().unwrap_or("");
            match first.trim_end().parse::<f64>() {
                Ok(t) if t <= time && row.ends_with('\n') => last = Some((t, end as u64)),
                _ => break,
            }
            end += row.len();
        }
        let end = end as u64;
        let mut file = OpenOptions::new()
            .write(true)
            .open(path)
            .map_err(OutputError::system(path, "open the file"))?;
        file.set_len(end)
            .and_then(|()| file.seek(SeekFrom::Start(end)))
            .map_err(OutputError::system(path, "cut the file back"))?;
        Ok(SeriesWriter {
            path: path.to_path_buf(),
            file,
            columns: columns.len(),
            last,
            end,
        })
    }

    /// Appends one sample. A sample at the time of the last one takes its
    /// place; an earlier one is refused.
    pub fn append(&mut self, sample: &[f64]) -> Result<(), OutputError> {
        let refuse = |reason| Err(OutputError::new(&self.path, Problem::BadData(reason)));
        if sample.len() != self.columns {
            return refuse(format!(
                "a sample of {} values for {} columns",
                sample.len(),
                self.columns
            ));
        }
        let time = sample[0];
        if !time.is_finite() {
            return refuse(format!("a sample at time {time}"));
        }
        let begin = match self.last {
            Some((last, _)) if time < last => {
                return refuse(format!("a sample at {time} s after one at {last} s"));
            }
            Some((last, begin)) if time == last => begin,
            _ => self.end,
        };
        let row = row(sample);
        if begin < self.end {
            self.file
                .set_len(begin)
                .and_then(|()| self.file.seek(SeekFrom::Start(begin)))
                .map_err(OutputError::system(&self.path, "replace the last row"))?;
        }
        // One write per row: a reader never sees half of one.
        self.file
            .write_all(row.as_bytes())
            .map_err(OutputError::system(&self.path, "append a row"))?;
        self.last = Some((time, begin));
        self.end = begin + row.len() as u64;
        Ok(())
    }
}

fn header(columns: &[Column]) -> Result<String, Problem> {
    let labels: Vec<String> = columns.iter().map(|c| label(&c.name, &c.unit)).collect();
    if columns.is_empty() {
        return Err(Problem::BadData("a series without columns".to_owned()));
    }
    for (i, text) in labels.iter().enumerate() {
        let breaks = |c: char| c == ',' || c == '"' || c.is_control();
        if columns[i].name.is_empty() || text.contains(breaks) {
            return Err(Problem::BadData(format!(
                "column {text:?}; a name is not empty and holds no comma, quote or line break"
            )));
        }
        if labels[..i].contains(text) {
            return Err(Problem::BadData(format!("two columns are named {text:?}")));
        }
    }
    Ok(labels.join(",") + "\n")
}

fn row(sample: &[f64]) -> String {
    let numbers: Vec<String> = sample.iter().map(|&x| number(x)).collect();
    numbers.join(",") + "\n"
}

/// The shortest text that reads back to the same bits.
pub(crate) fn number(x: f64) -> String {
    if x == 0.0 || (1e-4..1e7).contains(&x.abs()) {
        format!("{x}")
    } else {
        format!("{x:e}")
    }
}

fn read(path: &Path) -> Result<String, OutputError> {
    fs::read_to_string(path).map_err(OutputError::system(path, "read the file"))
}

/// A series read back.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// Names and units, the time first.
    pub columns: Vec<Column>,
    /// The samples of each column.
    pub values: Vec<Vec<f64>>,
}

impl Series {
    /// Reads a series; the error of a bad row names its line.
    ///
    /// A last row without its line end, as a crash may leave it, is passed over.
    pub fn read(path: &Path) -> Result<Self, OutputError> {
        let text = read(path)?;
        let bad = |line, reason| OutputError::new(path, Problem::BadLine { line, reason });
        let mut lines = text.split_inclusive('\n').filter(|l| l.ends_with('\n'));
        let first = lines
            .next()
            .ok_or_else(|| bad(1, "no header; the first line names the columns".to_owned()))?;
        let columns: Vec<Column> = first.trim_end().split(',').map(Column::parse).collect();
        let mut values = vec![Vec::new(); columns.len()];
        for (i, row) in lines.enumerate() {
            let line = i + 2;
            let cells: Vec<&str> = row.trim_end().split(',').collect();
            if cells.len() != columns.len() {
                let reason = format!("{} values for {} columns", cells.len(), columns.len());
                return Err(bad(line, reason));
            }
            for (column, cell) in values.iter_mut().zip(cells) {
                let value = cell
                    .trim()
                    .parse()
                    .map_err(|_| bad(line, format!("{cell:?} is not a number")))?;
                column.push(value);
            }
        }
        Ok(Series { columns, values })
    }

    /// The samples of the column of that name (without unit).
    pub fn column(&self, name: &str) -> Option<&[f64]> {
        let i = self.columns.iter().position(|c| c.name == name)?;
        Some(&self.values[i])
    }

    /// Number of samples.
    pub fn len(&self) -> usize {
        self.values.first().map_or(0, Vec::len)
    }

    /// Whether there is no sample.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}
