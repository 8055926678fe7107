//! Colours: a palette for curves and a map for values.

/// A colour, red, green and blue.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Colour(pub [u8; 3]);

/// Colours that the colour-blind tell apart, in the order in which curves
/// take them. Source: M. Okabe and K. Ito, Color Universal Design (2008); the
/// yellow is left out, being too light for a line on white.
pub const PALETTE: [Colour; 6] = [
    Colour([0x00, 0x72, 0xb2]),
    Colour([0xd5, 0x5e, 0x00]),
    Colour([0x00, 0x9e, 0x73]),
    Colour([0xcc, 0x79, 0xa7]),
    Colour([0x56, 0xb4, 0xe9]),
    Colour([0xe6, 0x9f, 0x00]),
];

impl Colour {
    /// Text and theory lines.
    pub(crate) const INK: Colour = Colour([0x22, 0x22, 0x22]);
    /// Axes and ticks.
    pub(crate) const AXIS: Colour = Colour([0x55, 0x55, 0x55]);
    /// Grid lines.
    pub(crate) const GRID: Colour = Colour([0xe6, 0xe6, 0xe6]);
    /// Particles without a value.
    pub(crate) const NO_VALUE: Colour = Colour([0xb4, 0xb4, 0xb4]);
    /// Background.
    pub(crate) const WHITE: Colour = Colour([0xff, 0xff, 0xff]);

    /// As SVG writes it.
    pub(crate) fn hex(self) -> String {
        let [r, g, b] = self.0;
        format!("#{r:02x}{g:02x}{b:02x}")
    }

    /// The same colour mixed with black; 0 leaves it, 1 gives black.
    pub(crate) fn darker(self, share: f64) -> Colour {
        Colour(self.0.map(|c| (f64::from(c) * (1.0 - share)).round() as u8))
    }
}

/// The map viridis at `share` of the way from its dark to its light end.
pub(crate) fn viridis(share: f64) -> Colour {
    let colour = colorous::VIRIDIS.eval_continuous(share.clamp(0.0, 1.0));
    Colour([colour.r, colour.g, colour.b])
}
