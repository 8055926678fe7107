//! What a plot draws.

use crate::colour::Colour;

/// Something drawn in a plot, with its name in the legend.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    pub(crate) name: String,
    pub(crate) x: Vec<f64>,
    pub(crate) y: Vec<f64>,
    /// Upper edge of a band, whose lower edge is `y`.
    pub(crate) upper: Vec<f64>,
    pub(crate) style: Style,
    pub(crate) colour: Option<Colour>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Style {
    Line,
    Dashed,
    Points,
    Band,
}

impl Curve {
    fn new(name: &str, x: &[f64], y: &[f64], upper: &[f64], style: Style) -> Self {
        Curve {
            name: name.to_owned(),
            x: x.to_vec(),
            y: y.to_vec(),
            upper: upper.to_vec(),
            style,
            colour: None,
        }
    }

    /// A line through the points, broken where a value is not finite. Of
    /// lists of different lengths the shorter one counts.
    pub fn line(name: &str, x: &[f64], y: &[f64]) -> Self {
        Self::new(name, x, y, &[], Style::Line)
    }

    /// A dashed dark line, for theory and fits.
    pub fn dashed(name: &str, x: &[f64], y: &[f64]) -> Self {
        Self::new(name, x, y, &[], Style::Dashed)
    }

    /// A mark at each point.
    pub fn points(name: &str, x: &[f64], y: &[f64]) -> Self {
        Self::new(name, x, y, &[], Style::Points)
    }

    /// A shaded band from `low` to `high`, for an uncertainty; it takes the
    /// colour of the curve before it.
    pub fn band(name: &str, x: &[f64], low: &[f64], high: &[f64]) -> Self {
        Self::new(name, x, low, high, Style::Band)
    }

    /// The same in a colour of choice.
    pub fn colour(self, colour: Colour) -> Self {
        Curve {
            colour: Some(colour),
            ..self
        }
    }
}
