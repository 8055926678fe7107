//! Reading a TOML tree into plain values.
//!
//! A reader is a function of a [`Node`]: it asks for a length, a choice, a
//! table with these fields, and gets a value whatever the file holds. The same
//! walk notes three things: every diagnostic, the node with its defaults
//! filled in (`echo`), and, when the walk is made without a file, the JSON
//! schema. So a key is spelt once, and the schema cannot disagree with the
//! reader.
//!
//! - `node`: a place in the tree; texts, whole numbers, lists and tables
//! - `quantity`: numbers with their units, and vectors of them
//! - `fields`: a table with known keys
//! - `choice`: one of several names, each with fields of its own
//! - `echo`: the tree as resolved, written as TOML

mod choice;
mod echo;
mod fields;
mod node;
mod quantity;

pub(crate) use choice::Choice;
pub(crate) use echo::Echo;
pub(crate) use fields::Fields;
pub(crate) use node::{Context, Node};
pub(crate) use quantity::Sign;
