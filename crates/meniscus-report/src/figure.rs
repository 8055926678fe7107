//! A finished figure.

use std::error::Error;
use std::fmt;

use crate::colour::Colour;
use crate::scene::Scene;

/// A finished figure: the same picture as SVG and as PNG.
#[derive(Clone, Debug)]
pub struct Figure {
    name: String,
    caption: String,
    scene: Scene,
}

/// A picture that cannot be drawn, with the reason.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FigureError(pub(crate) String);

impl fmt::Display for FigureError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "figure: {}", self.0)
    }
}

impl Error for FigureError {}

impl Figure {
    pub(crate) fn new(name: &str, caption: &str, scene: Scene) -> Self {
        Figure {
            name: name.to_owned(),
            caption: caption.to_owned(),
            scene,
        }
    }

    /// Name, the stem of its files.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// What the figure shows, in a sentence.
    pub fn caption(&self) -> &str {
        &self.caption
    }

    /// Width and height in pixels of the web.
    pub fn size(&self) -> (f64, f64) {
        (self.scene.width, self.scene.height)
    }

    /// The figure as an SVG document.
    ///
    /// More than 20 000 particles stand in it as an image, which fails as
    /// [`png`](Figure::png) does.
    pub fn svg(&self) -> Result<String, FigureError> {
        self.scene.svg(&self.caption)
    }

    /// The figure as a PNG file with two dots to a pixel of the web.
    ///
    /// Fails where the picture is larger than memory can hold.
    pub fn png(&self) -> Result<Vec<u8>, FigureError> {
        self.scene.png(Some(Colour::WHITE))
    }
}
