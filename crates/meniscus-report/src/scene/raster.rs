//! Drawing a scene in dots.

use tiny_skia::{
    FillRule, LineJoin, Mask, Paint, Path, PathBuilder, Pixmap, StrokeDash, Transform,
};
use ttf_parser::OutlineBuilder;

use super::{Anchor, DASH, Disc, Mark, Rect, Scene, Stroke, Text, font};
use crate::colour::Colour;
use crate::figure::FigureError;

/// Dots to a pixel of the web, for a sharp picture on paper and fine screens.
const DOTS: f64 = 2.0;

impl Scene {
    /// The scene as the bytes of a PNG file, on a background or on none.
    pub fn png(&self, background: Option<Colour>) -> Result<Vec<u8>, FigureError> {
        let encoded = self.dots(background, DOTS)?.encode_png();
        encoded.map_err(|cause| FigureError(format!("the PNG could not be encoded: {cause}")))
    }

    /// The scene drawn with so many dots to a pixel of the web.
    pub fn dots(&self, background: Option<Colour>, dots: f64) -> Result<Pixmap, FigureError> {
        let [width, height] = [self.width, self.height].map(|x| (x * dots).round() as u32);
        let too_large = || FigureError(format!("{width} by {height} dots cannot be drawn"));
        let mut canvas = Canvas {
            pixmap: Pixmap::new(width, height).ok_or_else(too_large)?,
            mask: None,
            scaled: Transform::from_scale(dots as f32, dots as f32),
        };
        if let Some(colour) = background {
            canvas.pixmap.fill(paint_colour(colour, 1.0));
        }
        for mark in &self.marks {
            canvas.draw(mark);
        }
        Ok(canvas.pixmap)
    }
}

struct Canvas {
    pixmap: Pixmap,
    mask: Option<Mask>,
    /// From pixels of the web to dots.
    scaled: Transform,
}

impl Canvas {
    fn draw(&mut self, mark: &Mark) {
        match mark {
            Mark::Line { points, stroke } => {
                if let Some(path) = polygon(points, false) {
                    self.stroke(&path, stroke);
                }
            }
            Mark::Area {
                points,
                fill,
                opacity,
            } => {
                if let Some(path) = polygon(points, true) {
                    self.fill(&path, *fill, *opacity, Transform::identity());
                }
            }
            Mark::Discs { discs, edge } => discs.iter().for_each(|disc| self.disc(disc, *edge)),
            Mark::Text(text) => self.text(text),
            Mark::Clipped { window, marks } => {
                let outer = self.mask.take();
                self.mask = self.window(window);
                marks.iter().for_each(|mark| self.draw(mark));
                self.mask = outer;
            }
        }
    }

    fn window(&self, window: &Rect) -> Option<Mask> {
        let mut mask = Mask::new(self.pixmap.width(), self.pixmap.height())?;
        let path = polygon(&window.corners(), true)?;
        mask.fill_path(&path, FillRule::Winding, true, self.scaled);
        Some(mask)
    }

    /// Fills a path given in pixels of the web, moved by `place` first.
    fn fill(&mut self, path: &Path, colour: Colour, opacity: f64, place: Transform) {
        let place = place.post_concat(self.scaled);
        let paint = paint(colour, opacity);
        let mask = self.mask.as_ref();
        self.pixmap
            .fill_path(path, &paint, FillRule::Winding, place, mask);
    }

    fn stroke(&mut self, path: &Path, stroke: &Stroke) {
        let width = stroke.width as f32;
        let dash = DASH.map(|d| d as f32 * width).to_vec();
        let style = tiny_skia::Stroke {
            width,
            line_join: LineJoin::Round,
            dash: stroke.dashed.then(|| StrokeDash::new(dash, 0.0)).flatten(),
            ..Default::default()
        };
        let paint = paint(stroke.colour, 1.0);
        let mask = self.mask.as_ref();
        self.pixmap
            .stroke_path(path, &paint, &style, self.scaled, mask);
    }

    fn disc(&mut self, disc: &Disc, edge: f64) {
        let [x, y] = disc.centre.map(|c| c as f32);
        let rim = edge * disc.radius;
        let Some(path) = PathBuilder::from_circle(x, y, (disc.radius - 0.5 * rim) as f32) else {
            return;
        };
        self.fill(&path, disc.fill, 1.0, Transform::identity());
        if rim > 0.0 {
            let stroke = Stroke {
                colour: disc.fill.darker(0.45),
                width: rim,
                dashed: false,
            };
            self.stroke(&path, &stroke);
        }
    }

    fn text(&mut self, text: &Text) {
        let width = font::width(&text.content, text.size);
        let start = match text.anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => -0.5 * width,
            Anchor::End => -width,
        };
        let letters = font::outline(&text.content, |pen, units| Letter {
            path: PathBuilder::new(),
            scale: text.size / units,
            left: start + pen * text.size,
        });
        let [x, y] = text.at.map(|c| c as f32);
        let turn = Transform::from_rotate(if text.upright { -90.0 } else { 0.0 });
        let place = turn.post_translate(x, y);
        for letter in letters {
            if let Some(path) = letter.path.finish() {
                self.fill(&path, Colour::INK, 1.0, place);
            }
        }
    }
}

fn paint_colour(colour: Colour, opacity: f64) -> tiny_skia::Color {
    let [r, g, b] = colour.0;
    tiny_skia::Color::from_rgba8(r, g, b, (opacity * 255.0).round() as u8)
}

fn paint(colour: Colour, opacity: f64) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color(paint_colour(colour, opacity));
    paint
}

fn polygon(points: &[[f64; 2]], closed: bool) -> Option<Path> {
    let mut path = PathBuilder::new();
    for (i, [x, y]) in points.iter().enumerate() {
        if i == 0 {
            path.move_to(*x as f32, *y as f32);
        } else {
            path.line_to(*x as f32, *y as f32);
        }
    }
    if closed {
        path.close();
    }
    path.finish()
}

/// Takes the outline of a letter, in the font's units with y up.
struct Letter {
    path: PathBuilder,
    scale: f64,
    left: f64,
}

impl Letter {
    fn at(&self, x: f32, y: f32) -> (f32, f32) {
        let x = self.left + f64::from(x) * self.scale;
        (x as f32, (-f64::from(y) * self.scale) as f32)
    }
}

impl OutlineBuilder for Letter {
    fn move_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.at(x, y);
        self.path.move_to(x, y);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.at(x, y);
        self.path.line_to(x, y);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let (x1, y1) = self.at(x1, y1);
        let (x, y) = self.at(x, y);
        self.path.quad_to(x1, y1, x, y);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let (x1, y1) = self.at(x1, y1);
        let (x2, y2) = self.at(x2, y2);
        let (x, y) = self.at(x, y);
        self.path.cubic_to(x1, y1, x2, y2, x, y);
    }

    fn close(&mut self) {
        self.path.close();
    }
}
