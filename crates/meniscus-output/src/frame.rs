//! The particles at one instant.

use std::collections::HashSet;

/// The particles at one instant, as ParaView shall see them.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// Simulated time, s.
    pub time: f64,
    /// Steps done.
    pub step: u64,
    /// Dimensions of the flow, 2 or 3.
    pub dimension: usize,
    /// Positions, m; in two dimensions the third component is zero.
    pub positions: Vec<[f64; 3]>,
    /// What each particle carries.
    pub fields: Vec<Field>,
}

/// A quantity that each particle carries.
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    /// Name, as in `pressure`.
    pub name: String,
    /// Unit, as in `Pa`; empty for a plain number.
    pub unit: String,
    /// 1 for a scalar, 3 for a vector.
    pub components: usize,
    /// Values in the order of the particles, the components of one together.
    pub values: Vec<f64>,
}

impl Field {
    /// A scalar field.
    pub fn scalar(name: &str, unit: &str, values: Vec<f64>) -> Self {
        Field {
            name: name.to_owned(),
            unit: unit.to_owned(),
            components: 1,
            values,
        }
    }

    /// A vector field; in two dimensions the third component is zero.
    pub fn vector(name: &str, unit: &str, values: &[[f64; 3]]) -> Self {
        Field {
            name: name.to_owned(),
            unit: unit.to_owned(),
            components: 3,
            values: values.as_flattened().to_vec(),
        }
    }

    /// The name as ParaView shows it, `pressure [Pa]`.
    pub fn label(&self) -> String {
        crate::series::label(&self.name, &self.unit)
    }
}

impl Frame {
    /// Why the frame cannot be written, if it cannot.
    pub(crate) fn fault(&self) -> Option<String> {
        let count = self.positions.len();
        if !self.time.is_finite() {
            return Some(format!("the time of the frame is {}", self.time));
        }
        let mut seen = HashSet::new();
        for field in &self.fields {
            let label = field.label();
            if field.name.is_empty() || label.chars().any(char::is_control) {
                return Some(format!(
                    "a field is named {:?}; a name is printable and not empty",
                    field.name
                ));
            }
            if !matches!(field.components, 1 | 3) {
                return Some(format!(
                    "field {label} has {} components; 1 or 3 can be shown",
                    field.components
                ));
            }
            if field.values.len() != count * field.components {
                return Some(format!(
                    "field {label} has {} values; {count} particles of {} components need {}",
                    field.values.len(),
                    field.components,
                    count * field.components
                ));
            }
            if !seen.insert(label) {
                return Some(format!("two fields are named {}", field.label()));
            }
        }
        None
    }
}
