//! The comparison as a page of Markdown.

use std::fmt::Write as _;

use meniscus_report::number::significant;

use super::advice::advice;
use super::cost::Cost;
use super::score::{Cell, Score, order};
use super::suite::ABOUT;
use super::time_to_solution::time_to_solution;
use crate::table::capital;

/// Everything that the page tells.
pub struct Page<'a> {
    /// The command that made it.
    pub command: &'a str,
    /// All numbers.
    pub scores: &'a [Score],
    /// What steps cost.
    pub costs: &'a [Cost],
    /// Files and captions of figures.
    pub figures: &'a [(String, String)],
}

/// Items under their keys, in the order in which keys first appear.
pub fn groups<T: Copy, K: PartialEq>(
    items: impl Iterator<Item = T>,
    key: impl Fn(T) -> K,
) -> Vec<(K, Vec<T>)> {
    let mut found: Vec<(K, Vec<T>)> = Vec::new();
    for item in items {
        let k = key(item);
        match found.iter_mut().find(|(known, _)| *known == k) {
            Some((_, group)) => group.push(item),
            None => found.push((k, vec![item])),
        }
    }
    found
}

impl Page<'_> {
    /// The page.
    pub fn markdown(&self) -> String {
        let mut page = format!(
            "# Accuracy of the models\n\nMade by `{}`, version {}.\n\n\
             Every model runs with the settings that a user gets who names it in a case file, in flows whose \
             density, surface tension and radius are one; each run is a case file under `runs/`. Zero is right \
             in all tables. A number is the worst of all starts: a lattice, the lattice turned, and lattices \
             jittered by up to a tenth of a spacing. In bold: below the bar that the project sets itself.\n",
            self.command,
            env!("CARGO_PKG_VERSION"),
        );
        page += &advice(self.scores);
        for (test, of_test) in groups(self.scores.iter(), |score| score.test) {
            let _ = write!(page, "\n## {}\n", capital(test));
            if let Some((_, about)) = ABOUT.iter().find(|(name, _)| *name == test) {
                let _ = write!(page, "\n{about}\n");
            }
            for (quantity, scores) in groups(of_test.into_iter(), |score| score.quantity) {
                page += &table(quantity, &scores);
            }
        }
        page += &self.failures();
        page += &time_to_solution(self.scores, self.costs);
        page += &self.cost();
        for (file, caption) in self.figures {
            let _ = write!(page, "\n![{caption}](figures/{file})\n");
        }
        page
    }

    fn failures(&self) -> String {
        let failed = self.scores.iter().filter(|score| score.failure.is_some());
        let runs = groups(failed, |score| (&score.run, score.failure.as_deref()));
        if runs.is_empty() {
            return String::new();
        }
        let mut text = String::from("\n## Runs without a number\n\n");
        for ((run, reason), _) in runs {
            let _ = writeln!(text, "- {run}: {}", reason.unwrap_or_default());
        }
        text
    }

    fn cost(&self) -> String {
        let mut text = String::from(
            "\n## Cost of a step\n\nOn one thread, in turn with the same drop without surface tension.\n\n\
             | model | 2D, ns/particle | over plain | 3D, ns/particle | over plain |\n|---|---|---|---|---|\n",
        );
        for (model, costs) in groups(self.costs.iter(), |cost| cost.model) {
            let of = |dimension: usize| {
                costs
                    .iter()
                    .find(|cost| cost.dimension == dimension)
                    .map_or_else(
                        || "– | –".to_owned(),
                        |cost| {
                            format!(
                                "{} | {}",
                                significant(cost.nanoseconds, 3),
                                significant(cost.over_plain, 3)
                            )
                        },
                    )
            };
            let _ = writeln!(text, "| {model} | {} | {} |", of(2), of(3));
        }
        text
    }
}

/// One number of one test: models below one another, resolutions side by side.
fn table(quantity: &str, scores: &[&Score]) -> String {
    let unit = scores[0].unit;
    let columns = groups(scores.iter().copied(), |s| (s.dimension, s.resolution));
    let mut columns: Vec<(usize, u32)> = columns.into_iter().map(|(key, _)| key).collect();
    columns.sort_unstable();
    let shown = if unit.is_empty() {
        String::new()
    } else {
        format!(", {unit}")
    };
    let mut text = format!("\n{}{shown}\n\n| model |", capital(quantity));
    let variants = scores.iter().any(|score| !score.variant.is_empty());
    if variants {
        text += " |";
    }
    for (dimension, resolution) in &columns {
        let _ = write!(text, " {dimension}D, R/dx = {resolution} |");
    }
    let ordered: Vec<usize> = [2, 3]
        .into_iter()
        .filter(|dimension| {
            let runs = columns.iter().filter(|(d, _)| d == dimension).count();
            ["%", "deg"].contains(&unit) && runs > 1
        })
        .collect();
    for dimension in &ordered {
        let _ = write!(text, " order {dimension}D |");
    }
    let count = 1 + usize::from(variants) + columns.len() + ordered.len();
    let _ = writeln!(text, "\n|{}", "---|".repeat(count));
    let rows = groups(scores.iter().copied(), |s| (s.model, s.variant.as_str()));
    for ((model, variant), of_row) in rows {
        let _ = write!(text, "| {model} |");
        if variants {
            let _ = write!(text, " {variant} |");
        }
        let mut errors: Vec<(usize, u32, f64)> = Vec::new();
        for &(dimension, resolution) in &columns {
            let chosen = |s: &&&Score| s.dimension == dimension && s.resolution == resolution;
            let cell = Cell(of_row.iter().filter(chosen).copied().collect());
            if let Some(worst) = cell.worst() {
                errors.push((dimension, resolution, worst));
            }
            let _ = write!(text, " {} |", shown_cell(&cell));
        }
        for dimension in &ordered {
            let of = |e: &&(usize, u32, f64)| e.0 == *dimension;
            let errors: Vec<(u32, f64)> = errors.iter().filter(of).map(|e| (e.1, e.2)).collect();
            let order = order(&errors).map_or_else(|| "–".into(), |p| significant(p, 2));
            let _ = write!(text, " {order} |");
        }
        text.push('\n');
    }
    text
}

fn shown_cell(cell: &Cell<'_>) -> String {
    let (failed, runs) = cell.failed();
    match (cell.worst(), runs) {
        (_, 0) => String::new(),
        (None, _) => format!("{failed} of {runs} failed"),
        (Some(worst), _) => {
            let value = significant(worst, 2);
            if cell.met() == Some(true) {
                format!("**{value}**")
            } else {
                value
            }
        }
    }
}

/// A number and its unit, in words.
pub fn with_unit(value: f64, unit: &str) -> String {
    let value = significant(value, 2);
    match unit {
        "" => value,
        "deg" => format!("{value} degrees"),
        unit => format!("{value} {unit}"),
    }
}
