//! A run's folder holds one run, written by one process, and replacing it
//! never costs the user a file of theirs.

mod common;

use std::fs;

use common::empty_folder;
use meniscus_output::{Checkpoints, Column, Frame, FrameWriter, Problem, RunFolder, SeriesWriter};

#[test]
fn a_new_run_has_its_parts() {
    let root = empty_folder("run_new").join("out/rod");
    let run = RunFolder::create(&root, "spacing = \"1 um\"\n", false).unwrap();
    run.write_run(&serde_json::json!({"version": "0.1.0", "seed": 1}))
        .unwrap();
    run.write_figure("axes.svg", b"<svg/>").unwrap();
    run.write_report("<!doctype html>").unwrap();
    assert_eq!(run.read_case().unwrap(), "spacing = \"1 um\"\n");
    let text = fs::read_to_string(root.join("run.json")).unwrap();
    let json: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(json["seed"], 1);
    assert_eq!(fs::read(root.join("figures/axes.svg")).unwrap(), b"<svg/>");
    assert!(root.join("report.html").is_file());
    assert!(root.join("frames").is_dir() && root.join("checkpoints").is_dir());
}

#[test]
fn a_folder_that_holds_a_run_is_refused_with_the_ways_out() {
    let root = empty_folder("run_refused");
    drop(RunFolder::create(&root, "first", false).unwrap());
    let error = RunFolder::create(&root, "second", false).unwrap_err();
    assert!(matches!(error.problem, Problem::HoldsARun { .. }));
    let text = error.to_string();
    for way in ["--force", "--out", "another name"] {
        assert!(text.contains(way), "{text}");
    }
    let case = fs::read_to_string(root.join("case.toml")).unwrap();
    assert_eq!(case, "first");
}

#[test]
fn a_folder_with_other_files_only_is_no_run() {
    let root = empty_folder("run_foreign");
    fs::write(root.join("notes.txt"), "mine").unwrap();
    RunFolder::create(&root, "case", false).unwrap();
}

#[test]
fn force_removes_what_meniscus_wrote_and_nothing_else() {
    let root = empty_folder("run_force");
    let run = RunFolder::create(&root, "first", false).unwrap();
    run.write_run(&1).unwrap();
    run.write_report("html").unwrap();
    run.write_figure("axes.svg", b"svg").unwrap();
    SeriesWriter::create(&run.series_file(), &[Column::new("time", "s")]).unwrap();
    let empty = Frame {
        time: 0.0,
        step: 0,
        dimension: 2,
        positions: vec![],
        fields: vec![],
    };
    let mut frames = FrameWriter::create(&run.frames_folder()).unwrap();
    frames.write(&empty).unwrap();
    let checkpoints = Checkpoints::open(&run.checkpoints_folder(), 1).unwrap();
    checkpoints.save(1, 0.0, &1_u8).unwrap();
    drop(run);
    let ours = [
        "run.json",
        "series.csv",
        "report.html",
        "figures/axes.svg",
        "frames/frames.pvd",
        "frames/frame-000000.vtu",
        "checkpoints/step-000000000001.checkpoint",
    ];
    let theirs = [
        "notes.txt",
        "figures/mine.svg",
        "frames/frame-first.vtu",
        "frames/view.pvsm",
        "checkpoints/step-one.checkpoint",
    ];
    for name in ours {
        assert!(root.join(name).exists(), "{name}");
    }
    for name in theirs {
        fs::write(root.join(name), "mine").unwrap();
    }

    let run = RunFolder::create(&root, "second", true).unwrap();
    assert_eq!(run.read_case().unwrap(), "second");
    for name in ours {
        assert!(!root.join(name).exists(), "{name}");
    }
    for name in theirs {
        assert_eq!(fs::read_to_string(root.join(name)).unwrap(), "mine");
    }
}

#[test]
fn two_writers_cannot_have_the_same_folder() {
    let root = empty_folder("run_lock");
    let first = RunFolder::create(&root, "case", false).unwrap();
    for force in [false, true] {
        let error = RunFolder::create(&root, "other", force).unwrap_err();
        assert!(matches!(error.problem, Problem::InUse { .. }), "{error}");
        assert!(error.to_string().contains(&std::process::id().to_string()));
    }
    assert!(RunFolder::open(&root).is_err());
    drop(first);
    RunFolder::open(&root).unwrap();
}

#[test]
fn a_folder_without_a_run_cannot_be_gone_on_with() {
    let root = empty_folder("run_none");
    let error = RunFolder::open(&root).unwrap_err();
    assert!(matches!(error.problem, Problem::NoRun));
    assert!(!root.join(".meniscus.lock").exists());
}

#[test]
fn a_figure_cannot_leave_its_folder() {
    let root = empty_folder("run_figure");
    let run = RunFolder::create(&root, "case", false).unwrap();
    for name in ["../x.svg", "/x.svg", "", "..", "a/b.svg"] {
        assert!(run.write_figure(name, b"").is_err(), "{name:?}");
    }
}

#[test]
fn a_file_where_the_folder_should_be_is_told() {
    let root = empty_folder("run_on_file").join("rod");
    fs::write(&root, "").unwrap();
    let error = RunFolder::create(&root, "case", true).unwrap_err();
    assert!(matches!(error.problem, Problem::System { .. }), "{error}");
    assert_eq!(error.path, root);
}
