//! A place in the tree, and the plain values that it may hold.

use std::cell::{Cell, RefCell};
use std::ops::Range;
use std::path::PathBuf;

use serde_json::{Map, Value, json};
use toml::Spanned;
use toml::de::DeValue;

use super::echo::Echo;
use super::fields::Fields;
use crate::diagnostic::{Diagnostic, Severity};

/// What messages call the whole document.
const ROOT: &str = "case";

/// What all nodes of a walk share.
#[derive(Default)]
pub(crate) struct Context {
    pub diagnostics: RefCell<Vec<Diagnostic>>,
    /// Whether the walk is made without a file, for the schema.
    pub describing: bool,
    /// Where the file lies, from which the names of others start.
    pub folder: PathBuf,
    /// What `dx` stands for; NaN where the file's is wrong.
    pub spacing: Cell<Option<f64>>,
    /// Dimensions of space; none where the file's is wrong.
    pub dimension: Cell<Option<usize>>,
    /// Whether a fluid is one of van der Waals, to which other equations belong.
    pub van_der_waals: Cell<bool>,
    /// Number of fluids, and whether any has surface tension.
    pub fluids: Cell<usize>,
    pub has_surface_tension: Cell<bool>,
    /// Keys that were found in another section than their own.
    pub misplaced: RefCell<Vec<String>>,
    /// Parts of the schema that others refer to.
    pub definitions: RefCell<Map<String, Value>>,
}

impl Context {
    pub(crate) fn error(
        &self,
        span: Range<usize>,
        message: String,
        label: String,
        help: Option<String>,
    ) {
        let span = Some(span);
        let severity = Severity::Error;
        self.diagnostics.borrow_mut().push(Diagnostic {
            severity,
            message,
            label,
            help,
            span,
        });
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
    pub(super) fn new(
        context: &'n Context,
        name: &str,
        input: Input<'n>,
        span: Range<usize>,
    ) -> Self {
        let name = name.into();
        Node {
            context,
            name,
            input,
            span,
            echo: Echo::Nothing,
            schema: json!({}),
            example: String::new(),
        }
    }

    /// The whole document.
    pub(crate) fn root(context: &'n Context, document: Option<&'n DeValue<'n>>) -> Self {
        // What is missing at the top is missing beside the first key.
        let first = document.and_then(DeValue::as_table).and_then(|table| {
            table
                .keys()
                .map(Spanned::span)
                .min_by_key(|span| span.start)
        });
        Node::new(
            context,
            ROOT,
            document.map_or(Input::Unknown, Input::Value),
            first.unwrap_or(0..0),
        )
    }

    pub(super) fn is_root(&self) -> bool {
        self.name == ROOT
    }

    /// Bytes of the file.
    pub(crate) fn span(&self) -> Range<usize> {
        self.span.clone()
    }

    /// Notes what is wrong here.
    pub(crate) fn fail(&self, message: String, label: impl Into<String>, help: impl Into<String>) {
        self.context
            .error(self.span(), message, label.into(), Some(help.into()));
    }

    /// Notes that a vector has no direction, if it has none.
    pub(crate) fn refuse_zero(&self, vector: &[f64]) {
        if vector.iter().all(|&x| x == 0.0) {
            self.fail(
                "this vector has no direction".into(),
                "all its components are zero",
                "for example [1, 0] in 2D, [1, 0, 0] in 3D",
            );
        }
    }

    /// Whether it holds an array.
    pub(crate) fn is_list(&self) -> bool {
        matches!(self.input, Input::Value(DeValue::Array(_)))
    }

    /// Whether it holds a table.
    pub(crate) fn is_table(&self) -> bool {
        matches!(self.input, Input::Value(DeValue::Table(_)))
    }

    /// Whether it holds a string that starts like a number, or a number.
    pub(crate) fn is_quantity(&self) -> bool {
        match self.input {
            Input::Value(DeValue::Integer(_) | DeValue::Float(_)) => true,
            Input::Value(DeValue::String(text)) => text
                .trim_start()
                .starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c)),
            _ => false,
        }
    }

    /// Whether it holds a table with this key.
    pub(crate) fn holds(&self, key: &str) -> bool {
        match self.input {
            Input::Value(DeValue::Table(table)) => {
                table.iter().any(|(name, _)| name.get_ref() == key)
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

    pub(super) fn wrong_type(&self, wanted: &str) {
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
        self.fail(
            format!("`{}` must be {wanted}", self.name),
            format!("this is {found}"),
            example,
        );
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

    /// A list.
    pub(crate) fn list<T>(
        &mut self,
        at_least: usize,
        mut read: impl FnMut(&mut Node<'_>) -> T,
    ) -> Vec<T> {
        let mut blank = Node::new(self.context, &self.name, Input::Unknown, self.span());
        if !self.is_list() {
            read(&mut blank);
        }
        self.schema = json!({ "type": "array", "items": blank.schema, "minItems": at_least });
        self.example = format!(
            "[{}]",
            vec![blank.example.as_str(); at_least.max(1)].join(", ")
        );
        let Input::Value(DeValue::Array(array)) = self.input else {
            self.wrong_type("a list");
            return Vec::new();
        };
        let mut echo = Vec::new();
        let mut values = Vec::new();
        for item in array {
            let mut node = Node::new(
                self.context,
                &self.name,
                Input::Value(item.get_ref()),
                item.span(),
            );
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

    /// A table with known keys, which `read` asks for.
    pub(crate) fn table<T>(&mut self, read: impl FnOnce(&mut Fields<'_, 'n>) -> T) -> T {
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
        if !self.is_table() {
            read("NAME", &mut blank);
        }
        self.schema = json!({ "type": "object", "additionalProperties": blank.schema });
        self.example = format!("{{ NAME = {} }}", blank.example);
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
            let mut node = Node::new(
                self.context,
                &name,
                Input::Value(value.get_ref()),
                value.span(),
            );
            values.push(read(key.get_ref(), &mut node));
            echo.push((key.get_ref().to_string(), node.echo));
        }
        self.echo = Echo::Table(echo);
        values
    }
}
