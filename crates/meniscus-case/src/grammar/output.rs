//! How often results are written.

use crate::read::{Fields, Node, Sign};
use crate::units;

/// How often results are written, s.
#[derive(Clone, Debug, PartialEq)]
pub struct Output {
    /// Time between frames, which hold all particles.
    pub frames: f64,
    /// Time between lines of the time series.
    pub series: f64,
    /// Time between checkpoints, from which a run can go on.
    pub checkpoints: f64,
    /// Times that the pictures of a report show, s; none for evenly spread ones.
    pub pictures: Vec<f64>,
    /// What colours the particles of a moving picture, if one is wanted.
    pub movie: Option<&'static str>,
}

/// Fields of the frames that can colour a movie.
const MOVIES: [&str; 6] = [
    "pressure",
    "speed",
    "density",
    "temperature",
    "fluid",
    "body",
];

pub(super) fn output(node: &mut Node<'_>, end_time: f64) -> Output {
    node.table(|fields| Output {
        frames: time(
            fields,
            "frames",
            "Time between frames. Default: a hundredth of end_time.",
            end_time,
            0.01,
        ),
        series: time(
            fields,
            "series",
            "Time between lines of the time series. Default: a thousandth of end_time.",
            end_time,
            0.001,
        ),
        checkpoints: time(
            fields,
            "checkpoints",
            "Time between checkpoints. Default: a tenth of end_time.",
            end_time,
            0.1,
        ),
        pictures: fields
            .optional(
                "pictures",
                "Times that the pictures of the report show. Default: six, evenly spread.",
                |node| node.list(1, |node| node.quantity(&units::TIME, Sign::NotNegative)),
            )
            .unwrap_or_default(),
        movie: fields.optional(
            "movie",
            "A moving picture of the frames, coloured by this.",
            |node| node.name_of("field", &MOVIES.map(|name| (name, name))),
        ),
    })
}

/// An interval whose default is a share of the end time.
fn time(
    fields: &mut Fields<'_, '_>,
    key: &'static str,
    about: &str,
    end_time: f64,
    share: f64,
) -> f64 {
    let read = |node: &mut Node<'_>| node.quantity(&units::TIME, Sign::Positive);
    // A share of a wrong end time would be a second complaint about one mistake.
    if end_time.is_nan() {
        return fields.optional(key, about, read).unwrap_or(f64::NAN);
    }
    fields.or(key, &format!("'{} s'", end_time * share), about, read)
}
