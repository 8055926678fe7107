//! Printing a scene as SVG.

use std::fmt::Write;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use super::{Anchor, DASH, Disc, Mark, Scene, Stroke, Text, font};
use crate::colour::Colour;
use crate::figure::FigureError;
use crate::report::escape;

/// More circles than this go into the SVG as an image: viewers take minutes
/// over hundreds of thousands of elements.
const MANY_DISCS: usize = 20_000;

impl Scene {
    /// The scene as an SVG document; `title` is read out to who cannot see it.
    pub fn svg(&self, title: &str) -> Result<String, FigureError> {
        let (width, height) = (round(self.width), round(self.height));
        let mut out = format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}" role="img" font-family="{}" fill="{}">"#,
            font::FAMILIES,
            Colour::INK.hex()
        );
        line(&mut out, &format!("\n<title>{}</title>", escape(title)));
        line(
            &mut out,
            &format!(
                r#"<rect width="{width}" height="{height}" fill="{}"/>"#,
                Colour::WHITE.hex()
            ),
        );
        for mark in &self.marks {
            self.print(&mut out, mark)?;
        }
        line(&mut out, "</svg>");
        Ok(out)
    }

    fn print(&self, out: &mut String, mark: &Mark) -> Result<(), FigureError> {
        match mark {
            Mark::Line { points, stroke } => line(
                out,
                &format!(
                    r#"<path d="{}" fill="none"{}/>"#,
                    path(points),
                    stroked(stroke)
                ),
            ),
            Mark::Area {
                points,
                fill,
                opacity,
            } => line(
                out,
                &format!(
                    r#"<path d="{}Z" fill="{}" fill-opacity="{}"/>"#,
                    path(points),
                    fill.hex(),
                    round(*opacity)
                ),
            ),
            Mark::Discs { discs, .. } if discs.len() > MANY_DISCS => {
                let image = Scene {
                    marks: vec![mark.clone()],
                    ..*self
                };
                let png = STANDARD.encode(image.png(None)?);
                line(
                    out,
                    &format!(
                        r#"<image width="{}" height="{}" href="data:image/png;base64,{png}"/>"#,
                        round(self.width),
                        round(self.height)
                    ),
                );
            }
            Mark::Discs { discs, edge } => discs.iter().for_each(|d| disc(out, d, *edge)),
            Mark::Text(text) => print_text(out, text),
            Mark::Clipped { window, marks } => {
                // An inner svg shows nothing outside itself and, unlike a clip
                // path, needs no name that could clash with another figure's.
                let (x, y) = (round(window.left), round(window.top));
                let (w, h) = (round(window.width), round(window.height));
                line(
                    out,
                    &format!(
                        r#"<svg x="{x}" y="{y}" width="{w}" height="{h}" viewBox="{x} {y} {w} {h}">"#
                    ),
                );
                for mark in marks {
                    self.print(out, mark)?;
                }
                line(out, "</svg>");
            }
        }
        Ok(())
    }
}

fn line(out: &mut String, text: &str) {
    out.push_str(text);
    out.push('\n');
}

/// To a hundredth, in as few letters as it takes.
fn round(x: f64) -> f64 {
    // Adding zero turns -0 into 0, which is a letter shorter.
    (x * 100.0).round() / 100.0 + 0.0
}

fn path(points: &[[f64; 2]]) -> String {
    let mut out = String::with_capacity(12 * points.len());
    for (i, [x, y]) in points.iter().enumerate() {
        let letter = if i == 0 { 'M' } else { 'L' };
        // Writing to a string cannot fail.
        let _ = write!(out, "{letter}{} {}", round(*x), round(*y));
    }
    out
}

fn stroked(stroke: &Stroke) -> String {
    let mut out = format!(
        r#" stroke="{}" stroke-width="{}" stroke-linejoin="round""#,
        stroke.colour.hex(),
        round(stroke.width)
    );
    if stroke.dashed {
        let [dash, gap] = DASH.map(|d| round(d * stroke.width));
        out += &format!(r#" stroke-dasharray="{dash} {gap}""#);
    }
    out
}

fn disc(out: &mut String, disc: &Disc, edge: f64) {
    let [x, y] = disc.centre.map(round);
    // The rim lies inside: the circle keeps its size.
    let rim = edge * disc.radius;
    let radius = round(disc.radius - 0.5 * rim);
    let fill = disc.fill.hex();
    let stroke = if edge > 0.0 {
        let colour = disc.fill.darker(0.45).hex();
        format!(r#" stroke="{colour}" stroke-width="{}""#, round(rim))
    } else {
        String::new()
    };
    line(
        out,
        &format!(r#"<circle cx="{x}" cy="{y}" r="{radius}" fill="{fill}"{stroke}/>"#),
    );
}

fn print_text(out: &mut String, text: &Text) {
    let [x, y] = text.at.map(round);
    let anchor = match text.anchor {
        Anchor::Start => "start",
        Anchor::Middle => "middle",
        Anchor::End => "end",
    };
    let turn = if text.upright {
        format!(r#" transform="rotate(-90 {x} {y})""#)
    } else {
        String::new()
    };
    line(
        out,
        &format!(
            r#"<text x="{x}" y="{y}" font-size="{}" text-anchor="{anchor}"{turn}>{}</text>"#,
            round(text.size),
            escape(&text.content)
        ),
    );
}
