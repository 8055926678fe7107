//! Scale bar, colour bar and names of colours.

use super::ColourScale;
use super::panels::Panels;
use crate::colour::{Colour, viridis};
use crate::number::{exponent, fixed, scaled_unit};
use crate::plot::ticks;
use crate::scene::{Anchor, Mark, Rect, Stroke, font};

/// Height of the strip below the panels.
pub(super) const HEIGHT: f64 = 78.0;
const TEXT: f64 = 12.5;
const BAR: f64 = 12.0;
/// From the panels to the upper edge of the bars.
const DOWN: f64 = 38.0;

/// A bar of round length below the first panel.
pub(super) fn scale_bar(marks: &mut Vec<Mark>, panels: &Panels, top: f64) {
    let window = panels.window(0);
    let wanted = 0.4 * window.width.min(300.0) / panels.scale;
    let length = round_down(wanted);
    let unit = scaled_unit("m", length);
    let number = length / unit.factor;
    let decimals = usize::try_from(-exponent(number)).unwrap_or(0);
    let (left, right) = (window.left + 4.0, window.left + 4.0 + length * panels.scale);
    let y = top + DOWN + 0.5 * BAR;
    let mut line = |from, to| marks.push(Mark::segment(from, to, Colour::INK, 1.5));
    line([left, y], [right, y]);
    line([left, y - 4.0], [left, y + 4.0]);
    line([right, y - 4.0], [right, y + 4.0]);
    let at = [0.5 * (left + right), top + DOWN + BAR + 1.35 * TEXT];
    let label = format!("{} {}", fixed(number, decimals), unit.unit);
    marks.push(Mark::text(at, Anchor::Middle, TEXT, label));
}

/// The largest round number (1, 2 or 5 times a power of ten) not above `x > 0`.
fn round_down(x: f64) -> f64 {
    1.0 / ticks::round_up(1.0 / x)
}

/// The colours with their values, at the right below the panels.
pub(super) fn colour_bar(
    marks: &mut Vec<Mark>,
    scale: &ColourScale,
    (quantity, unit): (&str, &str),
    width: f64,
    top: f64,
) {
    let bar = Rect {
        left: 0.42 * width,
        top: top + DOWN,
        width: 0.58 * width - 30.0,
        height: BAR,
    };
    // Each stripe reaches to the end and the next covers it: no seams.
    let stripes = 128;
    for i in 0..stripes {
        let share = f64::from(i) / f64::from(stripes);
        let left = bar.left + share * bar.width;
        let stripe = Rect {
            left,
            width: bar.right() - left,
            ..bar
        };
        marks.push(area(
            stripe.corners(),
            viridis(share + 0.5 / f64::from(stripes)),
        ));
    }
    let ends = [(bar.left, -1.0, 0.0), (bar.right(), 1.0, 1.0)];
    for ((x, side, share), beyond) in ends.into_iter().zip(scale.beyond) {
        if beyond {
            let tip = [x + side * 0.9 * BAR, bar.top + 0.5 * BAR];
            let points = vec![[x, bar.top], tip, [x, bar.bottom()]];
            marks.push(area(points, viridis(share)));
        }
    }
    let mut frame = bar.corners();
    frame.push(frame[0]);
    marks.push(Mark::Line {
        points: frame,
        stroke: Stroke {
            colour: Colour::AXIS,
            width: 0.8,
            dashed: false,
        },
    });

    let scaled = scaled_unit(unit, scale.low.abs().max(scale.high.abs()));
    let (low, high) = (scale.low / scaled.factor, scale.high / scaled.factor);
    for (value, label) in ticks::linear(low, high, bar.width / 75.0).labelled {
        let x = bar.left + (value - low) / (high - low) * bar.width;
        let foot = bar.bottom();
        marks.push(Mark::segment([x, foot], [x, foot + 4.0], Colour::AXIS, 1.0));
        let at = [x, foot + 4.0 + 1.1 * TEXT];
        marks.push(Mark::text(at, Anchor::Middle, TEXT, label));
    }
    let title = if scaled.unit.is_empty() {
        quantity.to_owned()
    } else {
        format!("{quantity} ({})", scaled.unit)
    };
    let at = [bar.left + 0.5 * bar.width, bar.top - 8.0];
    marks.push(Mark::text(at, Anchor::Middle, TEXT + 0.5, title));
}

/// Names beside their colours, at the right below the panels; what finds no room is left out.
pub(super) fn names<'a>(
    marks: &mut Vec<Mark>,
    names: impl Iterator<Item = (Colour, &'a String)>,
    width: f64,
    top: f64,
) {
    let begin = 0.42 * width;
    let (mut left, mut line) = (begin, top + 0.5 * DOWN);
    for (colour, name) in names {
        let needed = BAR + 6.0 + font::width(name, TEXT) + 18.0;
        if left > begin && left + needed > width {
            (left, line) = (begin, line + 1.6 * TEXT);
        }
        if line + BAR > top + HEIGHT {
            break;
        }
        let square = Rect {
            left,
            top: line,
            width: BAR,
            height: BAR,
        };
        marks.push(area(square.corners(), colour));
        let at = [left + BAR + 6.0, line + 0.85 * BAR];
        marks.push(Mark::text(at, Anchor::Start, TEXT, name.clone()));
        left += needed;
    }
}

fn area(points: Vec<[f64; 2]>, fill: Colour) -> Mark {
    Mark::Area {
        points,
        fill,
        opacity: 1.0,
    }
}
