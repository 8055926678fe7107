//! Laying out a plot: legend on top, axes, curves.

use super::axis::Axis;
use super::curve::{Curve, Style};
use super::frame::{PlotFrame, TEXT, WIDTH};
use crate::colour::{Colour, PALETTE};
use crate::figure::Figure;
use crate::scene::{Anchor, Disc, Mark, Rect, Scene, Stroke, font};

const LEGEND_ROW: f64 = 21.0;
/// Width of the sample of a curve in the legend.
const SAMPLE: f64 = 26.0;

/// Curves, points, theory lines and bands over common axes.
///
/// Values are in the plain units of the axes. The legend stands above, where
/// it hides nothing.
#[derive(Clone, Debug)]
pub struct LinePlot {
    x: Axis,
    y: Axis,
    curves: Vec<Curve>,
}

impl LinePlot {
    /// An empty plot over two axes.
    pub fn new(x: Axis, y: Axis) -> Self {
        LinePlot {
            x,
            y,
            curves: Vec::new(),
        }
    }

    /// The same with one more curve. A curve without a colour of its own
    /// takes the next of the [`PALETTE`]; a dashed one is dark.
    pub fn with(mut self, curve: Curve) -> Self {
        self.curves.push(curve);
        self
    }

    /// The finished figure.
    pub fn figure(&self, name: &str, caption: &str) -> Figure {
        let has_points = self.curves.iter().any(|c| c.style == Style::Points);
        let side = if has_points { 0.03 } else { 0.0 };
        let x = self
            .x
            .fit(self.curves.iter().flat_map(|c| c.x.iter().copied()), side);
        let heights = |c: &Curve| [c.y.clone(), c.upper.clone()].concat();
        let y = self.y.fit(self.curves.iter().flat_map(heights), 0.06);

        let mut frame = PlotFrame::new(x, y);
        let legend = self.legend(frame.area.left, frame.area.width);
        frame.area.top = legend.height + 12.0;

        let mut marks = Vec::new();
        frame.draw(&mut marks);
        let mut curves = Vec::new();
        for bands in [true, false] {
            for (curve, colour) in self.curves.iter().zip(self.colours()) {
                if (curve.style == Style::Band) == bands {
                    self.draw(&mut curves, curve, colour, &frame);
                }
            }
        }
        // Points on the very edge stay whole.
        let margin = if has_points { 5.0 } else { 1.0 };
        marks.push(Mark::Clipped {
            window: Rect {
                left: frame.area.left - margin,
                top: frame.area.top - margin,
                width: frame.area.width + 2.0 * margin,
                height: frame.area.height + 2.0 * margin,
            },
            marks: curves,
        });
        marks.extend(legend.marks);
        let scene = Scene {
            width: WIDTH,
            height: frame.bottom(),
            marks,
        };
        Figure::new(name, caption, scene)
    }

    fn colours(&self) -> Vec<Colour> {
        let mut next = PALETTE.iter().cycle().copied();
        let mut before = PALETTE[0];
        let mut colours = Vec::new();
        for curve in &self.curves {
            let own = match curve.style {
                Style::Dashed => Some(Colour::INK),
                Style::Band => Some(before),
                Style::Line | Style::Points => None,
            };
            let colour = curve.colour.or(own).or_else(|| next.next());
            before = colour.unwrap_or(before);
            colours.push(before);
        }
        colours
    }

    fn draw(&self, marks: &mut Vec<Mark>, curve: &Curve, colour: Colour, frame: &PlotFrame) {
        let runs = self.runs(curve);
        let placed = |run: &[(f64, f64, f64)]| -> Vec<[f64; 2]> {
            run.iter().map(|&(x, y, _)| frame.place(x, y)).collect()
        };
        match curve.style {
            Style::Line | Style::Dashed => {
                for run in &runs {
                    marks.push(Mark::Line {
                        points: thinned(placed(run)),
                        stroke: stroke_of(curve.style, colour),
                    });
                }
            }
            Style::Points => {
                let count = runs.iter().map(Vec::len).sum();
                let radius = point_radius(count);
                let shape = self.shape(curve);
                let centres = runs.iter().flat_map(|run| placed(run));
                marks.extend(centres.map(|centre| point(shape, centre, radius, colour)));
            }
            Style::Band => {
                for run in &runs {
                    let mut points = placed(run);
                    points.extend(run.iter().rev().map(|&(x, _, upper)| frame.place(x, upper)));
                    marks.push(Mark::Area {
                        points,
                        fill: colour,
                        opacity: 0.2,
                    });
                }
            }
        }
    }

