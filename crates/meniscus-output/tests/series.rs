//! Series come back with the same bits, and a resume leaves no row twice.

mod common;

use std::fs;
use std::path::PathBuf;

use common::empty_folder;
use meniscus_output::{Column, Problem, Series, SeriesWriter};

fn columns() -> Vec<Column> {
    vec![
        Column::new("time", "s"),
        Column::new("kinetic energy", "J/m"),
        Column::new("surface particles", ""),
    ]
}

fn file(name: &str) -> PathBuf {
    empty_folder(name).join("series.csv")
}

#[test]
fn every_number_comes_back_with_the_same_bits() {
    let path = file("series_bits");
    let mut writer = SeriesWriter::create(&path, &columns()).unwrap();
    let hard = [
        0.1,
        -0.0,
        1.0 / 3.0,
        5e-324,
        f64::MIN_POSITIVE,
        f64::MAX,
        123_456_789.123_456_79,
        9.999_999_999_999_999e-5,
        f64::INFINITY,
        f64::NAN,
    ];
    for (i, x) in hard.iter().enumerate() {
        writer.append(&[i as f64 * 1e-7, *x, -x]).unwrap();
    }
    let series = Series::read(&path).unwrap();
    assert_eq!(series.columns, columns());
    assert_eq!(series.len(), hard.len());
    let read = series.column("kinetic energy").unwrap();
    for (a, b) in read.iter().zip(hard) {
        assert!(a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan()));
    }
}

#[test]
fn a_row_is_in_the_file_when_the_call_returns() {
    let path = file("series_flushed");
    let mut writer = SeriesWriter::create(&path, &columns()).unwrap();
    for i in 1..=3 {
        writer.append(&[f64::from(i), 2.0, 3.0]).unwrap();
        assert_eq!(Series::read(&path).unwrap().len(), i as usize);
    }
    let text = fs::read_to_string(&path).unwrap();
    assert!(text.starts_with("time [s],kinetic energy [J/m],surface particles\n"));
}

#[test]
fn a_resumed_series_has_every_instant_once() {
    let path = file("series_resume");
    let mut writer = SeriesWriter::create(&path, &columns()).unwrap();
    let time = |i: i32| 0.1 * f64::from(i);
    for i in 0..8 {
        writer.append(&[time(i), 0.0, 0.0]).unwrap();
    }
    drop(writer);
    // A row broken off by a crash.
    let mut text = fs::read_to_string(&path).unwrap();
    text.push_str("0.8,1.2");
    fs::write(&path, text).unwrap();
    assert_eq!(Series::read(&path).unwrap().len(), 8);

    let mut writer = SeriesWriter::resume(&path, &columns(), time(3)).unwrap();
    for i in 3..8 {
        writer.append(&[time(i), 1.0, 1.0]).unwrap();
    }
    let series = Series::read(&path).unwrap();
    let expected: Vec<f64> = (0..8).map(time).collect();
    assert_eq!(series.column("time").unwrap(), expected);
    // The row of the checkpoint's own instant was written anew.
    let energy = series.column("kinetic energy").unwrap();
    assert_eq!(energy, [0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 1.0]);
}

#[test]
fn a_row_broken_off_right_after_the_checkpoint_is_cut_away() {
    let path = file("series_broken_row");
    fs::write(&path, "time [s]\n0\n0.1\n0.2").unwrap();
    let columns = [Column::new("time", "s")];
    let mut writer = SeriesWriter::resume(&path, &columns, 0.2).unwrap();
    writer.append(&[0.25]).unwrap();
    assert_eq!(
        fs::read_to_string(&path).unwrap(),
        "time [s]\n0\n0.1\n0.25\n"
    );
}

#[test]
fn other_columns_are_refused_on_resume() {
    let path = file("series_other_columns");
    SeriesWriter::create(&path, &columns()).unwrap();
    let error = SeriesWriter::resume(&path, &columns()[..2], 1.0).unwrap_err();
    assert!(matches!(error.problem, Problem::BadLine { line: 1, .. }));
}

#[test]
fn samples_and_names_that_would_spoil_the_file_are_refused() {
    let path = file("series_refused");
    for name in ["", "a,b", "a\"b", "a\nb"] {
        let columns = [Column::new(name, "s")];
        assert!(SeriesWriter::create(&path, &columns).is_err(), "{name:?}");
    }
    let twice = [Column::new("time", "s"), Column::new("time", "s")];
    assert!(SeriesWriter::create(&path, &twice).is_err());
    assert!(SeriesWriter::create(&path, &[]).is_err());

    let mut writer = SeriesWriter::create(&path, &columns()).unwrap();
    writer.append(&[0.5, 1.0, 1.0]).unwrap();
    assert!(writer.append(&[0.6, 1.0]).is_err());
    assert!(writer.append(&[0.4, 1.0, 1.0]).is_err());
    assert!(writer.append(&[f64::NAN, 1.0, 1.0]).is_err());
    assert_eq!(Series::read(&path).unwrap().len(), 1);
}

#[test]
fn a_bad_row_is_told_with_its_line() {
    let path = file("series_bad_row");
    fs::write(&path, "time [s],x\n0,1\n0.1,one\n").unwrap();
    let error = Series::read(&path).unwrap_err();
    assert!(matches!(error.problem, Problem::BadLine { line: 3, .. }));
    assert!(error.to_string().contains("one"), "{error}");
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_told_with_path_and_cause() {
    let path = file("series_full_disk");
    std::os::unix::fs::symlink("/dev/full", &path).unwrap();
    let error = SeriesWriter::create(&path, &columns()).unwrap_err();
    let Problem::System { cause, .. } = &error.problem else {
        panic!("{error}")
    };
    assert_eq!(cause.kind(), std::io::ErrorKind::StorageFull);
    assert_eq!(error.path, path);
}
