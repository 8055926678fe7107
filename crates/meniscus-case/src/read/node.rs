//! A place in the tree, and the plain values that it may hold.

use std::cell::{Cell, RefCell};
use std::ops::Range;

use serde_json::{Map, Value, json};
use toml::Spanned;
use toml::de::DeValue;

use super::echo::Echo;
use super::fields::Fields;
use crate::diagnostic::{Diagnostic, Severity};
use crate::units::{self, Kind, QuantityError};

/// What all nodes of a walk share.
#[derive(Default)]
pub(crate) struct Context {
    pub diagnostics: RefCell<Vec<Diagnostic>>,
    /// Whether the walk is made without a file, for the schema.
    pub describing: bool,
    /// What `dx` stands for; NaN where the file's is wrong.
    pub spacing: Cell<Option<f64>>,
    /// Dimensions of space; none where the file's is wrong.
    pub dimension: Cell<Option<usize>>,
    /// Parts of the schema that others refer to.
    pub definitions: RefCell<Map<String, Value>>,
}

impl Context {
    pub(crate) fn error(&self, span: Range<usize>, message: String, label: String, help: Option<String>) {
        let span = Some(span);
        let severity = Severity::Error;
        self.diagnostics.borrow_mut().push(Diagnostic { severity, message, label, help, span });
    }
}

/// What a node was given.
#[derive(Clone, Copy)]
pub(super) enum Input<'n> {
    /// Nothing is known: the file is wrong here, or there is no file.
    Unknown,
    /// A choice was named without anything more.
    Named,
    Value(&'n DeValue<'n>),
}

/// Which values a number may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sign {
    Any,
    Positive,
    NotNegative,
}

/// A place in the tree.
pub(crate) struct Node<'n> {
    pub context: &'n Context,
    /// What messages call it: the key.
    pub name: String,
    pub(super) input: Input<'n>,
    pub(super) span: Range<usize>,
    /// What it held, with defaults filled in.
    pub echo: Echo,
    /// What it may hold.
    pub schema: Value,
    /// A valid value, as TOML.
    pub example: String,
}

impl<'n> Node<'n> {
    pub(super) fn new(context: &'n Context, name: &str, input: Input<'n>, span: Range<usize>) -> Self {
        let name = name.into();
        Node { context, name, input, span, echo: Echo::Nothing, schema: json!({}), example: String::new() }
    }

    /// The whole document.
    pub(crate) fn root(context: &'n Context, document: Option<&'n Spanned<DeValue<'n>>>) -> Self {
        let input = document.map_or(Input::Unknown, |document| Input::Value(document.get_ref()));
        Node::new(context, "case", input, 0..0)
    }

    /// Bytes of the file.
    pub(crate) fn span(&self) -> Range<usize> {
        self.span.clone()
    }

    /// Notes what is wrong here.
    pub(crate) fn fail(&self, message: String, label: impl Into<String>, help: impl Into<String>) {
        self.context.error(self.span(), message, label.into(), Some(help.into()));
    }

    /// Whether it holds an array.
    pub(crate) fn is_list(&self) -> bool {
        matches!(self.input, Input::Value(DeValue::Array(_)))
    }

