//! Which model for which flow.

use std::fmt::Write as _;

use super::page::{groups, with_unit};
use super::score::{Cell, Score};

/// What flows ask for, and the number that tells.
const FLOWS: [(&str, &str, &str); 14] = [
    ("pressure in a drop at rest", "laplace", "pressure"),
    (
        "a drop at rest that must stay at rest",
        "parasitic currents",
        "speed",
    ),
    ("a drop that swings", "swing", "frequency"),
    (
        "a drop that becomes round",
        "square to round",
        "deviation of the radius, in spacings",
    ),
    ("a drop on a flat wall", "cap", "contact angle"),
    (
        "a drop on a round wall",
        "cap on a round wall",
        "contact angle",
    ),
    (
        "a drop on a wall, of little weight",
        "cap under slight weight",
        "change of the wetted radius, over what weight and noise allow",
    ),
    ("a puddle", "puddle", "height"),
    ("rise between plates", "rise between plates", "height"),
    (
        "drops that merge",
        "two drops merge",
        "largest change of density",
    ),
    (
        "many drops",
        "five drops apart",
        "largest drift of one drop",
    ),
    (
        "a thread that breaks",
        "thread breaks",
        "radius of the neck",
    ),
    (
        "a thread on the way",
        "thread breaks",
        "largest change of density",
    ),
    ("a splash", "splash", "largest change of density"),
];

/// How a model did in a flow.
struct Place<'a> {
    model: &'a str,
    failed: usize,
    runs: usize,
    worst: f64,
    unit: &'a str,
}

impl Place<'_> {
    fn shown(&self) -> String {
        let value = if self.worst.is_finite() {
            with_unit(self.worst, self.unit)
        } else {
            "no number".to_owned()
        };
        match self.failed {
            0 => format!("{} ({value})", self.model),
            failed => format!("{} ({value}; {failed} of {} failed)", self.model, self.runs),
        }
    }
}

/// The table: the most exact, and the next. A model that fails in some runs stands behind those that do not.
pub fn advice(scores: &[Score]) -> String {
    let mut text = String::from(
        "\n## Which model for which flow\n\nBy the worst number of each model over all starts and \
         variants, at its finest resolution; models with runs without a number come after those with none.\n\n\
         | flow | by | 2D: most exact | next | 3D: most exact | next |\n|---|---|---|---|---|---|\n",
    );
    for (flow, test, quantity) in FLOWS {
        let chosen: Vec<&Score> = (scores.iter())
            .filter(|s| s.test == test && s.quantity == quantity)
            .collect();
        if chosen.is_empty() {
            continue;
        }
        let _ = write!(text, "| {flow} | {quantity} |");
        for dimension in [2, 3] {
            let ranks = ranks(chosen.iter().filter(|s| s.dimension == dimension).copied());
            for rank in 0..2 {
                let shown = ranks.get(rank).map_or_else(|| "–".to_owned(), Place::shown);
                let _ = write!(text, " {shown} |");
            }
        }
        text.push('\n');
    }
    text
}

/// The models in the order of their errors.
fn ranks<'a>(scores: impl Iterator<Item = &'a Score>) -> Vec<Place<'a>> {
    let mut ranks: Vec<Place<'_>> = groups(scores, |score| score.model)
        .into_iter()
        .filter_map(|(model, scores)| {
            let finest = scores.iter().map(|score| score.resolution).max()?;
            let cell = Cell(
                (scores.into_iter())
                    .filter(|s| s.resolution == finest)
                    .collect(),
            );
            let (failed, runs) = cell.failed();
            let values = cell.0.iter().filter_map(|score| score.value);
            Some(Place {
                model,
                failed,
                runs,
                worst: values.map(f64::abs).reduce(f64::max).unwrap_or(f64::NAN),
                unit: cell.0[0].unit,
            })
        })
        .collect();
    let share = |place: &Place<'_>| place.failed as f64 / place.runs as f64;
    ranks.sort_by(|a, b| (share(a).total_cmp(&share(b))).then_with(|| a.worst.total_cmp(&b.worst)));
    ranks
}

#[cfg(test)]
mod tests {
    use super::*;

    fn score(model: &'static str, resolution: u32, value: Option<f64>) -> Score {
        Score {
            run: String::new(),
            test: "splash",
            quantity: "largest change of density",
            unit: "%",
            model,
            dimension: 2,
            resolution,
            variant: String::new(),
            start: String::new(),
            value,
            bar: None,
            failure: None,
            particles: 0,
            steps: 0,
        }
    }

    #[test]
    fn models_that_fail_come_after_those_that_do_not() {
        let scores = [
            score("a", 10, Some(0.1)),
            score("a", 10, None),
            score("b", 10, Some(-3.0)),
            score("c", 7, Some(0.0)),
            score("c", 10, Some(2.0)),
            score("d", 10, None),
        ];
        let text = advice(&scores);
        assert!(
            text.ends_with(
                "| a splash | largest change of density | c (2.0 %) | b (3.0 %) | – | – |\n"
            ),
            "{text}"
        );
        let order: Vec<_> = ranks(scores.iter()).iter().map(Place::shown).collect();
        assert_eq!(
            order[2..],
            ["a (0.10 %; 1 of 2 failed)", "d (no number; 1 of 1 failed)"]
        );
    }
}