    /// The points of a curve in pieces without gaps: x, y, upper edge.
    fn runs(&self, curve: &Curve) -> Vec<Vec<(f64, f64, f64)>> {
        let upper = if curve.style == Style::Band {
            &curve.upper
        } else {
            &curve.y
        };
        let mut runs = vec![Vec::new()];
        for ((&x, &y), &upper) in curve.x.iter().zip(&curve.y).zip(upper) {
            if self.x.shows(x) && self.y.shows(y) && self.y.shows(upper) {
                if let Some(run) = runs.last_mut() {
                    run.push((x, y, upper));
                }
            } else {
                runs.push(Vec::new());
            }
        }
        runs.retain(|run| !run.is_empty());
        runs
    }

    /// How many curves of points stand before this one.
    fn shape(&self, curve: &Curve) -> usize {
        let before = self.curves.iter().take_while(|c| !std::ptr::eq(*c, curve));
        before.filter(|c| c.style == Style::Points).count()
    }

    /// The piece of a curve beside its name in the legend.
    fn sample(&self, curve: &Curve, colour: Colour, [x, y]: [f64; 2]) -> Mark {
        match curve.style {
            Style::Line | Style::Dashed => Mark::Line {
                points: vec![[x, y], [x + SAMPLE, y]],
                stroke: stroke_of(curve.style, colour),
            },
            Style::Points => point(self.shape(curve), [x + 0.5 * SAMPLE, y], 3.6, colour),
            Style::Band => Mark::Area {
                points: Rect {
                    left: x,
                    top: y - 6.0,
                    width: SAMPLE,
                    height: 12.0,
                }
                .corners(),
                fill: colour,
                opacity: 0.2,
            },
        }
    }

    fn legend(&self, left: f64, width: f64) -> Legend {
        let mut marks = Vec::new();
        let (mut x, mut y) = (left, 0.5 * LEGEND_ROW + 4.0);
        let mut rows = 0.0;
        for (curve, colour) in self.curves.iter().zip(self.colours()) {
            if curve.name.is_empty() {
                continue;
            }
            let entry = SAMPLE + 7.0 + font::width(&curve.name, TEXT) + 20.0;
            if rows == 0.0 {
                rows = 1.0;
            } else if x + entry > left + width {
                (x, y, rows) = (left, y + LEGEND_ROW, rows + 1.0);
            }
            marks.push(self.sample(curve, colour, [x, y]));
            let at = [x + SAMPLE + 7.0, y + 0.36 * TEXT];
            marks.push(Mark::text(at, Anchor::Start, TEXT, &curve.name));
            x += entry;
        }
        Legend {
            marks,
            height: rows * LEGEND_ROW + 4.0,
        }
    }
}

struct Legend {
    marks: Vec<Mark>,
    height: f64,
}

/// A mark of a point: disc, square, triangle, diamond, in turn, so that
/// curves are told apart without colours too.
fn point(shape: usize, [x, y]: [f64; 2], radius: f64, fill: Colour) -> Mark {
    // The first corner's direction, in turns from the right, and the corners,
    // at distances that give all shapes about the same area.
    let (corners, first, reach) = match shape % 4 {
        0 => {
            let disc = Disc {
                centre: [x, y],
                radius,
                fill,
            };
            return Mark::Discs {
                discs: vec![disc],
                edge: 0.0,
            };
        }
        1 => (4, 0.125, 1.25),
        2 => (3, 0.25, 1.5),
        _ => (4, 0.0, 1.35),
    };
    let corner = |i: i32| {
        let angle = std::f64::consts::TAU * (first + f64::from(i) / f64::from(corners));
        [
            x + reach * radius * angle.cos(),
            y - reach * radius * angle.sin(),
        ]
    };
    Mark::Area {
        points: (0..corners).map(corner).collect(),
        fill,
        opacity: 1.0,
    }
}

fn stroke_of(style: Style, colour: Colour) -> Stroke {
    let dashed = style == Style::Dashed;
    Stroke {
        colour,
        width: if dashed { 1.5 } else { 2.0 },
        dashed,
    }
}

/// Smaller marks where there are many.
fn point_radius(count: usize) -> f64 {
    match count {
        0..60 => 3.6,
        60..400 => 2.2,
        _ => 1.4,
    }
}

/// The line with no more points than can be seen: where many fall into half a
/// pixel's width, the first, lowest, highest and last of them.
fn thinned(points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    if points.len() < 4 * WIDTH as usize {
        return points;
    }
    let column = |p: &[f64; 2]| (2.0 * p[0]).floor();
    let mut kept = Vec::new();
    for run in points.chunk_by(|a, b| column(a) == column(b)) {
        let height = |i: &usize, j: &usize| run[*i][1].total_cmp(&run[*j][1]);
        let lowest = (0..run.len()).max_by(height).unwrap_or(0);
        let highest = (0..run.len()).min_by(height).unwrap_or(0);
        let mut chosen = vec![0, lowest, highest, run.len() - 1];
        chosen.sort_unstable();
        chosen.dedup();
        kept.extend(chosen.into_iter().map(|i| run[i]));
    }
    kept
}
