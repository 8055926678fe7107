//! What it takes to be right: seconds at equal error.

use std::fmt::Write as _;

use meniscus_report::number::significant;

use super::cost::Cost;
use super::page::groups;
use super::score::{Cell, Score};

/// Tests that know how wrong they are, in per cent, and what they compute.
const TESTS: [(&str, &str, &str); 2] = [
    ("laplace", "pressure", "pressure of a drop brought to rest"),
    ("swing", "frequency", "frequency of four periods"),
];

/// The errors to be reached, in per cent.
const ERRORS: [f64; 3] = [3.0, 1.0, 0.5];

/// Seconds on one thread that runs take at the resolution where they are right to so much, by a straight
/// line through the logarithms of neighbouring resolutions.
pub fn time_to_solution(scores: &[Score], costs: &[Cost]) -> String {
    let mut rows = String::new();
    for (test, quantity, about) in TESTS {
        for dimension in [2, 3] {
            let chosen = (scores.iter())
                .filter(|s| s.test == test && s.quantity == quantity && s.dimension == dimension);
            for (model, scores) in groups(chosen, |score| score.model) {
                let Some(cost) =
                    (costs.iter()).find(|cost| cost.model == model && cost.dimension == dimension)
                else {
                    continue;
                };
                let points = points(&scores, cost);
                let cells = ERRORS.map(|error| time_at(&points, error)).join(" | ");
                let _ = writeln!(rows, "| {about}, {dimension}D | {model} | {cells} |");
            }
        }
    }
    if rows.is_empty() {
        return rows;
    }
    let heads = ERRORS.map(|error| format!("{error} %")).join(" | ");
    format!(
        "\n## Time to solution\n\nSeconds on one thread at the resolution where the worst of all starts is right \
         to so much: the cost of a step for a particle, below, times particles and steps, between the resolutions \
         that were run. \"Not reached\": at none of them.\n\n| | model | {heads} |\n|---|---|---|---|---|\n{rows}"
    )
}

/// Error, and time in s, of each resolution, from coarse to fine.
fn points(scores: &[&Score], cost: &Cost) -> Vec<(f64, f64)> {
    let mut cells = groups(scores.iter().copied(), |score| score.resolution);
    cells.sort_by_key(|(resolution, _)| *resolution);
    (cells.into_iter())
        .filter_map(|(_, cell)| {
            let work = (cell.iter())
                .map(|score| score.particles as f64 * score.steps as f64)
                .fold(0.0, f64::max);
            Some((Cell(cell).worst()?.abs(), work * cost.nanoseconds * 1e-9))
        })
        .collect()
}

/// The time, s, at which errors that fall with it reach `error` and stay below.
fn time_at(points: &[(f64, f64)], error: f64) -> String {
    match (points, points.iter().rposition(|point| point.0 > error)) {
        ([], _) => "–".into(),
        ([first, ..], None) => format!("at most {}", significant(first.1, 2)),
        (_, Some(above)) => points.get(above + 1).map_or_else(
            || "not reached".into(),
            |below| {
                let above = points[above];
                let share = (above.0 / error).ln() / (above.0 / below.0).ln();
                significant(above.1 * (below.1 / above.1).powf(share), 2)
            },
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::time_at;

    #[test]
    fn time_to_an_error_lies_between_the_runs_around_it() {
        let points = [(4.0, 1.0), (1.0, 16.0)];
        assert_eq!(time_at(&points, 2.0), "4.0");
        assert_eq!(time_at(&points, 5.0), "at most 1.0");
        assert_eq!(time_at(&points, 0.5), "not reached");
        assert_eq!(time_at(&[], 0.5), "–");
        // Right by chance at a coarse resolution is not right.
        assert_eq!(time_at(&[(1.0, 1.0), (4.0, 4.0), (1.0, 16.0)], 2.0), "8.0");
    }
}
