//! A number of a paper beside ours, and what to think of it.

use meniscus_report::number::significant;
use serde::Serialize;

use crate::reproduce::Number;
use crate::table::{signed, table};

/// What to think of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// Within the tolerance.
    Reproduced,
    /// Outside it.
    Differs,
    /// Outside it, for a reason that is known.
    KnownToDiffer,
    /// There is nothing to compare with.
    Shown,
    /// The case gave no value.
    NotComputed,
}

/// One line of the answer.
#[derive(Debug, Serialize)]
pub struct Row {
    id: String,
    #[serde(skip)]
    about: String,
    published: Option<f64>,
    theory: Option<f64>,
    computed: Option<f64>,
    uncertainty: Option<f64>,
    tolerance: f64,
    /// Why it differs, if that is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<String>,
    /// What to think of it.
    pub verdict: Verdict,
}

impl Row {
    /// Compares the value computed, with its uncertainty, if there is one.
    pub fn judge(number: &Number, found: Option<(f64, Option<f64>)>) -> Self {
        let computed = found.map(|(value, _)| value);
        let verdict = match (computed, number.published.or(number.theory)) {
            (None, _) => Verdict::NotComputed,
            (Some(_), None) => Verdict::Shown,
            (Some(value), Some(right)) if (value - right).abs() <= number.tolerance => {
                Verdict::Reproduced
            }
            _ if number.differs.is_some() => Verdict::KnownToDiffer,
            _ => Verdict::Differs,
        };
        Self {
            id: number.id.clone(),
            about: number.about.clone(),
            published: number.published,
            theory: number.theory,
            computed,
            uncertainty: found.and_then(|(_, half)| half),
            tolerance: number.tolerance,
            reason: (number.differs.clone()).filter(|_| verdict == Verdict::KnownToDiffer),
            verdict,
        }
    }
}

impl Row {
    /// What to say about a number that is known to differ.
    pub fn known_difference(&self) -> Option<String> {
        let reason = self.reason.as_ref()?;
        Some(format!("{}: {reason}", self.about))
    }
}

/// The answer for people.
pub fn rows_as_table(rows: &[Row]) -> String {
    let dash = || "–".to_owned();
    let cells = |row: &Row| {
        let shown = |value: Option<f64>| value.map_or_else(dash, |v| significant(v, 4));
        let places = |value: Option<f64>| value.map_or_else(dash, |v| format!("{v:.4}"));
        let beside = |right: Option<f64>| match (row.computed, right) {
            (Some(value), Some(right)) => signed(value - right, 3),
            _ => dash(),
        };
        vec![
            row.about.clone(),
            shown(row.published),
            shown(row.theory),
            places(row.computed),
            places(row.uncertainty),
            beside(row.published),
            beside(row.theory),
            significant(row.tolerance, 2),
            match row.verdict {
                Verdict::Reproduced => "reproduced",
                Verdict::Differs => "differs",
                Verdict::KnownToDiffer => "differs, see below",
                Verdict::Shown => "shown",
                Verdict::NotComputed => "not computed",
            }
            .to_owned(),
        ]
    };
    let header = [
        "number",
        "published",
        "theory",
        "computed",
        "±",
        "to published",
        "to theory",
        "tolerance",
        "verdict",
    ];
    table(&header, &rows.iter().map(cells).collect::<Vec<_>>())
}
