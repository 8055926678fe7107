//! Reads back the frames that [`vtu`](crate::vtu) writes, and no others.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use roxmltree::{Document, Node};

use crate::frame::{Field, Frame};
use crate::series::Column;

/// The frame in this text, or what is wrong with it.
pub(crate) fn read(text: &str) -> Result<Frame, String> {
    let document = Document::parse(text).map_err(|error| error.to_string())?;
    let root = document.root_element();
    let points = floats(array(root, "Points")?)?;
    let (positions, rest) = points.as_chunks::<3>();
    if !rest.is_empty() {
        return Err("the coordinates are not in threes".to_owned());
    }
    let data = root
        .descendants()
        .find(|node| node.has_tag_name("PointData"))
        .ok_or("it has no PointData")?;
    let mut fields = Vec::new();
    for node in data
        .children()
        .filter(|node| node.has_tag_name("DataArray"))
    {
        let label = node.attribute("Name").unwrap_or_default();
        let Column { name, unit } = Column::parse(label);
        let components = node
            .attribute("NumberOfComponents")
            .and_then(|n| n.parse().ok());
        fields.push(Field {
            name,
            unit,
            components: components.unwrap_or(1),
            values: floats(node)?,
        });
    }
    let frame = Frame {
        time: f64::from_le_bytes(single(root, "TimeValue")?),
        step: u64::from_le_bytes(single(root, "step")?),
        dimension: u64::from_le_bytes(single(root, "dimension")?) as usize,
        positions: positions.to_vec(),
        fields,
    };
    frame.fault().map_or(Ok(frame), Err)
}

fn array<'a>(root: Node<'a, 'a>, name: &str) -> Result<Node<'a, 'a>, String> {
    root.descendants()
        .find(|node| node.has_tag_name("DataArray") && node.attribute("Name") == Some(name))
        .ok_or_else(|| format!("it has no array {name:?}"))
}

fn single(root: Node<'_, '_>, name: &str) -> Result<[u8; 8], String> {
    let bytes = decode(array(root, name)?)?;
    bytes
        .try_into()
        .map_err(|_| format!("{name} is not one value"))
}

fn floats(node: Node<'_, '_>) -> Result<Vec<f64>, String> {
    let bytes = decode(node)?;
    let (values, rest) = bytes.as_chunks::<8>();
    if rest.is_empty() {
        Ok(values
            .iter()
            .map(|&bytes| f64::from_le_bytes(bytes))
            .collect())
    } else {
        Err("an array ends within a number".to_owned())
    }
}

/// The bytes of an array, whose length stands before them.
fn decode(node: Node<'_, '_>) -> Result<Vec<u8>, String> {
    let text = node.text().unwrap_or_default().trim();
    let mut bytes = STANDARD.decode(text).map_err(|error| error.to_string())?;
    let Some((&length, _)) = bytes.split_first_chunk::<8>() else {
        return Err("an array has no length".to_owned());
    };
    bytes.drain(..8);
    if bytes.len() as u64 == u64::from_le_bytes(length) {
        Ok(bytes)
    } else {
        Err("an array is shorter or longer than it says".to_owned())
    }
}
