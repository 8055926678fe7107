//! Reading a mesh of triangles from the bytes of an STL file, ASCII or binary.
//!
//! Binary: a header of 80 bytes, the number of triangles (u32), and 50 bytes for each: normal and
//! three corners as twelve f32, and two bytes more; all little-endian. Which of the two a file is
//! follows from its length, since binary files too may begin with "solid". Normals are ignored:
//! the order of corners, anticlockwise seen from outside, says the same, and is rarely wrong.

use super::mesh::MeshError;
use crate::vector::Vector;

/// Corners of a triangle.
pub(super) type Triangle = [Vector<f64, 3>; 3];

const HEADER: usize = 84;
const RECORD: usize = 50;

/// The triangles of a file, in its own unit.
pub(super) fn read(bytes: &[u8]) -> Result<Vec<Triangle>, MeshError> {
    let announced = bytes
        .get(80..HEADER)
        .and_then(|count| count.try_into().ok())
        .map(u32::from_le_bytes);
    let expected = announced.map(|count| HEADER as u64 + u64::from(count) * RECORD as u64);
    if expected == Some(bytes.len() as u64) {
        return Ok(bytes[HEADER..].chunks_exact(RECORD).map(binary).collect());
    }
    // No text has a zero in it.
    if bytes.trim_ascii_start().starts_with(b"solid") && !bytes.contains(&0) {
        return ascii(&String::from_utf8_lossy(bytes));
    }
    Err(MeshError::NotStl(match expected {
        Some(expected) => format!(
            "it is no text that begins with \"solid\", and as a binary file would have {expected} bytes, not {}",
            bytes.len()
        ),
        None => "it is shorter than the header of a binary file".into(),
    }))
}

fn binary(record: &[u8]) -> Triangle {
    let (words, _) = record.as_chunks::<4>();
    let number = |k: usize| f64::from(f32::from_le_bytes(words[k]));
    // The first three are the normal.
    [3, 6, 9].map(|k| Vector([number(k), number(k + 1), number(k + 2)]))
}

fn ascii(text: &str) -> Result<Vec<Triangle>, MeshError> {
    let mut corners = Vec::new();
    for (line, content) in (1..).zip(text.lines()) {
        let mut words = content.split_ascii_whitespace();
        while let Some(word) = words.next() {
            if word != "vertex" {
                continue;
            }
            let mut corner = Vector::ZERO;
            for d in 0..3 {
                let number = words.next().and_then(|word| word.parse().ok());
                corner[d] = number.ok_or_else(|| {
                    MeshError::NotStl(format!("line {line} has no three numbers after \"vertex\""))
                })?;
            }
            corners.push(corner);
        }
    }
    let (triangles, rest) = corners.as_chunks::<3>();
    if !rest.is_empty() {
        return Err(MeshError::NotStl(format!(
            "its {} corners are no whole number of triangles",
            corners.len()
        )));
    }
    Ok(triangles.to_vec())
}
