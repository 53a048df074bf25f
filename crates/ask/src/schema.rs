//! The JSON Schema of requests, from the types that read them.

use boundfit_report::answer::DocumentSchema;
use schemars::generate::SchemaSettings;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde_json::{Map, Value, json};

use crate::question::Ask;
use crate::readings::Common;

/// The schema of the type of requests.
pub(crate) fn of_requests<T: JsonSchema>() -> DocumentSchema {
    let generator = SchemaSettings::draft2020_12().into_generator();
    DocumentSchema::new("boundfit/request/1", "run", generator.into_root_schema_for::<T>())
}

/// Puts the keys that every question has beside the questions.
pub(crate) fn any_of(questions: &[Value], generator: &mut SchemaGenerator) -> Schema {
    let mut schema = Common::json_schema(generator);
    schema.insert(
        "description".to_owned(),
        "A question about readings, about half-planes or about a linear program. `ask` names the question, which has keys of its \
         own; the other keys say which readings, and how the answer is written."
            .into(),
    );
    schema.insert("anyOf".to_owned(), questions.into());
    schema.insert("unevaluatedProperties".to_owned(), false.into());
    schema
}

/// The keys of one question, its name first.
pub(crate) fn question<Q: Ask + JsonSchema>(generator: &mut SchemaGenerator) -> Value {
    let own = Q::json_schema(generator);
    let name = json!({ "description": own.get("description"), "const": Q::NAME });
    let mut properties = Map::from_iter([("ask".to_owned(), name)]);
    properties.extend(own.get("properties").and_then(Value::as_object).cloned().unwrap_or_default());
    let mut required = vec![Value::from("ask")];
    required.extend(own.get("required").and_then(Value::as_array).cloned().unwrap_or_default());
    json_schema!({ "type": "object", "properties": properties, "required": required }).to_value()
}
