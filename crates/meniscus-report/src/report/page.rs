//! Printing a report as HTML.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use super::{Report, ResultRow, escape};
use crate::figure::{Figure, FigureError};
use crate::movie::Movie;
use crate::number::{fixed, scaled_unit, significant, with_unit};

const STYLE: &str = include_str!("style.css");

/// A figure whose SVG is longer than this, bytes, stands in the page as PNG
/// where that is shorter.
const LONG_SVG: usize = 200_000;

/// The page of a report.
pub(super) fn print(report: &Report) -> Result<String, FigureError> {
    let title = escape(&report.title);
    let mut body = format!("<h1>{title}</h1>\n");
    if !report.summary.is_empty() {
        body += &format!("<p class=\"summary\">{}</p>\n", escape(&report.summary));
    }
    if !report.warnings.is_empty() {
        let items = report.warnings.iter();
        let items: String = items.map(|w| format!("<li>{}</li>\n", escape(w))).collect();
        body += &format!(
            "<aside class=\"warnings\" role=\"note\">\n<strong>Warnings</strong>\n<ul>\n{items}</ul>\n</aside>\n"
        );
    }
    if !report.results.is_empty() {
        body += &section("Results", &results(&report.results));
    }
    if !report.figures.is_empty() {
        let figures: Result<String, FigureError> = report.figures.iter().map(figure).collect();
        body += &section("Figures", &figures?);
    }
    if !report.movies.is_empty() {
        let movies: Result<String, FigureError> = report.movies.iter().map(movie).collect();
        body += &section("Movies", &movies?);
    }
    if !report.parameters.is_empty() {
        body += &section("What was run", &pairs(&report.parameters));
    }
    if !report.dimensionless.is_empty() {
        body += &section("Dimensionless numbers", &dimensionless(report));
    }
    if !report.run.is_empty() {
        body += &section("The run", &pairs(&report.run));
    }
    if !report.reproduce.is_empty() {
        let commands = escape(&report.reproduce.join("\n"));
        let block = format!("<pre><code>{commands}</code></pre>\n");
        body += &section("How to repeat it", &block);
    }
    Ok(format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n\
         <title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n\
         <body>\n<main>\n{body}</main>\n</body>\n</html>\n"
    ))
}

fn section(title: &str, content: &str) -> String {
    format!("<section>\n<h2>{title}</h2>\n{content}</section>\n")
}

/// A table in a box that scrolls by itself where the screen is narrow.
fn table(head: &[&str], rows: impl Iterator<Item = String>) -> String {
    let head: String = head
        .iter()
        .map(|h| format!("<th scope=\"col\">{h}</th>"))
        .collect();
    let rows: String = rows.map(|row| format!("<tr>{row}</tr>\n")).collect();
    format!(
        "<div class=\"scroll\"><table>\n<thead><tr>{head}</tr></thead>\n\
         <tbody>\n{rows}</tbody>\n</table></div>\n"
    )
}

fn results(rows: &[ResultRow]) -> String {
    let head = ["Quantity", "Reference", "Computed", "Difference"];
    table(
        &head,
        rows.iter().map(|row| {
            // One unit for both, so that they compare at a glance.
            let reference = row.reference.as_ref().map_or(0.0, |(_, value)| *value);
            let unit = scaled_unit(&row.unit, row.computed.abs().max(reference.abs()));
            let reference = match &row.reference {
                Some((source, value)) => format!(
                    "{} <span class=\"source\">{}</span>",
                    escape(&unit.value(*value, 4)),
                    escape(source)
                ),
                None => "–".to_owned(),
            };
            let computed = unit.uncertain(row.computed, row.uncertainty.unwrap_or(0.0));
            format!(
                "<th scope=\"row\">{}</th><td class=\"number\">{reference}</td>\
                 <td class=\"number computed\">{}</td><td class=\"number\">{}</td>",
                escape(&row.quantity),
                escape(&computed),
                escape(&difference(row))
            )
        }),
    )
}

/// The difference to the reference, relative to it where that is not zero.
fn difference(row: &ResultRow) -> String {
    let Some((_, reference)) = row.reference else {
        return "–".to_owned();
    };
    let difference = row.computed - reference;
    let sign = if difference > 0.0 { "+" } else { "" };
    if !difference.is_finite() {
        return "–".to_owned();
    }
    if reference == 0.0 {
        return format!("{sign}{}", with_unit(difference, &row.unit, 2));
    }
    let percent = 100.0 * difference / reference.abs();
    let decimals = if percent.abs() < 10.0 { 2 } else { 1 };
    format!("{sign}{} %", fixed(percent, decimals))
}

fn dimensionless(report: &Report) -> String {
    table(
        &["Number", "Value", "Compares"],
        report.dimensionless.iter().map(|(name, value, meaning)| {
            format!(
                "<th scope=\"row\">{}</th><td class=\"number\">{}</td><td>{}</td>",
                escape(name),
                escape(&significant(*value, 3)),
                escape(meaning)
            )
        }),
    )
}

fn pairs(pairs: &[(String, String)]) -> String {
    let rows = pairs.iter();
    let rows: String = rows
        .map(|(name, value)| {
            format!(
                "<div><dt>{}</dt><dd>{}</dd></div>\n",
                escape(name),
                escape(value)
            )
        })
        .collect();
    format!("<dl>\n{rows}</dl>\n")
}

fn movie(movie: &Movie) -> Result<String, FigureError> {
    let caption = escape(movie.caption());
    Ok(plate(
        movie.name(),
        &image(&movie.png()?, None, &caption),
        &caption,
    ))
}

fn figure(figure: &Figure) -> Result<String, FigureError> {
    let svg = figure.svg()?;
    let caption = escape(figure.caption());
    let mut picture = svg;
    if picture.len() > LONG_SVG {
        let image = image(&figure.png()?, Some(figure.size()), &caption);
        if image.len() < picture.len() {
            picture = image;
        }
    }
    Ok(plate(figure.name(), &picture, &caption))
}

/// A PNG file in the page itself.
fn image(png: &[u8], size: Option<(f64, f64)>, caption: &str) -> String {
    let size = size.map_or_else(String::new, |(width, height)| {
        format!("width=\"{width:.0}\" height=\"{height:.0}\" ")
    });
    let png = STANDARD.encode(png);
    format!("<img {size}alt=\"{caption}\" src=\"data:image/png;base64,{png}\">\n")
}

fn plate(name: &str, picture: &str, caption: &str) -> String {
    format!(
        "<figure id=\"{}\">\n<div class=\"plate\">{picture}</div>\n<figcaption>{caption}</figcaption>\n</figure>\n",
        escape(name)
    )
}
