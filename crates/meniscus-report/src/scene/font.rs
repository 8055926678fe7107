//! The shapes and widths of letters.

use std::sync::LazyLock;

use ttf_parser::{Face, OutlineBuilder};

/// Families whose widths are those of the font that travels with us.
pub(crate) const FAMILIES: &str = "Arimo, Arial, Helvetica, Liberation Sans, sans-serif";

static BYTES: &[u8] = include_bytes!("../../font/Arimo-Regular.ttf");

/// Nothing but a damaged build can leave this empty; texts are then missing
/// from the PNG and their widths guessed.
static FACE: LazyLock<Option<Face<'static>>> = LazyLock::new(|| Face::parse(BYTES, 0).ok());

/// Width of a line of text of the given size, in the unit of the size.
pub(crate) fn width(text: &str, size: f64) -> f64 {
    text.chars().map(|letter| advance(letter) * size).sum()
}

/// How far a letter moves the pen, in sizes.
fn advance(letter: char) -> f64 {
    const GUESS: f64 = 0.56;
    let Some(face) = FACE.as_ref() else {
        return GUESS;
    };
    let glyph = face.glyph_index(letter).unwrap_or_default();
    let advance = face.glyph_hor_advance(glyph).map(f64::from);
    advance.map_or(GUESS, |a| a / f64::from(face.units_per_em()))
}

/// Draws the letters of a text one by one: `place` gets the pen's distance
/// from the start, in sizes, and the font's units per size, and gives the
/// builder that takes the outline, in the font's units, y up.
pub(crate) fn outline<B: OutlineBuilder>(
    text: &str,
    mut place: impl FnMut(f64, f64) -> B,
) -> Vec<B> {
    let Some(face) = FACE.as_ref() else {
        return Vec::new();
    };
    let units = f64::from(face.units_per_em());
    let mut pen = 0.0;
    let mut letters = Vec::new();
    for letter in text.chars() {
        let mut builder = place(pen, units);
        face.outline_glyph(face.glyph_index(letter).unwrap_or_default(), &mut builder);
        letters.push(builder);
        pen += advance(letter);
    }
    letters
}
