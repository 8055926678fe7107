//! One frame in VTK's XML format for unstructured grids.
//!
//! Source: "VTK XML file formats" in the VTK documentation. Each particle is
//! a vertex cell. Arrays stand inline in base64: a 64 bit length in bytes,
//! then the numbers, little-endian, encoded together; so the file is
//! well-formed XML that any reader can take apart.

use std::io::{self, Write};

use base64::engine::general_purpose::STANDARD;
use base64::write::EncoderWriter;

use crate::frame::Frame;

/// VTK's number for a cell that is one point.
const VERTEX: u8 = 1;

/// Writes the frame, whose faults were excluded before.
pub(crate) fn write(out: &mut dyn Write, frame: &Frame) -> io::Result<()> {
    let count = frame.positions.len();
    writeln!(out, r#"<?xml version="1.0"?>"#)?;
    writeln!(
        out,
        r#"<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64">"#
    )?;
    writeln!(out, "<UnstructuredGrid>")?;
    writeln!(out, "<FieldData>")?;
    single(out, "Float64", "TimeValue", frame.time.to_le_bytes())?;
    single(out, "UInt64", "step", frame.step.to_le_bytes())?;
    single(
        out,
        "UInt64",
        "dimension",
        (frame.dimension as u64).to_le_bytes(),
    )?;
    writeln!(out, "</FieldData>")?;
    writeln!(
        out,
        r#"<Piece NumberOfPoints="{count}" NumberOfCells="{count}">"#
    )?;

    writeln!(out, "<Points>")?;
    let coordinates = frame.positions.as_flattened();
    floats(out, r#"Name="Points" NumberOfComponents="3""#, coordinates)?;
    writeln!(out, "</Points>")?;

    writeln!(out, "<PointData>")?;
    for field in &frame.fields {
        let attributes = format!(
            r#"Name="{}" NumberOfComponents="{}""#,
            escape(&field.label()),
            field.components
        );
        floats(out, &attributes, &field.values)?;
    }
    writeln!(out, "</PointData>")?;

    writeln!(out, "<Cells>")?;
    let indices = (0..count as u64).map(u64::to_le_bytes);
    array(out, r#"type="Int64" Name="connectivity""#, count, indices)?;
    let ends = (1..=count as u64).map(u64::to_le_bytes);
    array(out, r#"type="Int64" Name="offsets""#, count, ends)?;
    let kinds = (0..count).map(|_| [VERTEX]);
    array(out, r#"type="UInt8" Name="types""#, count, kinds)?;
    writeln!(out, "</Cells>")?;
    writeln!(out, "</Piece>\n</UnstructuredGrid>\n</VTKFile>")
}

fn single(out: &mut dyn Write, kind: &str, name: &str, value: [u8; 8]) -> io::Result<()> {
    let attributes = format!(r#"type="{kind}" Name="{name}" NumberOfTuples="1""#);
    array(out, &attributes, 1, [value])
}

fn floats(out: &mut dyn Write, attributes: &str, values: &[f64]) -> io::Result<()> {
    let bytes = values.iter().map(|value| value.to_le_bytes());
    let attributes = format!(r#"type="Float64" {attributes}"#);
    array(out, &attributes, values.len(), bytes)
}

fn array<const BYTES: usize>(
    out: &mut dyn Write,
    attributes: &str,
    count: usize,
    values: impl IntoIterator<Item = [u8; BYTES]>,
) -> io::Result<()> {
    writeln!(out, r#"<DataArray {attributes} format="binary">"#)?;
    let mut encoder = EncoderWriter::new(&mut *out, &STANDARD);
    encoder.write_all(&((count * BYTES) as u64).to_le_bytes())?;
    for value in values {
        encoder.write_all(&value)?;
    }
    encoder.finish()?;
    drop(encoder);
    writeln!(out, "\n</DataArray>")
}

/// Text as it stands in an XML attribute.
fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}
