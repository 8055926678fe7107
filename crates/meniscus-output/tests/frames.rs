//! Frames are read back by an XML reader that has nothing to do with the
//! writer; `read_with_vtk.py` does the same with VTK itself.

mod common;

use std::fs;
use std::path::Path;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use common::empty_folder;
use meniscus_output::{Field, Frame, FrameWriter, Problem};
use roxmltree::Document;

/// Numbers that are hard on a printer: subnormal, negative zero, huge, NaN.
fn frame(time: f64) -> Frame {
    let positions: Vec<[f64; 3]> = (0..97)
        .map(|i| {
            let angle = 0.37 * f64::from(i);
            [5e-5 * angle.cos(), 5e-5 * angle.sin(), 0.0]
        })
        .collect();
    let mut pressure: Vec<f64> = (0..97).map(|i| f64::from(i).exp() / 3.0).collect();
    pressure[..4].copy_from_slice(&[-0.0, 5e-324, f64::MAX, f64::NAN]);
    let velocity: Vec<[f64; 3]> = positions.iter().map(|p| [-p[1], p[0], 0.0]).collect();
    Frame {
        time,
        step: 12,
        dimension: 2,
        positions,
        fields: vec![
            Field::scalar("pressure", "Pa", pressure),
            Field::vector("velocity", "m/s", &velocity),
            Field::scalar("a<b & \"c\"", "", vec![1.0; 97]),
        ],
    }
}

fn floats(node: roxmltree::Node) -> Vec<u64> {
    assert_eq!(node.attribute("format"), Some("binary"));
    assert_eq!(node.attribute("type"), Some("Float64"));
    let bytes = STANDARD.decode(node.text().unwrap().trim()).unwrap();
    let (length, values) = bytes.split_at(8);
    let length = u64::from_le_bytes(length.try_into().unwrap());
    assert_eq!(length, values.len() as u64);
    let values = values.chunks_exact(8);
    values
        .map(|v| u64::from_le_bytes(v.try_into().unwrap()))
        .collect()
}

fn bits(values: &[f64]) -> Vec<u64> {
    values.iter().map(|v| v.to_bits()).collect()
}

/// Times and file names that the collection lists.
fn listed(pvd: &Path) -> Vec<(f64, String)> {
    let text = fs::read_to_string(pvd).unwrap();
    let document = Document::parse(&text).unwrap();
    document
        .descendants()
        .filter(|n| n.has_tag_name("DataSet"))
        .map(|n| {
            let time = n.attribute("timestep").unwrap().parse().unwrap();
            (time, n.attribute("file").unwrap().to_owned())
        })
        .collect()
}

#[test]
fn a_frame_reads_back_bit_for_bit() {
    let folder = empty_folder("frame_bits");
    let frame = frame(1.0 / 3.0);
    let path = FrameWriter::create(&folder).unwrap().write(&frame).unwrap();
    let text = fs::read_to_string(path).unwrap();
    let document = Document::parse(&text).unwrap();
    let array = |name: &str| {
        let mut nodes = document.descendants();
        nodes.find(|n| n.attribute("Name") == Some(name)).unwrap()
    };
    let positions: Vec<f64> = frame.positions.iter().flatten().copied().collect();
    assert_eq!(floats(array("Points")), bits(&positions));
    assert_eq!(
        floats(array("pressure [Pa]")),
        bits(&frame.fields[0].values)
    );
    assert_eq!(
        floats(array("velocity [m/s]")),
        bits(&frame.fields[1].values)
    );
    assert_eq!(floats(array("a<b & \"c\"")), bits(&frame.fields[2].values));
    assert_eq!(floats(array("TimeValue")), bits(&[1.0 / 3.0]));
    let piece = document.descendants().find(|n| n.has_tag_name("Piece"));
    assert_eq!(piece.unwrap().attribute("NumberOfCells"), Some("97"));
}

