//! The tree as resolved, written as TOML.

use std::fmt::Write;

/// A value of the resolved case.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Echo {
    /// Not there.
    Nothing,
    /// TOML text of a plain value.
    Leaf(String),
    List(Vec<Echo>),
    Table(Vec<(String, Echo)>),
}

impl Echo {
    /// A string as TOML.
    pub(crate) fn text(text: &str) -> Self {
        let mut out = String::from("\"");
        for c in text.chars() {
            match c {
                '"' => out.push_str("\\\""),
                '\\' => out.push_str("\\\\"),
                '\n' => out.push_str("\\n"),
                c if c.is_control() => {
                    let _ = write!(out, "\\u{:04X}", u32::from(c));
                }
                c => out.push(c),
            }
        }
        out.push('"');
        Echo::Leaf(out)
    }

    /// Puts a value into the table that `path` leads to, by names and by numbers in lists.
    pub(crate) fn insert(&mut self, path: &[&str], key: &str, value: Echo) {
        if let (Echo::List(items), [first, rest @ ..]) = (&mut *self, path) {
            let item = first
                .parse()
                .ok()
                .and_then(|index: usize| items.get_mut(index));
            return item.map_or((), |item| item.insert(rest, key, value));
        }
        let Echo::Table(entries) = self else { return };
        match path {
            [] => entries.push((key.into(), value)),
            [first, rest @ ..] => {
                if let Some((_, child)) = entries.iter_mut().find(|(name, _)| name == first) {
                    child.insert(rest, key, value);
                }
            }
        }
    }

    fn inline(&self) -> String {
        match self {
            Echo::Nothing => String::new(),
            Echo::Leaf(text) => text.clone(),
            Echo::List(items) => {
                let items: Vec<String> = items.iter().map(Echo::inline).collect();
                format!("[{}]", items.join(", "))
            }
            Echo::Table(entries) if entries.is_empty() => "{}".into(),
            Echo::Table(entries) => {
                let entries: Vec<String> = entries
                    .iter()
                    .map(|(name, value)| format!("{} = {}", key(name), value.inline()))
                    .collect();
                format!("{{ {} }}", entries.join(", "))
            }
        }
    }

    /// The whole document: plain values first, then a section per table.
    pub(crate) fn document(&self) -> String {
        let mut out = String::new();
        let Echo::Table(entries) = self else {
            return out;
        };
        let tables = |value: &Echo| matches!(value, Echo::Table(_));
        let sections = |value: &Echo| match value {
            Echo::Table(_) => true,
            Echo::List(items) => !items.is_empty() && items.iter().all(tables),
            _ => false,
        };
        for (name, value) in entries.iter().filter(|(_, value)| !sections(value)) {
            let _ = writeln!(out, "{} = {}", key(name), value.inline());
        }
        for (name, value) in entries.iter().filter(|(_, value)| sections(value)) {
            match value {
                Echo::List(items) => {
                    items
                        .iter()
                        .for_each(|item| section(&mut out, &format!("[[{}]]", key(name)), item));
                }
                Echo::Table(children)
                    if !children.is_empty() && children.iter().all(|c| tables(&c.1)) =>
                {
                    for (child, item) in children {
                        section(&mut out, &format!("[{}.{}]", key(name), key(child)), item);
                    }
                }
                _ => section(&mut out, &format!("[{}]", key(name)), value),
            }
        }
        out
    }
}

fn section(out: &mut String, title: &str, table: &Echo) {
    let Echo::Table(entries) = table else { return };
    let _ = writeln!(out, "\n{title}");
    for (name, value) in entries {
        let _ = writeln!(out, "{} = {}", key(name), value.inline());
    }
}

fn key(name: &str) -> String {
    let bare = !name.is_empty()
        && name
            .bytes()
            .all(|b| b.is_ascii_alphanumeric() || b == b'_' || b == b'-');
    match Echo::text(name) {
        Echo::Leaf(quoted) if !bare => quoted,
        _ => name.into(),
    }
}
