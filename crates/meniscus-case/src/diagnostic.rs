//! What is wrong with a case file, where, and what would be right.

use std::fmt;
use std::ops::Range;

use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};

/// How much it matters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Severity {
    /// The case cannot run.
    Error,
    /// The case runs, but perhaps not as meant.
    Warning,
}

/// One thing wrong with a case file.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnostic {
    /// How much it matters.
    pub severity: Severity,
    /// What is wrong, in one line.
    pub message: String,
    /// What was found at the place it points to.
    pub label: String,
    /// What would be right.
    pub help: Option<String>,
    /// The bytes of the file that it is about; none where it is about the file itself.
    pub span: Option<Range<usize>>,
}

/// Everything wrong with a case file, in the file's order.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnostics {
    name: String,
    source: String,
    list: Vec<Diagnostic>,
}

impl Diagnostics {
    pub(crate) fn new(name: &str, source: &str, mut list: Vec<Diagnostic>) -> Self {
        for diagnostic in &mut list {
            if let Some(span) = &mut diagnostic.span {
                // One line says where: the first of a long value.
                let start = source.floor_char_boundary(span.start);
                let end = source.ceil_char_boundary(span.end.max(start));
                let first_line = source[start..end].lines().next().map_or(0, str::len);
                *span = start..start + first_line;
            }
        }
        list.sort_by_key(|diagnostic| diagnostic.span.as_ref().map_or(0, |span| span.start));
        Self {
            name: name.into(),
            source: source.into(),
            list,
        }
    }

    /// One by one.
    pub fn iter(&self) -> impl Iterator<Item = &Diagnostic> {
        self.list.iter()
    }

    /// How many.
    pub fn len(&self) -> usize {
        self.list.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// Line and column of a diagnostic, both from 1, the column in characters.
    pub fn line_and_column(&self, diagnostic: &Diagnostic) -> Option<(usize, usize)> {
        let before = &self.source[..diagnostic.span.as_ref()?.start];
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        Some((
            before.matches('\n').count() + 1,
            before[line_start..].chars().count() + 1,
        ))
    }

    /// The text to print: each with its place as `file:line:column`, the line
    /// itself with the place underlined, and what would be right.
    pub fn render(&self, colour: bool) -> String {
        let renderer = if colour {
            Renderer::styled()
        } else {
            Renderer::plain()
        };
        let all: Vec<String> = self
            .list
            .iter()
            .map(|diagnostic| self.render_one(diagnostic, &renderer))
            .collect();
        all.join("\n\n")
    }

    fn render_one(&self, diagnostic: &Diagnostic, renderer: &Renderer) -> String {
        let level = match diagnostic.severity {
            Severity::Error => Level::ERROR,
            Severity::Warning => Level::WARNING,
        };
        let mut group =
            annotate_snippets::Group::with_title(level.primary_title(&diagnostic.message));
        if let Some(span) = &diagnostic.span {
            let here = AnnotationKind::Primary
                .span(span.clone())
                .label(&diagnostic.label);
            group = group.element(
                Snippet::source(&self.source)
                    .path(&self.name)
                    .annotation(here),
            );
        }
        if let Some(help) = &diagnostic.help {
            group = group.element(Level::HELP.message(help));
        }
        renderer.render(&[group])
    }
}

impl fmt::Display for Diagnostics {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.render(false))
    }
}

impl std::error::Error for Diagnostics {}

/// The name nearest to what was written, if one is near enough to be meant.
pub(crate) fn nearest<'a>(
    written: &str,
    names: impl IntoIterator<Item = &'a str>,
) -> Option<&'a str> {
    names
        .into_iter()
        .map(|name| {
            (
                strsim::jaro_winkler(&written.to_lowercase(), &name.to_lowercase()),
                name,
            )
        })
        .filter(|(likeness, _)| *likeness > 0.75)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, name)| name)
}
