//! The JSON schema holds for what the reader takes, and refuses what it refuses.

use std::fs;
use std::path::Path;

use meniscus_case::{Case, schema, template};
use serde_json::Value;

/// Whether a value fits a schema, for the keywords that ours uses; any other
/// keyword is an error, so that nothing goes unchecked.
fn fits(value: &Value, schema: &Value, root: &Value) -> Result<(), String> {
    let number = |key: &str| schema[key].as_f64().unwrap();
    for (keyword, rule) in schema.as_object().ok_or("a schema must be an object")? {
        let ok = match keyword.as_str() {
            "$schema" | "title" | "definitions" | "description" | "examples" | "default" => true,
            "$ref" => {
                let name = rule
                    .as_str()
                    .unwrap()
                    .strip_prefix("#/definitions/")
                    .unwrap();
                return fits(value, &root["definitions"][name], root);
            }
            "allOf" => rule
                .as_array()
                .unwrap()
                .iter()
                .all(|part| fits(value, part, root).is_ok()),
            "anyOf" => rule
                .as_array()
                .unwrap()
                .iter()
                .any(|part| fits(value, part, root).is_ok()),
            "const" => value == rule,
            "enum" => rule.as_array().unwrap().contains(value),
            "type" => {
                let is = |name: &Value| match name.as_str().unwrap() {
                    "object" => value.is_object(),
                    "array" => value.is_array(),
                    "string" => value.is_string(),
                    "number" => value.is_number(),
                    "integer" => value.is_u64() || value.is_i64(),
                    other => panic!("type {other}"),
                };
                rule.as_array()
                    .map_or_else(|| is(rule), |names| names.iter().any(is))
            }
            "minimum" => value.as_f64().is_none_or(|v| v >= number("minimum")),
            "exclusiveMinimum" => value
                .as_f64()
                .is_none_or(|v| v > number("exclusiveMinimum")),
            "maximum" => value.as_f64().is_none_or(|v| v <= number("maximum")),
            "minItems" => value
                .as_array()
                .is_none_or(|items| items.len() as f64 >= number("minItems")),
            "maxItems" => value
                .as_array()
                .is_none_or(|items| items.len() as f64 <= number("maxItems")),
            "items" => value
                .as_array()
                .is_none_or(|items| items.iter().all(|item| fits(item, rule, root).is_ok())),
            "required" => value.as_object().is_none_or(|object| {
                rule.as_array()
                    .unwrap()
                    .iter()
                    .all(|key| object.contains_key(key.as_str().unwrap()))
            }),
            "properties" => {
                for (key, part) in rule.as_object().unwrap() {
                    if let Some(value) = value.get(key) {
                        fits(value, part, root).map_err(|reason| format!("{key}: {reason}"))?;
                    }
                }
                true
            }
            "additionalProperties" => value.as_object().is_none_or(|object| {
                object
                    .iter()
                    .filter(|(key, _)| schema["properties"].get(key).is_none())
                    .all(|(_, value)| {
                        rule.as_bool() != Some(false) && fits(value, rule, root).is_ok()
                    })
            }),
            other => panic!("keyword {other}"),
        };
        if !ok {
            return Err(format!("{keyword} {rule} does not hold for {value}"));
        }
    }
    Ok(())
}

fn check(text: &str) -> Result<(), String> {
    let schema = schema();
    fits(
        &toml::from_str(text).map_err(|error| error.to_string())?,
        &schema,
        &schema,
    )
}

fn cases(folder: &str) -> Vec<(String, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/cases")
        .join(folder);
    fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .map(|path| {
            (
                path.display().to_string(),
                fs::read_to_string(path).unwrap(),
            )
        })
        .collect()
}

#[test]
fn good_cases_their_resolved_form_and_the_template_fit() {
    for (name, text) in cases("good") {
        check(&text).unwrap_or_else(|reason| panic!("{name}: {reason}"));
        // Files that a case names lie beside it.
        let resolved = Case::from_str(&name, &text).unwrap().to_toml().to_string();
        check(&resolved).unwrap_or_else(|reason| panic!("{name} resolved: {reason}"));
    }
    check(&template("drop")).unwrap();
}

#[test]
fn wrong_names_missing_keys_and_wrong_types_do_not_fit() {
    let mut refused = 0;
    for (name, text) in cases("bad") {
        let by_form = [
            "unknown-key",
            "unknown-choice",
            "unknown-shape",
            "missing-",
            "wrong-type",
            "two-shapes",
            "four-dim",
        ];
        let file = Path::new(&name).file_name().unwrap().to_str().unwrap();
        if by_form.iter().any(|start| file.starts_with(start)) {
            assert!(check(&text).is_err(), "{name}");
            refused += 1;
        }
    }
    assert!(refused >= 10, "{refused}");
}

#[test]
fn every_key_is_described() {
    fn walk(value: &Value, path: &str) {
        if let Some(properties) = value.get("properties").and_then(Value::as_object) {
            for (key, part) in properties {
                // The key of a choice is described beside it.
                let described = part["description"].is_string() || value["description"].is_string();
                assert!(described, "{path}.{key} has no description");
            }
        }
        match value {
            Value::Object(object) => object
                .iter()
                .for_each(|(key, part)| walk(part, &format!("{path}.{key}"))),
            Value::Array(array) => array.iter().for_each(|part| walk(part, path)),
            _ => {}
        }
    }
    walk(&schema(), "");
}

#[test]
fn a_new_case_runs_as_it_is() {
    for name in ["drop", "with \"quotes\" and \\", "two\nlines"] {
        let case =
            Case::from_str("new.toml", &template(name)).unwrap_or_else(|wrong| panic!("{wrong}"));
        assert!(case.warnings.is_empty(), "{}", case.warnings);
        assert!(
            (500..5000).contains(&case.particle_count()),
            "{}",
            case.particle_count()
        );
    }
    assert_eq!(
        Case::from_str("new.toml", &template("drop"))
            .unwrap()
            .title
            .unwrap(),
        "drop"
    );
}
