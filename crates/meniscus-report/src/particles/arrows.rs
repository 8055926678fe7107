//! Arrows on the particles: where they go.

use std::collections::HashMap;

use super::panels::Panels;
use super::view::Seen;
use crate::colour::Colour;
use crate::scene::{Mark, Stroke};

/// Least distance between arrows, pixels.
const APART: f64 = 11.0;
/// Length of the arrow of the fastest hundredth, pixels.
const LONGEST: f64 = 14.0;
/// Shorter ones, pixels, are left out.
const SHORTEST: f64 = 1.5;
const HEAD: f64 = 3.2;

/// Pixels of an arrow to the unit of what it shows, the same for all panels.
pub(super) fn scale<'a>(all: impl Iterator<Item = &'a Seen>) -> f64 {
    let mut lengths: Vec<f64> = all
        .filter_map(|particle| particle.arrow)
        .map(|[x, y]| x.hypot(y))
        .filter(|length| *length > 0.0 && length.is_finite())
        .collect();
    lengths.sort_by(f64::total_cmp);
    let fastest = lengths.get(lengths.len().saturating_sub(1) * 99 / 100);
    fastest.map_or(0.0, |fastest| LONGEST / fastest)
}

/// Arrows of panel `i`, one to a square of the picture: that of the particle nearest to its middle.
pub(super) fn draw(marks: &mut Vec<Mark>, panels: &Panels, i: usize, seen: &[Seen], scale: f64) {
    let mut chosen: HashMap<[i64; 2], (f64, [f64; 2], [f64; 2])> = HashMap::new();
    for particle in seen {
        let Some([right, up]) = particle.arrow else {
            continue;
        };
        let at = panels.place(i, particle.at);
        let square = at.map(|x| (x / APART).floor());
        let off = (0..2)
            .map(|d| (at[d] / APART - square[d] - 0.5).powi(2))
            .sum::<f64>();
        let entry = (off, at, [right * scale, -up * scale]);
        let kept = chosen.entry(square.map(|x| x as i64)).or_insert(entry);
        if off < kept.0 {
            *kept = entry;
        }
    }
    let mut arrows: Vec<_> = chosen.into_iter().collect();
    arrows.sort_by_key(|(square, _)| *square);
    for (_, (_, [x, y], [dx, dy])) in arrows {
        let length = dx.hypot(dy);
        if !(SHORTEST..=3.0 * LONGEST).contains(&length) {
            continue;
        }
        let (tip, along) = ([x + dx, y + dy], [dx / length, dy / length]);
        let back = HEAD.min(0.6 * length);
        let side = |sign: f64| {
            [
                tip[0] - back * (along[0] - 0.5 * sign * along[1]),
                tip[1] - back * (along[1] + 0.5 * sign * along[0]),
            ]
        };
        let stroke = Stroke {
            colour: Colour::INK,
            width: 0.7,
            dashed: false,
        };
        marks.push(Mark::Line {
            points: vec![[x, y], tip],
            stroke,
        });
        marks.push(Mark::Area {
            points: vec![tip, side(1.0), side(-1.0)],
            fill: Colour::INK,
            opacity: 1.0,
        });
    }
}
