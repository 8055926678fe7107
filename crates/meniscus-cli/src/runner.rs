//! `run` and `resume`.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use meniscus::rates::{Dimension, Space};
use meniscus::{Simulation, Snapshot};
use meniscus_case::Case;
use meniscus_output::{Checkpoints, FrameWriter, RunFolder, SeriesWriter};

use crate::calibrate;
use crate::conclude::{file_of, show, write_report};
use crate::due::reached;
use crate::failure::Failure;
use crate::interrupt;
use crate::march::{March, STATE_VERSION};
use crate::progress::seconds;
use crate::record::{RunRecord, Status};
use crate::sample::Sampler;
use crate::terminal::{Voice, complain};

/// Runs a case file.
pub fn run(
    path: &Path,
    out: Option<&Path>,
    force: bool,
    voice: Voice,
) -> Result<ExitCode, Failure> {
    let case = calibrate::ready(path, &|line| voice.say(line))?;
    voice.warn_of(&case);
    let root = out.map_or_else(|| Path::new("out").join(&case.name), Path::to_path_buf);
    let folder = RunFolder::create(&root, case.to_toml(), force)?;
    voice.say(&format!(
        "{}: {} particles in {}D, {} of flow; results go to {}",
        case.name,
        case.particle_count(),
        case.dimension,
        seconds(case.end_time),
        folder.root().display()
    ));
    let record = start(&case, &folder, voice)?;
    finish(&case, &folder, record, voice)
}

/// Goes on with a run.
pub fn resume(root: &Path, voice: Voice) -> Result<ExitCode, Failure> {
    let folder = RunFolder::open(root)?;
    let case = case_of(&folder)?;
    let earlier = RunRecord::read(&folder).ok();
    if let Some(record) = &earlier
        && record.status == Status::Complete
        && reached(record.time, case.end_time)
    {
        voice.say(&format!(
            "{}: the run is complete, up to t = {}; nothing to do (its report anew: meniscus report {})",
            case.name,
            seconds(record.time),
            root.display()
        ));
        return Ok(ExitCode::SUCCESS);
    }
    let wall_time = earlier.map_or(0.0, |record| record.wall_time);
    let record = go_on(&case, &folder, wall_time, voice)?;
    finish(&case, &folder, record, voice)
}

/// The case that stands in a run's folder, under the name it was run by.
pub fn case_of(folder: &RunFolder) -> Result<Case, Failure> {
    let shown = folder.case_file().display().to_string();
    let mut case = Case::from_str(&shown, &folder.read_case()?)?;
    case.name = RunRecord::read(folder).map_or_else(|_| name_of(folder.root()), |r| r.case);
    Ok(case)
}

/// The name of a folder.
pub fn name_of(root: &Path) -> String {
    let full = std::path::absolute(root).unwrap_or_else(|_| PathBuf::from(root));
    full.file_name()
        .map_or_else(|| "run".into(), |name| name.to_string_lossy().into_owned())
}

/// Reports on a march that has come to its end or was interrupted.
fn finish(
    case: &Case,
    folder: &RunFolder,
    mut record: RunRecord,
    voice: Voice,
) -> Result<ExitCode, Failure> {
    if record.status == Status::Interrupted {
        voice.say(&format!(
            "stopped at step {}, t = {}; to go on: meniscus resume {}",
            record.steps,
            seconds(record.time),
            folder.root().display()
        ));
        match write_report(case, folder, &mut record) {
            Ok(_) => voice.say(&format!("report so far: {}", file_of(folder))),
            Err(failure) => complain(&format!(
                "no report could be written: {}",
                failure.message()
            )),
        }
        return Ok(ExitCode::from(interrupt::EXIT_CODE));
    }
    let measured = write_report(case, folder, &mut record)?;
    show(folder, &record, &measured, voice);
    Ok(ExitCode::SUCCESS)
}

/// Marches a case from its start into a fresh folder.
pub fn start(case: &Case, folder: &RunFolder, voice: Voice) -> Result<RunRecord, Failure> {
    match case.dimension {
        2 => start_in::<2>(case, folder, voice),
        _ => start_in::<3>(case, folder, voice),
    }
}

fn start_in<const D: usize>(
    case: &Case,
    folder: &RunFolder,
    voice: Voice,
) -> Result<RunRecord, Failure>
where
    Space: Dimension<D>,
{
    let simulation = Simulation::<D>::new(case.setup()).map_err(|e| Failure::new(e.to_string()))?;
    let sampler = Sampler::<D>::new(case);
    let march = March {
        series: SeriesWriter::create(&folder.series_file(), &sampler.columns())?,
        frames: FrameWriter::create(&folder.frames_folder())?,
        checkpoints: Checkpoints::open(&folder.checkpoints_folder(), STATE_VERSION)?,
        last_checkpoint: None,
        case,
        folder,
        voice,
        sampler,
        simulation,
        earlier: 0.0,
    };
    march.go()
}

/// Whether a folder has a whole checkpoint of this program.
pub fn can_go_on(folder: &RunFolder) -> bool {
    Checkpoints::open(&folder.checkpoints_folder(), STATE_VERSION)
        .is_ok_and(|checkpoints| checkpoints.latest_good::<Snapshot>().is_ok())
}

/// Goes on from a folder's last checkpoint, after so much wall-clock time (s).
pub fn go_on(
    case: &Case,
    folder: &RunFolder,
    wall_time: f64,
    voice: Voice,
) -> Result<RunRecord, Failure> {
    match case.dimension {
        2 => resume_in::<2>(case, folder, wall_time, voice),
        _ => resume_in::<3>(case, folder, wall_time, voice),
    }
}

fn resume_in<const D: usize>(
    case: &Case,
    folder: &RunFolder,
    earlier: f64,
    voice: Voice,
) -> Result<RunRecord, Failure>
where
    Space: Dimension<D>,
{
    let checkpoints = Checkpoints::open(&folder.checkpoints_folder(), STATE_VERSION)?;
    let restored = checkpoints.latest_good::<Snapshot>()?;
    for error in &restored.passed_over {
        complain(&format!(
            "warning: a checkpoint cannot be used, an older one is: {error}"
        ));
    }
    let snapshot = restored.checkpoint.state;
    let simulation = Simulation::<D>::restore(case.setup(), &snapshot)
        .map_err(|e| Failure::new(format!("{}: {e}", restored.path.display())))?;
    let sampler = Sampler::<D>::new(case);
    voice.say(&format!(
        "{}: going on from step {}, t = {} of {} ({})",
        case.name,
        snapshot.steps,
        seconds(snapshot.time),
        seconds(case.end_time),
        restored.path.display()
    ));
    let march = March {
        series: SeriesWriter::resume(&folder.series_file(), &sampler.columns(), snapshot.time)?,
        frames: FrameWriter::resume(&folder.frames_folder(), snapshot.time)?,
        checkpoints,
        last_checkpoint: Some(restored.path),
        case,
        folder,
        voice,
        sampler,
        simulation,
        earlier,
    };
    march.go()
}
