//! The report of a run: one page that needs nothing beside it.
//!
//! [`Report`] collects what is to be told; `page` prints it as HTML with its
//! style and pictures inside.

mod page;

use crate::figure::{Figure, FigureError};
use crate::movie::Movie;

/// A line of the table of results.
#[derive(Clone, Debug, PartialEq)]
pub struct ResultRow {
    /// What was measured.
    pub quantity: String,
    /// Its plain unit, as in `N/m`; empty for a plain number.
    pub unit: String,
    /// What it is compared with: where that comes from ("given", "Rayleigh
    /// (1879)"), and its value.
    pub reference: Option<(String, f64)>,
    /// The value computed.
    pub computed: f64,
    /// Half width of its 95 % interval, where one is known.
    pub uncertainty: Option<f64>,
}

/// A report in the making.
#[derive(Clone, Debug, Default)]
pub struct Report {
    title: String,
    summary: String,
    warnings: Vec<String>,
    results: Vec<ResultRow>,
    figures: Vec<Figure>,
    movies: Vec<Movie>,
    parameters: Vec<(String, String)>,
    dimensionless: Vec<(String, f64, String)>,
    run: Vec<(String, String)>,
    reproduce: Vec<String>,
}

impl Report {
    /// A report with nothing but its title.
    pub fn new(title: &str) -> Self {
        Report {
            title: title.to_owned(),
            ..Self::default()
        }
    }

    /// The answer in a sentence or two, right below the title.
    pub fn summary(mut self, text: &str) -> Self {
        self.summary = text.to_owned();
        self
    }

    /// Adds something the reader must know before trusting the numbers.
    pub fn warning(mut self, text: &str) -> Self {
        self.warnings.push(text.to_owned());
        self
    }

    /// Adds a line of the table of results.
    pub fn result(mut self, row: ResultRow) -> Self {
        self.results.push(row);
        self
    }

    /// Adds a moving picture.
    pub fn movie(mut self, movie: Movie) -> Self {
        self.movies.push(movie);
        self
    }

    /// Adds a figure.
    pub fn figure(mut self, figure: Figure) -> Self {
        self.figures.push(figure);
        self
    }

    /// Adds a parameter of the case, its value with unit as the user reads it.
    pub fn parameter(mut self, name: &str, value: &str) -> Self {
        self.parameters.push((name.to_owned(), value.to_owned()));
        self
    }

    /// Adds a dimensionless number with what it compares.
    pub fn dimensionless(mut self, name: &str, value: f64, meaning: &str) -> Self {
        let row = (name.to_owned(), value, meaning.to_owned());
        self.dimensionless.push(row);
        self
    }

    /// Adds a line about the run itself: version, seed, machine, timings.
    pub fn run_information(mut self, name: &str, value: &str) -> Self {
        self.run.push((name.to_owned(), value.to_owned()));
        self
    }

    /// Adds a command that repeats the run.
    pub fn reproduce(mut self, command: &str) -> Self {
        self.reproduce.push(command.to_owned());
        self
    }

    /// The figures, to be written as files too.
    pub fn figures(&self) -> &[Figure] {
        &self.figures
    }

    /// The moving pictures, to be written as files too.
    pub fn movies(&self) -> &[Movie] {
        &self.movies
    }

    /// The page.
    ///
    /// Fails where a figure cannot be drawn.
    pub fn html(&self) -> Result<String, FigureError> {
        page::print(self)
    }
}

/// Text as it stands in HTML, XML and their attributes.
pub(crate) fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            // XML has no place for other control characters, not even escaped.
            _ if letter.is_control() && !letter.is_whitespace() => out.push('\u{fffd}'),
            _ => out.push(letter),
        }
    }
    out
}
