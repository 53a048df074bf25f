//! The JSON Schema of every document.

use std::borrow::Cow;

use schemars::generate::SchemaSettings;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde_json::Value;

use crate::answer::check::CheckJson;
use crate::answer::fit::FitJson;
use crate::answer::judge::JudgeJson;
use crate::answer::linearity::LinearityJson;
use crate::answer::next_reading::NextReadingJson;
use crate::answer::outliers::OutliersJson;
use crate::answer::parts::EndJson;
#[cfg(feature = "files")]
use crate::answer::polygon::PolygonJson;
use crate::answer::predict::PredictionJson;
#[cfg(feature = "files")]
use crate::answer::proof::{ProofJson, StatementsJson};
use crate::answer::range::LinearRangeJson;
use crate::answer::status::StatusesJson;
use crate::answer::verify::VerifyJson;
use crate::answer::window::{GroupJson, WindowJson};
use crate::answer::x_errors::XErrorJson;
use crate::number::Number;

/// A document, or the request for one, with its JSON Schema.
#[derive(Debug, Clone)]
pub struct DocumentSchema {
    /// The name and number of the schema, `boundfit/fit/2`.
    pub name: &'static str,
    /// The command that writes the document, or the function that takes the request.
    pub command: &'static str,
    /// The schema, draft 2020-12. Its definitions have the names of the types without `Json`.
    pub schema: Value,
}

impl DocumentSchema {
    fn of<T: JsonSchema>(name: &'static str, command: &'static str) -> Self {
        let generator = SchemaSettings::draft2020_12().for_serialize().into_generator();
        let mut own = DocumentSchema::new(name, command, generator.into_root_schema_for::<T>());
        let title = own.schema["title"].as_str().map(|title| format!("{title}Document"));
        own.schema["title"] = title.into();
        own
    }

    /// Takes the schema of a type, in which what may be absent is not null.
    pub fn new(name: &'static str, command: &'static str, schema: Schema) -> Self {
        let mut schema = schema.to_value();
        rename(&mut schema);
        absent_or_not_null(&mut schema);
        for (name, part) in schema.get_mut("$defs").and_then(Value::as_object_mut).into_iter().flatten() {
            // A double may be beyond the largest one.
            if name != NUMBER {
                absent_or_not_null(part);
            }
        }
        DocumentSchema { name, command, schema }
    }
}

/// Every document that boundfit writes for programs.
pub fn documents() -> Vec<DocumentSchema> {
    vec![
        DocumentSchema::of::<FitJson>(FitJson::SCHEMA, "fit"),
        DocumentSchema::of::<XErrorJson>(XErrorJson::SCHEMA, "fit with errors in x"),
        DocumentSchema::of::<GroupJson<'_>>(GroupJson::SCHEMA, "fit of groups, a line for each"),
        DocumentSchema::of::<WindowJson<'_>>(WindowJson::SCHEMA, "fit of windows, a line for each"),
        DocumentSchema::of::<StatusesJson>(StatusesJson::SCHEMA, "status"),
        DocumentSchema::of::<PredictionJson>(PredictionJson::SCHEMA, "predict"),
        DocumentSchema::of::<NextReadingJson>(NextReadingJson::SCHEMA, "next"),
        DocumentSchema::of::<OutliersJson>(OutliersJson::SCHEMA, "outliers"),
        DocumentSchema::of::<LinearRangeJson>(LinearRangeJson::SCHEMA, "range"),
        DocumentSchema::of::<LinearityJson>(LinearityJson::SCHEMA, "linearity"),
        #[cfg(feature = "files")]
        DocumentSchema::of::<PolygonJson>(PolygonJson::SCHEMA, "polygon"),
        DocumentSchema::of::<CheckJson<'_>>(CheckJson::SCHEMA, "check"),
        DocumentSchema::of::<JudgeJson>(JudgeJson::SCHEMA, "judge"),
        DocumentSchema::of::<VerifyJson<'_>>(VerifyJson::SCHEMA, "verify"),
        #[cfg(feature = "files")]
        DocumentSchema::of::<ProofJson>(ProofJson::SCHEMA, "fit, as a proof"),
        #[cfg(feature = "files")]
        DocumentSchema::of::<StatementsJson<'_>>(StatementsJson::SCHEMA, "other questions, as a proof"),
    ]
}

