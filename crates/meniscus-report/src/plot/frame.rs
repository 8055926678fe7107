//! The area between two axes, with grid, ticks, numbers and titles.

use super::axis::FittedAxis;
use super::ticks::Ticks;
use crate::colour::Colour;
use crate::scene::{Anchor, Mark, Rect, Stroke, Text, font};

/// Width of the whole plot, pixels.
pub(super) const WIDTH: f64 = 640.0;
/// Height of the area between the axes.
const HEIGHT: f64 = 300.0;
/// Size of numbers and of the legend.
pub(super) const TEXT: f64 = 12.5;
/// Size of the titles of the axes.
const TITLE: f64 = 14.0;
/// Length of a tick.
const TICK: f64 = 5.0;
/// Between a tick and its number.
const GAP: f64 = 4.0;
/// Room at the right, where the last number stands out by half its width.
const RIGHT: f64 = 22.0;

/// Two axes and the area between them.
pub(super) struct PlotFrame {
    pub area: Rect,
    x: FittedAxis,
    y: FittedAxis,
    x_ticks: Ticks,
    y_ticks: Ticks,
}

impl PlotFrame {
    /// Lays out the axes; `area.top` stays 0 until the height of what stands
    /// above is known.
    pub fn new(x: FittedAxis, y: FittedAxis) -> Self {
        let y_ticks = y.ticks(HEIGHT / 50.0);
        let labels = y_ticks.labelled.iter().map(|(_, l)| font::width(l, TEXT));
        let left = labels.fold(0.0, f64::max) + TICK + GAP + 1.9 * TITLE;
        let width = WIDTH - left - RIGHT;
        PlotFrame {
            area: Rect {
                left,
                top: 0.0,
                width,
                height: HEIGHT,
            },
            x_ticks: x.ticks(width / 85.0),
            y_ticks,
            x,
            y,
        }
    }

    /// Where a pair of values lies.
    pub fn place(&self, x: f64, y: f64) -> [f64; 2] {
        [self.at_x(x), self.at_y(y)]
    }

    fn at_x(&self, value: f64) -> f64 {
        self.area.left + self.x.share(value) * self.area.width
    }

    fn at_y(&self, value: f64) -> f64 {
        self.area.bottom() - self.y.share(value) * self.area.height
    }

    /// Where the plot ends, below the title of the x axis.
    pub fn bottom(&self) -> f64 {
        self.area.bottom() + TICK + 2.2 * TEXT + 1.7 * TITLE
    }

    /// Draws everything but the curves.
    pub fn draw(&self, marks: &mut Vec<Mark>) {
        let (left, right) = (self.area.left, self.area.right());
        let (top, bottom) = (self.area.top, self.area.bottom());
        let mut line = |from, to, colour| marks.push(Mark::segment(from, to, colour, 1.0));
        for (value, _) in &self.x_ticks.labelled {
            let x = self.at_x(*value);
            line([x, top], [x, bottom], Colour::GRID);
            line([x, bottom], [x, bottom + TICK], Colour::AXIS);
        }
        for (value, _) in &self.y_ticks.labelled {
            let y = self.at_y(*value);
            line([left, y], [right, y], Colour::GRID);
            line([left - TICK, y], [left, y], Colour::AXIS);
        }
        for value in &self.x_ticks.small {
            let x = self.at_x(*value);
            line([x, bottom], [x, bottom + 0.5 * TICK], Colour::AXIS);
        }
        for value in &self.y_ticks.small {
            let y = self.at_y(*value);
            line([left - 0.5 * TICK, y], [left, y], Colour::AXIS);
        }
        let mut outline = self.area.corners();
        outline.push([left, top]);
        marks.push(Mark::Line {
            points: outline,
            stroke: Stroke {
                colour: Colour::AXIS,
                width: 1.0,
                dashed: false,
            },
        });
        for (value, label) in &self.x_ticks.labelled {
            let at = [self.at_x(*value), bottom + TICK + 1.1 * TEXT];
            marks.push(Mark::text(at, Anchor::Middle, TEXT, label));
        }
        for (value, label) in &self.y_ticks.labelled {
            let at = [left - TICK - GAP, self.at_y(*value) + 0.36 * TEXT];
            marks.push(Mark::text(at, Anchor::End, TEXT, label));
        }
        let below = bottom + TICK + 1.3 * TEXT + 1.5 * TITLE;
        let centre = [left + 0.5 * self.area.width, below];
        marks.push(Mark::text(centre, Anchor::Middle, TITLE, self.x.title()));
        marks.push(Mark::Text(Text {
            at: [1.1 * TITLE, top + 0.5 * self.area.height],
            anchor: Anchor::Middle,
            size: TITLE,
            upright: true,
            content: self.y.title(),
        }));
    }
}
