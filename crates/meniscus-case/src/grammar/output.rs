//! What is written and measured.

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
}

/// What is measured beside the usual time series.
#[derive(Clone, Debug, PartialEq)]
pub struct Measure {
    /// The fit of a damped oscillation.
    pub oscillation: Option<Oscillation>,
    /// The pressure inside a drop at rest.
    pub static_pressure: Option<StaticPressure>,
    /// Whether the largest extent of the first body, and the time until it is back, are read off.
    pub extremes: bool,
    /// Pressure sensors.
    pub sensors: Vec<Sensor>,
    /// Places where the curvature of the surface is read.
    pub curvature: Vec<Sensor>,
}

/// A damped cosine fitted to the semi-axes; its frequency gives the surface tension.
#[derive(Clone, Debug, PartialEq)]
pub struct Oscillation {
    /// Number of lobes of the mode; 2 is the ellipse.
    pub mode: u32,
    /// Start of the fit, s.
    pub from: f64,
    /// End of the fit, s.
    pub to: f64,
}

/// Time-averaged pressure inside a drop at rest; by Laplace it gives the surface tension.
#[derive(Clone, Debug, PartialEq)]
pub struct StaticPressure {
    /// Start of the average, s.
    pub from: f64,
    /// End of the average, s.
    pub to: f64,
}

/// A place where something is read.
#[derive(Clone, Debug, PartialEq)]
pub struct Sensor {
    /// Its name in the time series.
    pub name: String,
    /// Where it is, m; in 2D the third component is zero.
    pub at: [f64; 3],
}

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

pub(super) fn measure(node: &mut Node<'_>, end_time: f64) -> Measure {
    node.table(|fields| Measure {
        oscillation: fields.optional(
            "oscillation",
            "Fit a damped cosine to the semi-axes, and find the surface tension from its frequency.",
            |node| {
                node.table(|fields| {
                    let about = "Number of lobes of the mode; 2 is the ellipse.";
                    let mode = fields.or("mode", "2", about, |node| node.whole(2..=16) as u32);
                    let (from, to) = window(fields, end_time, 0.0);
                    Oscillation { mode, from, to }
                })
            },
        ),
        static_pressure: fields.optional(
            "static_pressure",
            "Average the pressure inside a drop at rest, and find the surface tension from it.",
            |node| {
                node.table(|fields| {
                    let (from, to) = window(fields, end_time, 0.8);
                    StaticPressure { from, to }
                })
            },
        ),
        extremes: fields
            .optional(
                "extremes",
                "Read off how far the first body reaches along x at most, and when it is back: for large swings.",
                |node| node.table(|_| ()),
            )
            .is_some(),
        sensors: fields.or("sensors", "[]", "Pressure sensors.", sensors),
        curvature: fields.or(
            "curvature",
            "[]",
            "Places where the curvature of the surface is read, from the nearest particle.",
            sensors,
        ),
    })
}

/// A part of the run: from a share of the end time to its end.
fn window(fields: &mut Fields<'_, '_>, end_time: f64, share: f64) -> (f64, f64) {
    let from = instant(
        fields,
        "from",
        "When it starts.",
        end_time,
        end_time * share,
        f64::NEG_INFINITY,
    );
    let to = instant(
        fields,
        "to",
        "When it ends. Default: end_time.",
        end_time,
        end_time,
        from,
    );
    (from, to)
}

fn instant(
    fields: &mut Fields<'_, '_>,
    key: &'static str,
    about: &str,
    end_time: f64,
    default: f64,
    after: f64,
) -> f64 {
    let read = |node: &mut Node<'_>| {
        let time = node.quantity(&units::TIME, Sign::NotNegative);
        if time > end_time * (1.0 + 1e-9) {
            node.fail(
                format!("`{key}` is {time} s"),
                "after the end of the run",
                format!("end_time is {end_time} s"),
            );
            return f64::NAN;
        }
        if time <= after {
            node.fail(
                format!("`{key}` is {time} s"),
                "not after `from`",
                format!("`from` is {after} s"),
            );
        }
        time
    };
    if end_time.is_nan() {
        return fields.optional(key, about, read).unwrap_or(f64::NAN);
    }
    fields.or(key, &format!("'{default} s'"), about, read)
}

fn sensors(node: &mut Node<'_>) -> Vec<Sensor> {
    let sensors = node.list(0, sensor);
    for (i, sensor) in sensors.iter().enumerate() {
        if sensors[..i].iter().any(|other| other.name == sensor.name) {
            let message = format!("two sensors are called \"{}\"", sensor.name);
            node.fail(
                message,
                "a name stands twice",
                "give each sensor a name of its own",
            );
        }
    }
    sensors
}

fn sensor(node: &mut Node<'_>) -> Sensor {
    node.table(|fields| Sensor {
        name: fields.required("name", "Its name in the time series.", |node| node.text()),
        at: fields.required("at", "Where it is.", |node| {
            node.vector(&units::LENGTH, Sign::Any)
        }),
    })
}