#[test]
fn a_frame_without_particles_is_a_frame() {
    let folder = empty_folder("frame_empty");
    let empty = Frame {
        time: 0.0,
        step: 0,
        dimension: 3,
        positions: vec![],
        fields: vec![Field::scalar("pressure", "Pa", vec![])],
    };
    let path = FrameWriter::create(&folder).unwrap().write(&empty).unwrap();
    Document::parse(&fs::read_to_string(path).unwrap()).unwrap();
}

#[test]
fn the_collection_is_whole_after_every_frame_and_tells_the_exact_times() {
    let folder = empty_folder("collection");
    let mut writer = FrameWriter::create(&folder).unwrap();
    assert_eq!(listed(&writer.collection()), []);
    for i in 0..4 {
        writer.write(&frame(0.1 * f64::from(i))).unwrap();
        let listed = listed(&writer.collection());
        assert_eq!(listed.len(), i as usize + 1);
        let (time, file) = listed.last().unwrap();
        assert_eq!(time.to_bits(), (0.1 * f64::from(i)).to_bits());
        assert!(folder.join(file).is_file());
    }
}

#[test]
fn a_resumed_run_drops_later_frames_and_goes_on() {
    let folder = empty_folder("frames_resume");
    let mut writer = FrameWriter::create(&folder).unwrap();
    for time in [0.0, 0.1, 0.2, 0.3] {
        writer.write(&frame(time)).unwrap();
    }
    // A frame that reached the disk, but not the collection, before a crash.
    fs::copy(
        folder.join("frame-000003.vtu"),
        folder.join("frame-000004.vtu"),
    )
    .unwrap();
    drop(writer);

    let mut writer = FrameWriter::resume(&folder, 0.1).unwrap();
    assert_eq!(writer.times(), [0.0, 0.1]);
    assert!(!folder.join("frame-000002.vtu").exists());
    assert!(!folder.join("frame-000004.vtu").exists());
    writer.write(&frame(0.15)).unwrap();
    let times: Vec<f64> = listed(&writer.collection()).iter().map(|l| l.0).collect();
    assert_eq!(times, [0.0, 0.1, 0.15]);
}

#[test]
fn a_frame_at_the_same_time_takes_the_place_of_the_last() {
    let folder = empty_folder("frames_same_time");
    let mut writer = FrameWriter::create(&folder).unwrap();
    let first = writer.write(&frame(0.1)).unwrap();
    assert_eq!(writer.write(&frame(0.1)).unwrap(), first);
    assert_eq!(writer.times(), [0.1]);
}

#[test]
fn a_frame_that_does_not_fit_is_refused_and_leaves_the_collection_as_it_was() {
    let folder = empty_folder("frames_refused");
    let mut writer = FrameWriter::create(&folder).unwrap();
    writer.write(&frame(0.1)).unwrap();
    let mut short = frame(0.2);
    short.fields[0].values.pop();
    let mut doubled = frame(0.2);
    doubled.fields.push(doubled.fields[0].clone());
    let mut nameless = frame(0.2);
    nameless.fields[0].name.clear();
    let mut flat = frame(0.2);
    flat.fields[1].components = 2;
    for wrong in [short, doubled, nameless, flat, frame(0.05), frame(f64::NAN)] {
        let error = writer.write(&wrong).unwrap_err();
        assert!(matches!(error.problem, Problem::BadData(_)), "{error}");
    }
    assert_eq!(listed(&writer.collection()).len(), 1);
    assert!(!folder.join("frame-000001.vtu").exists());
}

#[test]
fn a_collection_cut_short_is_told_with_its_line() {
    let folder = empty_folder("collection_damaged");
    let mut writer = FrameWriter::create(&folder).unwrap();
    writer.write(&frame(0.1)).unwrap();
    let pvd = writer.collection();
    let text = fs::read_to_string(&pvd).unwrap();
    fs::write(&pvd, &text[..text.len() - 10]).unwrap();
    let error = FrameWriter::resume(&folder, 1.0).unwrap_err();
    assert!(matches!(error.problem, Problem::BadLine { .. }), "{error}");
    assert_eq!(error.path, pvd);
}
