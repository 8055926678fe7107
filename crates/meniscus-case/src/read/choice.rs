//! One of several names, each with fields of its own.

use serde_json::json;
use toml::de::DeValue;

use super::echo::Echo;
use super::node::{Input, Node};
use crate::diagnostic::nearest;

/// One of the names that may stand at a place.
pub(crate) struct Choice<T> {
    pub name: &'static str,
    pub about: &'static str,
    /// The dimensions of space in which it makes sense; none for any.
    pub dimension: Option<usize>,
    /// Reads what stands behind the name. A name without fields reads an empty table.
    pub read: fn(&mut Node<'_>) -> T,
}

impl<T> Choice<T> {
    pub(crate) const fn new(
        name: &'static str,
        about: &'static str,
        read: fn(&mut Node<'_>) -> T,
    ) -> Self {
        Choice {
            name,
            about,
            dimension: None,
            read,
        }
    }

    /// The same, for flows in this many dimensions only.
    pub(crate) const fn only_in(mut self, dimension: usize) -> Self {
        self.dimension = Some(dimension);
        self
    }
}

impl<'n> Node<'n> {
    /// One of several names: `"name"`, or `{ name = { fields } }` to say more.
    ///
    /// `what` is the kind of thing, "shape". The first choice must not hold
    /// another choice of the same kind: it gives the value where the file is wrong.
    pub(crate) fn choice<T>(&mut self, what: &'static str, choices: &[Choice<T>]) -> T {
        if self.context.describing {
            self.describe(what, choices);
        }
        let dimension = self.context.dimension.get();
        let fits = |choice: &Choice<T>| {
            choice.dimension.is_none() || choice.dimension == dimension || dimension.is_none()
        };
        if let Some(first) = choices.iter().find(|choice| fits(choice)) {
            let mut child = self.child(first.name, Input::Unknown);
            (first.read)(&mut child);
            self.example = if needs_fields(&child) {
                format!("{{ {} = {} }}", first.name, child.example)
            } else {
                format!("\"{}\"", first.name)
            };
        }

        let names = || {
            choices
                .iter()
                .filter(|choice| fits(choice))
                .map(|choice| choice.name)
        };
        let all = names()
            .map(|name| format!("\"{name}\""))
            .collect::<Vec<_>>()
            .join(", ");
        let (written, span, input) = match self.input {
            Input::Value(DeValue::String(text)) => (text.as_ref(), self.span(), Input::Named),
            Input::Value(DeValue::Table(table)) if table.len() == 1 => {
                let Some((key, value)) = table.iter().next() else {
                    return self.nothing(choices);
                };
                (
                    key.get_ref().as_ref(),
                    key.span(),
                    Input::Value(value.get_ref()),
                )
            }
            Input::Unknown => return self.nothing(choices),
            _ => {
                let label = format!(
                    "write one name, or {{ name = {{ ... }} }}, such as {}",
                    self.example
                );
                self.fail(
                    format!("`{}` must be one {what}", self.name),
                    label,
                    format!("one of {all}"),
                );
                return self.nothing(choices);
            }
        };
        let Some(choice) = choices.iter().find(|choice| choice.name == written) else {
            let help = match nearest(synonym(written), names()) {
                Some(name) => format!("did you mean \"{name}\"? One of {all}"),
                None => format!("one of {all}"),
            };
            self.context.error(
                span,
                format!("unknown {what} \"{written}\""),
                format!("no {what} has this name"),
                Some(help),
            );
            return self.nothing(choices);
        };
        if !fits(choice) {
            let (has, wants) = (dimension.unwrap_or(2), choice.dimension.unwrap_or(3));
            self.context.error(
                span,
                format!("\"{written}\" is a {what} in {wants} dimensions"),
                format!("this case has {has} dimensions"),
                Some(format!("in {has} dimensions: one of {all}")),
            );
            return self.nothing(choices);
        }
        let mut child = self.child(choice.name, input);
        if let Input::Value(DeValue::Table(table)) = self.input
            && let Some((_, value)) = table.iter().next()
        {
            child.span = value.span();
        }
        let value = (choice.read)(&mut child);
        self.echo = match child.echo {
            Echo::Nothing => Echo::text(choice.name),
            Echo::Table(fields) if fields.is_empty() => Echo::text(choice.name),
            fields => Echo::Table(vec![(choice.name.into(), fields)]),
        };
        value
    }

    /// One of several names that say all.
    pub(crate) fn name_of<T: Copy>(
        &mut self,
        what: &'static str,
        names: &[(&'static str, T)],
    ) -> T {
        let all = names
            .iter()
            .map(|(name, _)| format!("\"{name}\""))
            .collect::<Vec<_>>();
        self.schema = json!({ "enum": names.iter().map(|(name, _)| *name).collect::<Vec<_>>() });
        self.example = all[0].clone();
        let first = names[0].1;
        let written = match self.input {
            Input::Value(DeValue::String(text)) => text,
            Input::Unknown => return first,
            _ => {
                self.fail(
                    format!("`{}` must be one {what}", self.name),
                    "not a name",
                    format!("one of {}", all.join(", ")),
                );
                return first;
            }
        };
        self.echo = Echo::text(written);
        if let Some((_, value)) = names.iter().find(|(name, _)| name == written) {
            return *value;
        }
        let help = match nearest(written, names.iter().map(|(name, _)| *name)) {
            Some(name) => format!("did you mean \"{name}\"? One of {}", all.join(", ")),
            None => format!("one of {}", all.join(", ")),
        };
        self.fail(
            format!("unknown {what} \"{written}\""),
            format!("no {what} has this name"),
            help,
        );
        first
    }

    fn child(&self, name: &str, input: Input<'n>) -> Node<'n> {
        Node::new(self.context, name, input, self.span())
    }

    fn nothing<T>(&self, choices: &[Choice<T>]) -> T {
        (choices[0].read)(&mut self.child(choices[0].name, Input::Unknown))
    }

    /// The schema of all choices, once per kind, and a reference to it here.
    fn describe<T>(&mut self, what: &'static str, choices: &[Choice<T>]) {
        // A reference is a URI, and takes no blanks.
        let what = what.replace(' ', "-");
        self.schema = json!({ "$ref": format!("#/definitions/{what}") });
        if self.context.definitions.borrow().contains_key(&what) {
            return;
        }
        // Kept before it is known, for choices that hold themselves.
        self.context
            .definitions
            .borrow_mut()
            .insert(what.clone(), json!({}));
        let mut any_of = Vec::new();
        for choice in choices {
            let mut child = self.child(choice.name, Input::Unknown);
            (choice.read)(&mut child);
            if !needs_fields(&child) {
                any_of.push(json!({ "const": choice.name, "description": choice.about }));
            }
            any_of.push(json!({
                "type": "object",
                "properties": { choice.name: child.schema },
                "required": [choice.name],
                "additionalProperties": false,
                "description": choice.about,
            }));
        }
        self.context
            .definitions
            .borrow_mut()
            .insert(what, json!({ "anyOf": any_of }));
    }
}

/// Whether the name alone does not say enough.
fn needs_fields(node: &Node<'_>) -> bool {
    node.schema["type"] != "object"
        || node.schema["required"]
            .as_array()
            .is_some_and(|r| !r.is_empty())
}

/// Names that others use for what has one name here.
fn synonym(written: &str) -> &str {
    match written {
        "box" | "rectangle" | "cuboid" | "square" | "cube" => "block",
        "circle" => "disc",
        "ball" => "sphere",
        other => other,
    }
}
