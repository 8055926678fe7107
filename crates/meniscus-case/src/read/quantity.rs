//! Numbers with their units, and vectors of them.

use serde_json::json;
use toml::de::DeValue;

use super::echo::Echo;
use super::node::{Input, Node};
use crate::units::{self, Kind, QuantityError};

/// Which values a number may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sign {
    Any,
    Positive,
    NotNegative,
}

impl Node<'_> {
    /// A bare number.
    pub(crate) fn number(&mut self, sign: Sign) -> f64 {
        self.quantity(&units::NUMBER, sign)
    }

    /// A number with its unit, in SI; NaN where it is wrong.
    pub(crate) fn quantity(&mut self, kind: &Kind, sign: Sign) -> f64 {
        let is_number = *kind == units::NUMBER;
        self.schema = if is_number {
            json!({ "type": "number" })
        } else {
            json!({ "type": ["string", "number"], "examples": [kind.example] })
        };
        match sign {
            Sign::Any => {}
            Sign::Positive => self.schema["exclusiveMinimum"] = json!(0),
            Sign::NotNegative => self.schema["minimum"] = json!(0),
        }
        self.example = example(kind);
        let (value, written) = match self.input {
            Input::Value(DeValue::Integer(integer)) if integer.radix() == 10 => {
                self.echo = Echo::Leaf(integer.to_string());
                (
                    integer.as_str().parse().unwrap_or(f64::NAN),
                    integer.to_string(),
                )
            }
            Input::Value(DeValue::Float(float)) => {
                self.echo = Echo::Leaf(float.to_string());
                (
                    float.as_str().parse().unwrap_or(f64::NAN),
                    float.to_string(),
                )
            }
            Input::Value(DeValue::String(text)) if !is_number => {
                self.echo = Echo::text(text);
                match self.parse(text) {
                    Ok(found) if found.dimension == kind.dimension => {
                        (found.value, text.to_string())
                    }
                    Ok(found) => {
                        self.wrong_unit(kind, text, found.dimension);
                        return f64::NAN;
                    }
                    Err(error) => {
                        self.unreadable(kind, text, error);
                        return f64::NAN;
                    }
                }
            }
            Input::Value(DeValue::String(text)) => {
                self.fail(
                    format!("`{}` is a bare number", self.name),
                    format!("\"{text}\" is a string"),
                    "write it without quotes and without a unit",
                );
                return f64::NAN;
            }
            _ => {
                let kind = units::with_article(kind.name);
                self.wrong_type(&if is_number {
                    kind
                } else {
                    format!("{kind} with its unit")
                });
                return f64::NAN;
            }
        };
        self.bounded(value, sign, &written)
    }

    fn bounded(&self, value: f64, sign: Sign, written: &str) -> f64 {
        let right = match sign {
            _ if !value.is_finite() => "a finite number",
            Sign::Positive if value <= 0.0 => "more than zero",
            Sign::NotNegative if value < 0.0 => "zero or more",
            _ => return value,
        };
        let label = format!("must be {right}");
        self.fail(
            format!("`{}` is {written}", self.name),
            label,
            format!("for example {}", self.example),
        );
        f64::NAN
    }

    fn wrong_unit(&self, kind: &Kind, text: &str, found: units::Dimension) {
        let wanted = units::with_article(kind.name);
        let label = if found == units::NUMBER.dimension {
            "this has no unit".to_string()
        } else {
            format!("this is {}", units::name_of(found))
        };
        self.fail(
            format!("`{}` must be {wanted}, found \"{text}\"", self.name),
            label,
            format!("write {wanted} with its unit, such as {}", self.example),
        );
    }

    fn parse(&self, text: &str) -> Result<units::Quantity, QuantityError> {
        // A wrong spacing has been reported where it stands.
        units::parse(
            text,
            self.context
                .spacing
                .get()
                .map(|dx| if dx.is_nan() { 1.0 } else { dx }),
        )
    }

    fn would_be(&self, text: &str, kind: &Kind) -> bool {
        self.parse(text)
            .is_ok_and(|found| found.dimension == kind.dimension)
    }

    fn unreadable(&self, kind: &Kind, text: &str, error: QuantityError) {
        let wanted = units::with_article(kind.name);
        let example = format!("write {wanted} with its unit, such as {}", self.example);
        let (label, help) = match error {
            QuantityError::Number => ("does not start with a number".into(), example),
            QuantityError::NotFinite => ("not a finite number".into(), example),
            QuantityError::Unit { found, nearest } => (
                format!("unknown unit `{found}`"),
                nearest
                    .filter(|nearest| self.would_be(&text.replacen(&found, nearest, 1), kind))
                    .map_or(example, |nearest| format!("did you mean `{nearest}`?")),
            ),
            QuantityError::Syntax(rest) if rest.starts_with(',') => {
                ("a decimal comma".into(), "write a decimal point".into())
            }
            QuantityError::Syntax(rest) => (format!("cannot read `{rest}`"), example),
            QuantityError::Spacing => (
                "`dx` is the spacing itself".into(),
                "give the spacing as a length, such as \"0.05 mm\"".into(),
            ),
        };
        self.fail(
            format!("`{}` must be {wanted}, found \"{text}\"", self.name),
            label,
            help,
        );
    }

    /// As many quantities as space has dimensions; the rest are zero.
    pub(crate) fn vector(&mut self, kind: &Kind, sign: Sign) -> [f64; 3] {
        let values = self.list(0, |node| node.quantity(kind, sign));
        let dimension = self.context.dimension.get();
        self.schema["minItems"] = json!(2);
        self.schema["maxItems"] = json!(3);
        self.example = format!(
            "[{}]",
            vec![example(kind); dimension.unwrap_or(2)].join(", ")
        );
        let fits = dimension.map_or(2..=3, |dimension| dimension..=dimension);
        if self.is_list() && !fits.contains(&values.len()) {
            let plural = if values.len() == 1 { "" } else { "s" };
            self.fail(
                format!("`{}` has {} component{plural}", self.name, values.len()),
                format!(
                    "this case has {} dimensions",
                    dimension.map_or("2 or 3".into(), |d| d.to_string())
                ),
                format!("for example {}", self.example),
            );
        }
        let rest = if values.is_empty() { f64::NAN } else { 0.0 };
        std::array::from_fn(|d| values.get(d).copied().unwrap_or(rest))
    }
}

/// A quantity of this kind as TOML.
fn example(kind: &Kind) -> String {
    if *kind == units::NUMBER {
        kind.example.into()
    } else {
        format!("\"{}\"", kind.example)
    }
}
