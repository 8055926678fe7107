//! The layout of a checkpoint file.
//!
//! | bytes | content, little-endian |
//! |---|---|
//! | 8 | magic, `MENISCUS` |
//! | 4 | format: version of this table |
//! | 4 | CRC-32 of all bytes behind it |
//! | 4 | version of the state's layout |
//! | 8 | step |
//! | 8 | time, s, bits of an f64 |
//! | 8 | length of the state, unpacked |
//! | 8 | length of the state in the file |
//! | | the state: postcard, then an LZ4 block |

use serde::Serialize;
use serde::de::DeserializeOwned;

use super::Checkpoint;
use crate::error::Problem;

const MAGIC: [u8; 8] = *b"MENISCUS";
const FORMAT: u32 = 1;
/// Magic, format, checksum.
const PREFIX: usize = 16;
/// Everything before the state.
const HEADER: usize = PREFIX + 36;

pub(super) fn pack<State: Serialize>(
    state_version: u32,
    step: u64,
    time: f64,
    state: &State,
) -> Result<Vec<u8>, Problem> {
    let plain = postcard::to_stdvec(state).map_err(|e| Problem::State(e.to_string()))?;
    let packed = lz4_flex::block::compress(&plain);

    let mut body = Vec::with_capacity(HEADER - PREFIX + packed.len());
    body.extend(state_version.to_le_bytes());
    body.extend(step.to_le_bytes());
    body.extend(time.to_le_bytes());
    body.extend((plain.len() as u64).to_le_bytes());
    body.extend((packed.len() as u64).to_le_bytes());
    body.extend(packed);

    let mut file = Vec::with_capacity(PREFIX + body.len());
    file.extend(MAGIC);
    file.extend(FORMAT.to_le_bytes());
    file.extend(crc32fast::hash(&body).to_le_bytes());
    file.extend(body);
    Ok(file)
}

pub(super) fn unpack<State: DeserializeOwned>(
    state_version: u32,
    file: &[u8],
) -> Result<Checkpoint<State>, Problem> {
    // A file cut within the magic is still recognised by what is left of it.
    let start = file.len().min(MAGIC.len());
    if file.is_empty() || file[..start] != MAGIC[..start] {
        return Err(Problem::NotACheckpoint);
    }
    let found = file.len() as u64;
    let truncated = |expected| Problem::WrongLength { expected, found };
    let mut rest = Reader(&file[start..]);
    let header = || truncated(HEADER as u64);
    let format = rest.u32().ok_or_else(header)?;
    if format != FORMAT {
        return Err(Problem::UnknownFormat {
            found: format,
            known: FORMAT,
        });
    }
    let checksum = rest.u32().ok_or_else(header)?;
    let body = rest.0;
    let layout = rest.u32().ok_or_else(header)?;
    let step = rest.u64().ok_or_else(header)?;
    let time = rest.u64().ok_or_else(header)?;
    let plain_length = rest.u64().ok_or_else(header)?;
    let packed_length = rest.u64().ok_or_else(header)?;
    let expected = packed_length.saturating_add(HEADER as u64);
    if expected != found {
        return Err(truncated(expected));
    }
    if crc32fast::hash(body) != checksum {
        return Err(Problem::WrongChecksum);
    }
    if layout != state_version {
        return Err(Problem::OtherState {
            found: layout,
            known: state_version,
        });
    }
    let state = |reason: String| Problem::State(reason);
    let plain_length = usize::try_from(plain_length).map_err(|e| state(e.to_string()))?;
    let plain =
        lz4_flex::block::decompress(rest.0, plain_length).map_err(|e| state(e.to_string()))?;
    let (value, left) = postcard::take_from_bytes(&plain).map_err(|e| state(e.to_string()))?;
    if !left.is_empty() {
        return Err(state(format!("{} bytes more than it needs", left.len())));
    }
    Ok(Checkpoint {
        step,
        time: f64::from_bits(time),
        state: value,
    })
}

/// Takes numbers from the front of a slice.
struct Reader<'a>(&'a [u8]);

impl Reader<'_> {
    fn u32(&mut self) -> Option<u32> {
        let (bytes, rest) = self.0.split_first_chunk()?;
        self.0 = rest;
        Some(u32::from_le_bytes(*bytes))
    }

    fn u64(&mut self) -> Option<u64> {
        let (bytes, rest) = self.0.split_first_chunk()?;
        self.0 = rest;
        Some(u64::from_le_bytes(*bytes))
    }
}
