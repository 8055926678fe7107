//! A checkpoint is either whole or refused with its reason, and a failed
//! write never harms an older one.

mod common;

use std::fs;
use std::path::Path;

use common::empty_folder;
use meniscus_output::{Checkpoints, Problem};
use serde::{Deserialize, Serialize};

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct State {
    positions: Vec<[f64; 3]>,
    label: String,
    seed: Option<u64>,
}

fn state(count: u32) -> State {
    State {
        positions: (0..count)
            .map(|i| [f64::from(i).sqrt(), -0.0, 1.0 / f64::from(i + 1)])
            .collect(),
        label: "rod".to_owned(),
        seed: Some(7),
    }
}

const LAYOUT: u32 = 3;

fn open(folder: &Path) -> Checkpoints {
    Checkpoints::open(folder, LAYOUT).unwrap()
}

fn files(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(folder)
        .unwrap()
        .map(|e| e.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

#[test]
fn a_state_comes_back_as_it_was() {
    let folder = empty_folder("checkpoint_round");
    let checkpoints = open(&folder);
    let path = checkpoints.save(41, 0.1 + 0.2, &state(100)).unwrap();
    let read = checkpoints.load::<State>(&path).unwrap();
    assert_eq!(read.step, 41);
    assert_eq!(read.time.to_bits(), (0.1_f64 + 0.2).to_bits());
    assert_eq!(read.state, state(100));
    assert!(read.state.positions[0][1].is_sign_negative());
}

#[test]
fn a_file_cut_at_any_byte_is_refused() {
    let folder = empty_folder("checkpoint_truncated");
    let checkpoints = open(&folder);
    let path = checkpoints.save(1, 0.1, &state(3)).unwrap();
    let whole = fs::read(&path).unwrap();
    for length in 0..whole.len() {
        fs::write(&path, &whole[..length]).unwrap();
        let error = checkpoints.load::<State>(&path).unwrap_err();
        let told = match error.problem {
            Problem::NotACheckpoint => length == 0,
            Problem::WrongLength { expected, found } => found < expected,
            _ => false,
        };
        assert!(told, "{length} bytes: {error}");
    }
    fs::write(&path, [whole, vec![0]].concat()).unwrap();
    let error = checkpoints.load::<State>(&path).unwrap_err();
    assert!(matches!(error.problem, Problem::WrongLength { .. }));
}

#[test]
fn a_flipped_bit_anywhere_is_noticed() {
    let folder = empty_folder("checkpoint_flipped");
    let checkpoints = open(&folder);
    let path = checkpoints.save(1, 0.1, &state(3)).unwrap();
    let whole = fs::read(&path).unwrap();
    for bit in 0..whole.len() * 8 {
        let mut damaged = whole.clone();
        damaged[bit / 8] ^= 1 << (bit % 8);
        fs::write(&path, damaged).unwrap();
        assert!(checkpoints.load::<State>(&path).is_err(), "bit {bit}");
    }
}

#[test]
fn a_foreign_file_a_newer_format_and_another_layout_are_told_apart() {
    let folder = empty_folder("checkpoint_kinds");
    let checkpoints = open(&folder);
    let path = checkpoints.save(1, 0.1, &state(3)).unwrap();

    let other = Checkpoints::open(&folder, LAYOUT + 1).unwrap();
    let error = other.load::<State>(&path).unwrap_err();
    assert!(matches!(
        error.problem,
        Problem::OtherState { found: 3, known: 4 }
    ));

    let mut newer = fs::read(&path).unwrap();
    newer[8] = 2;
    fs::write(&path, newer).unwrap();
    let error = checkpoints.load::<State>(&path).unwrap_err();
    assert!(matches!(
        error.problem,
        Problem::UnknownFormat { found: 2, known: 1 }
    ));

    fs::write(&path, "time [s],x\n").unwrap();
    let error = checkpoints.load::<State>(&path).unwrap_err();
    assert!(matches!(error.problem, Problem::NotACheckpoint));
    assert!(error.to_string().contains(path.to_str().unwrap()));
}

#[test]
fn another_type_is_an_error_and_no_panic() {
    let folder = empty_folder("checkpoint_type");
    let checkpoints = open(&folder);
    let path = checkpoints.save(1, 0.1, &state(3)).unwrap();
    let error = checkpoints.load::<Vec<String>>(&path).unwrap_err();
    assert!(matches!(error.problem, Problem::State(_)), "{error}");
}

#[test]
fn the_last_two_are_kept() {
    let folder = empty_folder("checkpoint_kept");
    let checkpoints = open(&folder);
    for step in [8, 9, 10, 1000] {
        checkpoints.save(step, 0.0, &state(2)).unwrap();
    }
    assert_eq!(
        files(&folder),
        [
            "step-000000000010.checkpoint",
            "step-000000001000.checkpoint"
        ]
    );
}

#[test]
fn a_damaged_latest_falls_back_to_the_one_before_and_is_told() {
    let folder = empty_folder("checkpoint_fallback");
    let checkpoints = open(&folder);
    checkpoints.save(10, 0.1, &state(2)).unwrap();
    let latest = checkpoints.save(20, 0.2, &state(2)).unwrap();
    let bytes = fs::read(&latest).unwrap();
    fs::write(&latest, &bytes[..bytes.len() / 2]).unwrap();

    let restored = checkpoints.latest_good::<State>().unwrap();
    assert_eq!(restored.checkpoint.step, 10);
    assert_eq!(restored.passed_over.len(), 1);
    assert_eq!(restored.passed_over[0].path, latest);

    // The run goes on from step 10: the damaged file of step 20 must not
    // push the good ones out.
    checkpoints.save(15, 0.15, &state(2)).unwrap();
    assert_eq!(
        files(&folder),
        [
            "step-000000000010.checkpoint",
            "step-000000000015.checkpoint"
        ]
    );
}

#[test]
fn no_good_checkpoint_tells_every_reason() {
    let folder = empty_folder("checkpoint_none");
    let checkpoints = open(&folder);
    let error = checkpoints.latest_good::<State>().unwrap_err();
    assert!(error.to_string().contains("holds no checkpoint"), "{error}");

    let path = checkpoints.save(10, 0.1, &state(2)).unwrap();
    fs::write(&path, "no").unwrap();
    let error = checkpoints.latest_good::<State>().unwrap_err();
    assert!(error.to_string().contains("is not a Meniscus checkpoint"));
}

#[test]
fn a_crash_between_write_and_rename_does_no_harm() {
    let folder = empty_folder("checkpoint_crash");
    let checkpoints = open(&folder);
    let path = checkpoints.save(10, 0.1, &state(2)).unwrap();
    let bytes = fs::read(&path).unwrap();
    let partial = folder.join("step-000000000020.checkpoint.partial");
    fs::write(&partial, &bytes[..30]).unwrap();

    let restored = checkpoints.latest_good::<State>().unwrap();
    assert_eq!(restored.checkpoint.step, 10);
    assert!(restored.passed_over.is_empty());
    checkpoints.save(30, 0.3, &state(2)).unwrap();
    assert!(!partial.exists());
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_told_with_path_and_cause_and_older_checkpoints_stay() {
    let folder = empty_folder("checkpoint_full_disk");
    let checkpoints = open(&folder);
    let first = checkpoints.save(10, 0.1, &state(2)).unwrap();
    let second = checkpoints.save(20, 0.2, &state(2)).unwrap();
    let before = (fs::read(&first).unwrap(), fs::read(&second).unwrap());
    // The file to be written is one that takes no byte.
    let partial = folder.join("step-000000000030.checkpoint.partial");
    std::os::unix::fs::symlink("/dev/full", &partial).unwrap();

    let error = checkpoints.save(30, 0.3, &state(2)).unwrap_err();
    let Problem::System { cause, .. } = &error.problem else {
        panic!("{error}")
    };
    assert_eq!(cause.kind(), std::io::ErrorKind::StorageFull);
    assert!(error.path.ends_with("step-000000000030.checkpoint"));
    assert!(std::error::Error::source(&error).is_some());
    let after = (fs::read(&first).unwrap(), fs::read(&second).unwrap());
    assert_eq!(before, after);
    assert_eq!(files(&folder).len(), 2);
}
