//! The JSON schema of case files, for editors.

use serde_json::{Value, json};

use crate::grammar::document;
use crate::read::{Context, Node};

/// The JSON schema (draft 7) of a case file, with descriptions and defaults.
///
/// It is written by the same walk that reads a file.
pub fn schema() -> Value {
    let context = Context {
        describing: true,
        ..Context::default()
    };
    let mut node = Node::root(&context, None);
    document(&mut node);
    let mut schema = node.schema;
    schema["$schema"] = "http://json-schema.org/draft-07/schema#".into();
    schema["title"] = "A case of Meniscus".into();
    schema["definitions"] = json!(context.definitions.take());
    schema
}
