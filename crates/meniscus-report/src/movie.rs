//! A moving picture.

use png::{BitDepth, ColorType, Compression, Encoder, EncodingError};

use crate::colour::Colour;
use crate::figure::FigureError;
use crate::scene::Scene;

/// Pictures in a second.
const RATE: u16 = 12;

/// A moving picture: as an animated PNG, which every browser shows.
#[derive(Clone, Debug)]
pub struct Movie {
    name: String,
    caption: String,
    scenes: Vec<Scene>,
}

impl Movie {
    pub(crate) fn new(name: &str, caption: &str, scenes: Vec<Scene>) -> Self {
        Movie {
            name: name.to_owned(),
            caption: caption.to_owned(),
            scenes,
        }
    }

    /// Name, the stem of its file.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// What the movie shows, in a sentence.
    pub fn caption(&self) -> &str {
        &self.caption
    }

    /// The movie as an animated PNG file with a dot to a pixel of the web,
    /// twelve pictures a second, without end.
    ///
    /// Fails where it has no pictures, or one is larger than memory can hold.
    pub fn png(&self) -> Result<Vec<u8>, FigureError> {
        let drawn = (self
            .scenes
            .iter()
            .map(|scene| scene.dots(Some(Colour::WHITE), 1.0)))
        .collect::<Result<Vec<_>, _>>()?;
        let Some(first) = drawn.first() else {
            return Err(FigureError("a movie without pictures".into()));
        };
        let broken =
            |cause: EncodingError| FigureError(format!("the movie could not be encoded: {cause}"));
        let mut bytes = Vec::new();
        let mut encoder = Encoder::new(&mut bytes, first.width(), first.height());
        encoder.set_color(ColorType::Rgb);
        encoder.set_depth(BitDepth::Eight);
        encoder.set_compression(Compression::Balanced);
        encoder
            .set_animated(drawn.len() as u32, 0)
            .and_then(|()| encoder.set_frame_delay(1, RATE))
            .map_err(broken)?;
        let mut writer = encoder.write_header().map_err(broken)?;
        for picture in &drawn {
            // The ground is opaque, so colours are not multiplied by anything.
            let rgb: Vec<u8> = (picture.pixels().iter())
                .flat_map(|dot| [dot.red(), dot.green(), dot.blue()])
                .collect();
            writer.write_image_data(&rgb).map_err(broken)?;
        }
        writer.finish().map_err(broken)?;
        Ok(bytes)
    }
}