/// Takes `Json` from the names of types.
fn rename(schema: &mut Value) {
    match schema {
        Value::Object(fields) => {
            for (key, value) in fields.iter_mut() {
                match value {
                    Value::String(name) if key == "$ref" || key == "title" => {
                        *name = name.replace("Json", "");
                    }
                    Value::Object(definitions) if key == "$defs" => {
                        let old = std::mem::take(definitions).into_iter();
                        definitions
                            .extend(old.map(|(name, definition)| (name.replace("Json", ""), definition)));
                    }
                    _ => {}
                }
                rename(value);
            }
        }
        Value::Array(values) => values.iter_mut().for_each(rename),
        _ => {}
    }
}

/// Takes null from the fields that may be absent: they are left out instead.
fn absent_or_not_null(schema: &mut Value) {
    for variant in schema.get_mut("anyOf").and_then(Value::as_array_mut).into_iter().flatten() {
        absent_or_not_null(variant);
    }
    let required = schema.get("required").cloned().unwrap_or_default();
    let is_required = |name: &str| required.as_array().is_some_and(|names| names.contains(&name.into()));
    for (name, field) in schema.get_mut("properties").and_then(Value::as_object_mut).into_iter().flatten() {
        if is_required(name) {
            continue;
        }
        if let Value::Object(field) = field {
            field.retain(|keyword, value| keyword != "default" || !value.is_null());
        }
        for keyword in ["type", "anyOf"] {
            let Some(Value::Array(choices)) = field.get_mut(keyword) else { continue };
            choices.retain(|choice| choice != "null" && choice["type"] != "null");
            if let [only] = choices.as_slice() {
                match (only.clone(), &mut *field) {
                    (Value::Object(only), Value::Object(field)) => {
                        field.remove(keyword);
                        field.extend(only);
                    }
                    (only, field) => field[keyword] = only,
                }
            }
        }
    }
}

/// What numbers are called.
const NUMBER: &str = "Exact";

impl JsonSchema for Number {
    fn schema_name() -> Cow<'static, str> {
        NUMBER.into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "An exact number and its forms. Decisions take `exact`.",
            "type": "object",
            "properties": {
                "exact": {
                    "description": "The number as a fraction `p/q` or an integer; null where the fraction is longer than the limit `fraction`.",
                    "type": ["string", "null"]
                },
                "decimal": {
                    "description": "A decimal, rounded to the significant digits asked for: ends of intervals outward, error bounds up, other numbers to nearest.",
                    "type": "string"
                },
                "value": {
                    "description": "The nearest double; null beyond the largest double.",
                    "type": ["number", "null"]
                },
                "outward": {
                    "description": "A double that is never inside: lower ends are rounded down, upper ends, error bounds and factors up. Null beyond the largest double; absent for other numbers.",
                    "type": ["number", "null"]
                }
            },
            "required": ["exact", "decimal", "value"]
        })
    }
}

impl JsonSchema for EndJson {
    fn schema_name() -> Cow<'static, str> {
        "End".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "type": "object",
            "properties": {
                "exact": {
                    "description": "The end as a fraction `p/q` or an integer; null where nothing bounds.",
                    "type": ["string", "null"]
                },
                "decimal": {
                    "description": "A decimal, rounded outward; null where nothing bounds.",
                    "type": ["string", "null"]
                },
                "value": {
                    "description": "The nearest double; null where nothing bounds and beyond the largest double.",
                    "type": ["number", "null"]
                },
                "outward": {
                    "description": "The next double that is not inside; null where nothing bounds and beyond the largest double.",
                    "type": ["number", "null"]
                }
            },
            "required": ["exact", "decimal", "value", "outward"]
        })
    }
}
