//! A table with known keys.

use serde_json::{Map, Value, json};
use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue};

use super::echo::Echo;
use super::node::{Input, Node};
use crate::diagnostic::nearest;

/// The fields of a table, read one by one in any order.
pub(crate) struct Fields<'f, 'n> {
    node: &'f mut Node<'n>,
    entries: Option<&'n DeTable<'n>>,
    /// Whether there is a table at all, so that a missing key is the file's fault.
    given: bool,
    properties: Map<String, Value>,
    required: Vec<&'static str>,
    examples: Vec<String>,
    /// Required keys that the file does not hold, and what to say about each.
    missing: Vec<(&'static str, String)>,
    echo: Vec<(String, Echo)>,
}

impl<'f, 'n> Fields<'f, 'n> {
    pub(super) fn new(
        node: &'f mut Node<'n>,
        entries: Option<&'n DeTable<'n>>,
        given: bool,
    ) -> Self {
        Fields {
            node,
            entries,
            given,
            properties: Map::new(),
            required: Vec::new(),
            examples: Vec::new(),
            missing: Vec::new(),
            echo: Vec::new(),
        }
    }

    fn entry(&self, key: &str) -> Option<&'n Spanned<DeValue<'n>>> {
        Some(
            self.entries?
                .iter()
                .find(|(name, _)| name.get_ref() == key)?
                .1,
        )
    }

    /// Whether the file holds the key.
    pub(crate) fn has(&self, key: &str) -> bool {
        self.entry(key).is_some()
    }

    /// The node under a key; one of nothing where there is no such key.
    fn child(&self, key: &str) -> Node<'n> {
        let (input, span) = match self.entry(key) {
            Some(value) => (Input::Value(value.get_ref()), value.span()),
            None => (Input::Unknown, self.node.span()),
        };
        Node::new(self.node.context, key, input, span)
    }

