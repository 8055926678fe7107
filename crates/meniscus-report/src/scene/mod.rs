//! A picture as a list of marks, in the order in which they are painted.
//!
//! Positions are in pixels of the web (1/96 inch), x to the right, y down.
//! [`svg`] prints the list, [`raster`] draws it; [`font`] knows the shapes and
//! widths of letters for both.

pub(crate) mod font;
mod raster;
mod svg;

use crate::colour::Colour;

/// A picture.
#[derive(Clone, Debug)]
pub(crate) struct Scene {
    pub width: f64,
    pub height: f64,
    pub marks: Vec<Mark>,
}

/// A rectangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Rect {
    pub left: f64,
    pub top: f64,
    pub width: f64,
    pub height: f64,
}

impl Rect {
    pub fn right(&self) -> f64 {
        self.left + self.width
    }

    pub fn bottom(&self) -> f64 {
        self.top + self.height
    }

    pub fn corners(&self) -> Vec<[f64; 2]> {
        vec![
            [self.left, self.top],
            [self.right(), self.top],
            [self.right(), self.bottom()],
            [self.left, self.bottom()],
        ]
    }
}

/// How a line is drawn.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stroke {
    pub colour: Colour,
    pub width: f64,
    pub dashed: bool,
}

/// Lengths of a dash and the gap behind it, in line widths.
pub(crate) const DASH: [f64; 2] = [4.0, 2.5];

/// A filled circle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Disc {
    pub centre: [f64; 2],
    pub radius: f64,
    pub fill: Colour,
}

/// Where a text stands relative to its position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Anchor {
    Start,
    Middle,
    End,
}

/// A line of text.
#[derive(Clone, Debug)]
pub(crate) struct Text {
    /// On the base line.
    pub at: [f64; 2],
    pub anchor: Anchor,
    pub size: f64,
    /// Reads from bottom to top.
    pub upright: bool,
    pub content: String,
}

/// Something painted.
#[derive(Clone, Debug)]
pub(crate) enum Mark {
    /// A line through the points.
    Line {
        points: Vec<[f64; 2]>,
        stroke: Stroke,
    },
    /// A filled polygon.
    Area {
        points: Vec<[f64; 2]>,
        fill: Colour,
        opacity: f64,
    },
    /// Circles; `edge` is the width of a darker rim as a share of the radius.
    Discs { discs: Vec<Disc>, edge: f64 },
    /// Text.
    Text(Text),
    /// Marks of which only what lies in the window shows.
    Clipped { window: Rect, marks: Vec<Mark> },
}

impl Mark {
    /// A text in the ink of texts, horizontal.
    pub fn text(at: [f64; 2], anchor: Anchor, size: f64, content: impl Into<String>) -> Mark {
        Mark::Text(Text {
            at,
            anchor,
            size,
            upright: false,
            content: content.into(),
        })
    }

    /// A plain straight line.
    pub fn segment(from: [f64; 2], to: [f64; 2], colour: Colour, width: f64) -> Mark {
        Mark::Line {
            points: vec![from, to],
            stroke: Stroke {
                colour,
                width,
                dashed: false,
            },
        }
    }
}
