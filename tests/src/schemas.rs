//! The JSON Schemas in the folder `schema`, and whether documents keep to them: a checker of the keywords that they use.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;

use serde_json::{Map, Value};

use crate::program::root;

/// Every schema by its name, `boundfit/fit/2`.
pub fn schemas() -> BTreeMap<String, Value> {
    let files = fs::read_dir(root().join("schema")).unwrap().map(|entry| entry.unwrap().path());
    let schema = |path| {
        let schema: Value = serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap();
        (schema["title"].as_str().unwrap().to_owned(), schema)
    };
    files.map(schema).collect()
}

/// Returns where a document or a request has what its schema does not describe, or lacks what it does: a key without a description is a violation, too.
///
/// # Panics
/// Where the schema has a keyword that this checker does not know.
pub fn violations(document: &Value, schema: &Value) -> Vec<String> {
    let mut checker = Checker { definitions: &schema["$defs"], found: Vec::new() };
    checker.check(document, schema, "document", &BTreeSet::new());
    checker.found
}

/// Keywords that say nothing about a value.
const REMARKS: [&str; 7] = ["$schema", "$defs", "title", "description", "format", "default", "required"];

struct Checker<'a> {
    definitions: &'a Value,
    found: Vec<String>,
}

impl<'a> Checker<'a> {
    /// `known` are the keys that another part of the schema describes.
    fn check(&mut self, value: &Value, schema: &'a Value, path: &str, known: &BTreeSet<&str>) {
        let Value::Object(keywords) = schema else { panic!("{path}: {schema} is no schema") };
        for (keyword, operand) in keywords {
            let holds = match keyword.as_str() {
                "$ref" => {
                    let name = operand.as_str().and_then(|place| place.strip_prefix("#/$defs/")).unwrap();
                    self.check(value, &self.definitions[name], path, known);
                    true
                }
                "const" => value == operand,
                "enum" => operand.as_array().unwrap().contains(value),
                "type" => names(operand).any(|name| is_of(value, name)),
                "anyOf" => self.any(value, operand, path, keywords),
                "properties" => {
                    self.object(value, keywords, path, known);
                    true
                }
                // Nothing that is not described is allowed anyway.
                "additionalProperties" | "unevaluatedProperties" if operand == false => true,
                "additionalProperties" => {
                    for (key, value) in value.as_object().into_iter().flatten() {
                        self.check(value, operand, &format!("{path}.{key}"), &BTreeSet::new());
                    }
                    true
                }
                "items" => {
                    for (index, value) in value.as_array().into_iter().flatten().enumerate() {
                        self.check(value, operand, &format!("{path}[{index}]"), &BTreeSet::new());
                    }
                    true
                }
                "prefixItems" => {
                    let values = value.as_array().into_iter().flatten();
                    for (index, (value, schema)) in values.zip(operand.as_array().unwrap()).enumerate() {
                        self.check(value, schema, &format!("{path}[{index}]"), &BTreeSet::new());
                    }
                    true
                }
                "minItems" => {
                    value.as_array().is_none_or(|items| items.len() as u64 >= operand.as_u64().unwrap())
                }
                "maxItems" => {
                    value.as_array().is_none_or(|items| items.len() as u64 <= operand.as_u64().unwrap())
                }
                "minLength" | "maxLength" => {
                    value.as_str().is_none_or(|text| Some(text.chars().count() as u64) == operand.as_u64())
                }
                "minimum" => value.as_f64().is_none_or(|number| number >= operand.as_f64().unwrap()),
                "maximum" => value.as_f64().is_none_or(|number| number <= operand.as_f64().unwrap()),
                remark if REMARKS.contains(&remark) => true,
                other => panic!("{path}: the keyword {other} is not known"),
            };
            if !holds {
                self.found.push(format!("{path}: {value} against {keyword} {operand}"));
            }
        }
    }

    /// Returns whether one of these schemas describes the value.
    fn any(
        &mut self,
        value: &Value,
        schemas: &'a Value,
        path: &str,
        keywords: &'a Map<String, Value>,
    ) -> bool {
        let known: BTreeSet<&str> = keys(keywords).collect();
        schemas.as_array().unwrap().iter().any(|schema| {
            let mut checker = Checker { definitions: self.definitions, found: Vec::new() };
            checker.check(value, schema, path, &known);
            checker.found.is_empty()
        })
    }

    fn object(
        &mut self,
        value: &Value,
        keywords: &'a Map<String, Value>,
        path: &str,
        known: &BTreeSet<&str>,
    ) {
        let Value::Object(fields) = value else { return };
        let properties = &keywords["properties"];
        for name in keywords.get("required").into_iter().flat_map(names) {
            if !fields.contains_key(name) {
                self.found.push(format!("{path}.{name} is missing"));
            }
        }
        // The keys that variants describe.
        let variants = keywords.get("anyOf").and_then(Value::as_array).into_iter().flatten();
        let variants: BTreeSet<&str> = variants.filter_map(Value::as_object).flat_map(keys).collect();
        for (key, value) in fields {
            match properties.get(key) {
                Some(schema) => self.check(value, schema, &format!("{path}.{key}"), &BTreeSet::new()),
                None if known.contains(key.as_str()) || variants.contains(key.as_str()) => {}
                None => self.found.push(format!("{path}.{key} is not described")),
            }
        }
    }
}

fn keys(keywords: &Map<String, Value>) -> impl Iterator<Item = &str> {
    keywords
        .get("properties")
        .and_then(Value::as_object)
        .into_iter()
        .flat_map(|own| own.keys().map(String::as_str))
}

/// One text, or several.
fn names(operand: &Value) -> impl Iterator<Item = &str> {
    let several = operand.as_array().into_iter().flatten();
    operand.as_str().into_iter().chain(several.filter_map(Value::as_str))
}

fn is_of(value: &Value, name: &str) -> bool {
    match name {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "integer" => value.is_i64() || value.is_u64(),
        "number" => value.is_number(),
        "boolean" => value.is_boolean(),
        "null" => value.is_null(),
        other => panic!("the type {other} is not known"),
    }
}