    /// Reads a node, and notes its echo and its schema.
    fn read<T>(
        &mut self,
        mut node: Node<'_>,
        key: &'static str,
        about: &str,
        read: impl FnOnce(&mut Node<'_>) -> T,
    ) -> T {
        let value = read(&mut node);
        // Nothing may stand beside a reference, so it is wrapped.
        if node.schema.get("$ref").is_some() {
            node.schema = json!({ "allOf": [node.schema] });
        }
        node.schema["description"] = about.into();
        self.properties.insert(key.into(), node.schema);
        if node.echo != Echo::Nothing {
            self.echo.push((key.into(), node.echo));
        }
        value
    }

    /// A field that must be there.
    pub(crate) fn required<T>(
        &mut self,
        key: &'static str,
        about: &str,
        read: impl FnOnce(&mut Node<'_>) -> T,
    ) -> T {
        self.required.push(key);
        let mut example = String::new();
        let child = self.child(key);
        let value = self.read(child, key, about, |node| {
            let value = read(node);
            example.clone_from(&node.example);
            value
        });
        if self.given && !self.has(key) {
            self.missing
                .push((key, format!("{about} For example {key} = {example}")));
        }
        self.examples.push(format!("{key} = {example}"));
        value
    }

    /// A field without a default of its own.
    pub(crate) fn optional<T>(
        &mut self,
        key: &'static str,
        about: &str,
        read: impl FnOnce(&mut Node<'_>) -> T,
    ) -> Option<T> {
        if self.has(key) || self.node.context.describing {
            let child = self.child(key);
            return Some(self.read(child, key, about, read));
        }
        self.properties.insert(key.into(), Value::Null);
        None
    }

    /// A field that was not read, because something else gives its value.
    pub(crate) fn note(&mut self, key: &'static str, value: Echo) {
        self.properties.insert(key.into(), Value::Null);
        self.echo.push((key.into(), value));
    }

    /// A field with a default, which is written as in a file.
    pub(crate) fn or<T>(
        &mut self,
        key: &'static str,
        default: &str,
        about: &str,
        read: impl FnOnce(&mut Node<'_>) -> T,
    ) -> T {
        let default = DeValue::parse(default).map(Spanned::into_inner).ok();
        let describing = self.node.context.describing;
        let node = match &default {
            Some(default) if self.given && !self.has(key) => Node::new(
                self.node.context,
                key,
                Input::Value(default),
                self.node.span(),
            ),
            _ => self.child(key),
        };
        let value = self.read(node, key, about, read);
        if let (true, Some(default)) = (describing, &default) {
            self.properties[key]["default"] = to_json(default);
        }
        value
    }

    /// Reports the keys that nobody asked for, and hands over what was noted.
    pub(super) fn finish(self) {
        let unknown: Vec<_> = self
            .entries
            .into_iter()
            .flatten()
            .map(|(key, _)| key)
            .filter(|key| !self.properties.contains_key(key.get_ref().as_ref()))
            .collect();
        for key in &unknown {
            self.unknown_key(key);
        }
        for (key, help) in &self.missing {
            // A misspelt or misplaced key has been answered already.
            let misspelt = unknown
                .iter()
                .any(|written| self.meant(written.get_ref()) == Some(*key));
            let misplaced = self.node.is_root()
                && self
                    .node
                    .context
                    .misplaced
                    .borrow()
                    .iter()
                    .any(|m| m == key);
            if !misspelt && !misplaced {
                let message = format!("`{}` needs `{key}`", self.node.name);
                self.node.fail(message, format!("`{key}` is missing"), help);
            }
        }
        self.node.schema = json!({
            "type": "object",
            "properties": self.properties,
            "required": self.required,
            "additionalProperties": false,
        });
        self.node.example = format!("{{ {} }}", self.examples.join(", "));
        self.node.echo = Echo::Table(self.echo);
    }

    /// The known key that an unknown one is nearest to.
    fn meant(&self, written: &str) -> Option<&str> {
        nearest(written, self.properties.keys().map(String::as_str))
    }

    fn unknown_key(&self, key: &Spanned<DeString<'_>>) {
        let written = key.get_ref();
        let known: Vec<&str> = self.properties.keys().map(String::as_str).collect();
        let help = match self.meant(written) {
            Some(name) => format!("did you mean `{name}`?"),
            None => match place_of(written, &self.node.name) {
                Some(place) => {
                    self.node
                        .context
                        .misplaced
                        .borrow_mut()
                        .push(written.to_string());
                    format!("`{written}` belongs {place}")
                }
                None if known.is_empty() => "nothing more can be given here".into(),
                None => format!("known here: {}", known.join(", ")),
            },
        };
        let label = format!("not a key of `{}`", self.node.name);
        self.node.context.error(
            key.span(),
            format!("unknown key `{written}`"),
            label,
            Some(help),
        );
    }
}

/// Where in a case file a key belongs, if not `here`: at the top, or in one of the sections.
fn place_of(key: &str, here: &str) -> Option<String> {
    let schema = crate::schema();
    let top = schema["properties"].as_object()?;
    if top.contains_key(key) {
        return Some("at the top of the file, before the first [section]".into());
    }
    let here = here.split('.').next()?;
    top.iter()
        .filter(|(section, _)| *section != here)
        .find_map(|(section, part)| {
            let (title, table) = match part["type"].as_str()? {
                "array" => (format!("in [[{section}]]"), &part["items"]),
                _ if part["additionalProperties"].is_object() => (
                    format!("in [{section}.NAME]"),
                    &part["additionalProperties"],
                ),
                _ => (format!("in [{section}]"), part),
            };
            table["properties"]
                .as_object()?
                .contains_key(key)
                .then_some(title)
        })
}

/// A default as JSON.
fn to_json(value: &DeValue<'_>) -> Value {
    match value {
        DeValue::String(text) => json!(text),
        DeValue::Integer(integer) => json!(integer.as_str().parse::<i64>().unwrap_or_default()),
        DeValue::Float(float) => json!(float.as_str().parse::<f64>().unwrap_or_default()),
        DeValue::Boolean(boolean) => json!(boolean),
        DeValue::Datetime(date) => json!(date.to_string()),
        DeValue::Array(array) => array.iter().map(|item| to_json(item.get_ref())).collect(),
        DeValue::Table(table) => Value::Object(
            table
                .iter()
                .map(|(key, value)| (key.get_ref().to_string(), to_json(value.get_ref())))
                .collect(),
        ),
    }
}