    /// Whether it holds a string that starts like a number, or a number.
    pub(crate) fn is_quantity(&self) -> bool {
        match self.input {
            Input::Value(DeValue::Integer(_) | DeValue::Float(_)) => true,
            Input::Value(DeValue::String(text)) => {
                text.trim_start().starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c))
            }
            _ => false,
        }
    }

    /// Reads in one of two ways, by what it holds; both belong to the schema.
    pub(crate) fn either<T>(
        &mut self,
        first: bool,
        one: impl FnOnce(&mut Node<'n>) -> T,
        other: impl FnOnce(&mut Node<'n>) -> T,
    ) -> T {
        if self.context.describing {
            one(self);
            let schema = self.schema.take();
            let value = other(self);
            self.schema = json!({ "anyOf": [schema, self.schema] });
            return value;
        }
        if first { one(self) } else { other(self) }
    }

    fn wrong_type(&self, wanted: &str) {
        let found = match self.input {
            Input::Unknown => return,
            Input::Named => "nothing",
            Input::Value(DeValue::String(_)) => "a string",
            Input::Value(DeValue::Integer(_) | DeValue::Float(_)) => "a number",
            Input::Value(DeValue::Boolean(_)) => "true or false",
            Input::Value(DeValue::Datetime(_)) => "a date",
            Input::Value(DeValue::Array(_)) => "a list",
            Input::Value(DeValue::Table(_)) => "a table",
        };
        let example = format!("for example {} = {}", self.name, self.example);
        self.fail(format!("`{}` must be {wanted}", self.name), format!("this is {found}"), example);
    }

    /// Any string.
    pub(crate) fn text(&mut self) -> String {
        self.schema = json!({ "type": "string" });
        self.example = "\"...\"".into();
        match self.input {
            Input::Value(DeValue::String(text)) => {
                self.echo = Echo::text(text);
                text.to_string()
            }
            _ => {
                self.wrong_type("a string");
                String::new()
            }
        }
    }

    /// A whole number in a range; the lower end where it is wrong.
    pub(crate) fn whole(&mut self, range: std::ops::RangeInclusive<u64>) -> u64 {
        let (low, high) = (*range.start(), *range.end());
        self.schema = json!({ "type": "integer", "minimum": low, "maximum": high });
        self.example = low.to_string();
        let Input::Value(DeValue::Integer(integer)) = self.input else {
            self.wrong_type("a whole number");
            return low;
        };
        self.echo = Echo::Leaf(integer.to_string());
        let digits = integer.as_str().trim_start_matches('+');
        match u64::from_str_radix(digits, integer.radix()) {
            Ok(value) if range.contains(&value) => value,
            _ => {
                self.fail(
                    format!("`{}` is {integer}", self.name),
                    "out of range",
                    format!("a whole number from {low} to {high}"),
                );
                low
            }
        }
    }

    /// A bare number.
    pub(crate) fn number(&mut self, sign: Sign) -> f64 {
        let value = self.quantity(&units::NUMBER, sign);
        self.schema = json!({ "type": "number" });
        bound_schema(&mut self.schema, sign);
        value
    }

    /// A number with its unit, in SI; NaN where it is wrong.
    pub(crate) fn quantity(&mut self, kind: &Kind, sign: Sign) -> f64 {
        let is_number = *kind == units::NUMBER;
        self.schema = json!({
            "type": ["string", "number"],
            "examples": [kind.example],
        });
        self.example = if is_number { kind.example.into() } else { format!("\"{}\"", kind.example) };
        let (value, written) = match self.input {
            Input::Value(DeValue::Integer(integer)) if integer.radix() == 10 => {
                self.echo = Echo::Leaf(integer.to_string());
                (integer.as_str().parse().unwrap_or(f64::NAN), integer.to_string())
            }
            Input::Value(DeValue::Float(float)) => {
                self.echo = Echo::Leaf(float.to_string());
                (float.as_str().parse().unwrap_or(f64::NAN), float.to_string())
            }
            Input::Value(DeValue::String(text)) if !is_number => {
                self.echo = Echo::text(text);
                match self.parse(text) {
                    Ok(found) if found.dimension == kind.dimension => (found.value, text.to_string()),
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
                self.wrong_type(&if is_number { kind } else { format!("{kind} with its unit") });
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
        self.fail(format!("`{}` is {written}", self.name), label, format!("for example {}", self.example));
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
        units::parse(text, self.context.spacing.get().map(|dx| if dx.is_nan() { 1.0 } else { dx }))
    }

    fn would_be(&self, text: &str, kind: &Kind) -> bool {
        self.parse(text).is_ok_and(|found| found.dimension == kind.dimension)
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
        self.fail(format!("`{}` must be {wanted}, found \"{text}\"", self.name), label, help);
    }

    /// A list.
    pub(crate) fn list<T>(&mut self, at_least: usize, mut read: impl FnMut(&mut Node<'_>) -> T) -> Vec<T> {
        let mut blank = Node::new(self.context, &self.name, Input::Unknown, self.span());
        if self.context.describing || !self.is_list() {
            read(&mut blank);
        }
        self.schema = json!({ "type": "array", "items": blank.schema, "minItems": at_least });
        self.example = format!("[{}]", vec![blank.example.as_str(); at_least.max(1)].join(", "));
        let Input::Value(DeValue::Array(array)) = self.input else {
            self.wrong_type("a list");
            return Vec::new();
        };
        let mut echo = Vec::new();
        let mut values = Vec::new();
        for item in array {
            let mut node = Node::new(self.context, &self.name, Input::Value(item.get_ref()), item.span());
            values.push(read(&mut node));
            echo.push(node.echo);
        }
        self.echo = Echo::List(echo);
        if values.len() < at_least {
            self.fail(
                format!("`{}` has too few entries", self.name),
                format!("{} of at least {at_least}", values.len()),
                format!("give at least {at_least}"),
            );
        }
        values
    }

    /// As many quantities as space has dimensions; the rest are zero.
    pub(crate) fn vector(&mut self, kind: &Kind, sign: Sign) -> [f64; 3] {
        let values = self.list(0, |node| node.quantity(kind, sign));
        let dimension = self.context.dimension.get();
        self.schema["minItems"] = json!(2);
        self.schema["maxItems"] = json!(3);
        let example = if self.example.is_empty() { String::new() } else { format!("\"{}\"", kind.example) };
        self.example = format!("[{}]", vec![example; dimension.unwrap_or(2)].join(", "));
        let fits = dimension.map_or(2..=3, |dimension| dimension..=dimension);
        if self.is_list() && !fits.contains(&values.len()) {
            let plural = if values.len() == 1 { "" } else { "s" };
            self.fail(
                format!("`{}` has {} component{plural}", self.name, values.len()),
                format!("this case has {} dimensions", dimension.map_or("2 or 3".into(), |d| d.to_string())),
                format!("for example {}", self.example),
            );
        }
        let rest = if values.is_empty() { f64::NAN } else { 0.0 };
        std::array::from_fn(|d| values.get(d).copied().unwrap_or(rest))
    }

    /// A table with known keys, which `read` asks for.
    pub(crate) fn table<T>(&mut self, read: impl FnOnce(&mut Fields<'_, 'n>) -> T) -> T {
        self.example = "{ ... }".into();
        let entries = match self.input {
            Input::Value(DeValue::Table(table)) => Some(table),
            _ => None,
        };
        let given = entries.is_some() || matches!(self.input, Input::Named);
        if !given {
            self.wrong_type("a table");
        }
        let mut fields = Fields::new(self, entries, given);
        let value = read(&mut fields);
        fields.finish();
        value
    }

    /// A table whose keys are names that the user gives, in the file's order.
    pub(crate) fn named<T>(&mut self, mut read: impl FnMut(&str, &mut Node<'_>) -> T) -> Vec<T> {
        let mut blank = Node::new(self.context, "NAME", Input::Unknown, self.span());
        if self.context.describing {
            read("NAME", &mut blank);
        }
        self.schema = json!({ "type": "object", "additionalProperties": blank.schema });
        self.example = "{ ... }".into();
        let Input::Value(DeValue::Table(table)) = self.input else {
            self.wrong_type("a table");
            return Vec::new();
        };
        let mut entries: Vec<_> = table.iter().collect();
        entries.sort_by_key(|(key, _)| key.span().start);
        let mut echo = Vec::new();
        let mut values = Vec::new();
        for (key, value) in entries {
            let name = format!("{}.{}", self.name, key.get_ref());
            let mut node = Node::new(self.context, &name, Input::Value(value.get_ref()), value.span());
            values.push(read(key.get_ref(), &mut node));
            echo.push((key.get_ref().to_string(), node.echo));
        }
        self.echo = Echo::Table(echo);
        values
    }
}

fn bound_schema(schema: &mut Value, sign: Sign) {
    match sign {
        Sign::Any => {}
        Sign::Positive => schema["exclusiveMinimum"] = json!(0),
        Sign::NotNegative => schema["minimum"] = json!(0),
    }
}
