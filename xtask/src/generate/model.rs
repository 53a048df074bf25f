//! Schemas as declarations need them: named types with fields.

use boundfit_report::answer::DocumentSchema;
use serde_json::{Map, Value};

/// A document: its own type, and the types that it is made of.
pub(super) struct Document {
    /// `boundfit/fit/2`.
    pub(super) name: &'static str,
    /// The command that writes it.
    pub(super) command: &'static str,
    /// The schema as it is written to a file.
    pub(super) schema: Value,
    /// The document itself, then its parts in the order of their names.
    pub(super) definitions: Vec<Definition>,
}

/// A named type.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Definition {
    pub(super) name: String,
    pub(super) description: String,
    pub(super) body: Body,
}

/// The content of a type.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Body {
    /// An object; beside its own fields it has those of one of the variants, if there are any.
    Object { fields: Vec<Field>, variants: Vec<Vec<Field>> },
    /// Another name for a shape.
    Alias(Shape),
}

/// A field of an object.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Field {
    pub(super) name: String,
    pub(super) description: String,
    pub(super) is_required: bool,
    pub(super) shape: Shape,
}

/// The values that a shape allows.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Shape {
    Text,
    Integer,
    Number,
    Boolean,
    Null,
    /// One of these texts.
    Words(Vec<String>),
    List(Box<Shape>),
    /// A list of so many values of one shape.
    Repeated(Box<Shape>, u64),
    Tuple(Vec<Shape>),
    /// An object with these fields, which has no name.
    Object(Vec<Field>),
    /// Texts by name.
    Map(Box<Shape>),
    Named(String),
    Any(Vec<Shape>),
}

impl Document {
    pub(super) fn new(DocumentSchema { name, command, mut schema }: DocumentSchema) -> Self {
        let root = Definition::new(text(&schema, "title"), &schema);
        let parts = schema.get("$defs").and_then(Value::as_object).into_iter().flatten();
        let mut parts: Vec<Definition> = parts.map(|(name, schema)| Definition::new(name, schema)).collect();
        parts.sort_by(|one, other| one.name.cmp(&other.name));
        schema["title"] = name.into();
        Document { name, command, schema, definitions: [root].into_iter().chain(parts).collect() }
    }
}

/// The definitions of all documents, each once: documents first.
///
/// # Panics
/// Where two types that differ have one name.
pub(super) fn all(documents: &[Document]) -> Vec<&Definition> {
    let roots = documents.iter().flat_map(|document| document.definitions.first());
    let parts = documents.iter().flat_map(|document| document.definitions.iter().skip(1));
    let mut all: Vec<&Definition> = Vec::new();
    for definition in roots.chain(parts) {
        match all.iter().find(|other| other.name == definition.name) {
            Some(other) => assert!(**other == *definition, "two types are called {}", definition.name),
            None => all.push(definition),
        }
    }
    all
}

impl Definition {
    fn new(name: &str, schema: &Value) -> Self {
        let variants = schema.get("anyOf").and_then(Value::as_array);
        let is_object = schema.get("properties").is_some();
        let body = match (is_object, variants) {
            (true, variants) => Body::Object {
                fields: Field::of(schema),
                variants: variants.into_iter().flatten().map(Field::of).collect(),
            },
            (false, _) => Body::Alias(Shape::of(schema)),
        };
        Definition { name: name.to_owned(), description: described(schema), body }
    }
}

impl Field {
    fn of(schema: &Value) -> Vec<Self> {
        let required: Vec<&str> = schema
            .get("required")
            .and_then(Value::as_array)
            .into_iter()
            .flatten()
            .filter_map(Value::as_str)
            .collect();
        let properties = schema.get("properties").and_then(Value::as_object);
        let field = |(name, schema): (&String, &Value)| Field {
            name: name.clone(),
            description: described(schema),
            is_required: required.contains(&name.as_str()),
            shape: Shape::of(schema),
        };
        properties.into_iter().flatten().map(field).collect()
    }
}

#[allow(
    clippy::panic,
    reason = "the schemas are those of our own types: whoever writes another one is told what lacks here"
)]
impl Shape {
    /// # Panics
    /// If a schema has a part that no type has yet.
    fn of(schema: &Value) -> Self {
        let Some(schema) = schema.as_object() else { panic!("not the schema of a value: {schema}") };
        if let Some(Value::String(reference)) = schema.get("$ref") {
            return Shape::Named(reference.rsplit('/').next().unwrap_or_default().to_owned());
        }
        if let Some(value) = schema.get("const") {
            return Shape::one_of(std::slice::from_ref(value));
        }
        if let Some(Value::Array(words)) = schema.get("enum") {
            return Shape::one_of(words);
        }
        if let Some(Value::Array(shapes)) = schema.get("anyOf") {
            return Shape::Any(shapes.iter().map(Shape::of).collect());
        }
        match schema.get("type") {
            Some(Value::String(name)) => Shape::of_type(name, schema),
            Some(Value::Array(names)) => {
                let names = names.iter().filter_map(Value::as_str);
                Shape::Any(names.map(|name| Shape::of_type(name, schema)).collect())
            }
            _ => panic!("a schema without a type: {schema:?}"),
        }
    }

    fn one_of(values: &[Value]) -> Self {
        let words = values.iter().filter_map(Value::as_str).map(ToOwned::to_owned).collect();
        if values.contains(&Value::Null) {
            Shape::Any(vec![Shape::Words(words), Shape::Null])
        } else {
            Shape::Words(words)
        }
    }

    fn of_type(name: &str, schema: &Map<String, Value>) -> Self {
        let items = || Box::new(schema.get("items").map_or(Shape::Null, Shape::of));
        let ends = ["minItems", "maxItems"].map(|key| schema.get(key).and_then(Value::as_u64));
        match (name, schema.get("prefixItems"), ends) {
            ("string", ..) => Shape::Text,
            ("integer", ..) => Shape::Integer,
            ("number", ..) => Shape::Number,
            ("boolean", ..) => Shape::Boolean,
            ("null", ..) => Shape::Null,
            ("array", Some(Value::Array(parts)), _) => Shape::Tuple(parts.iter().map(Shape::of).collect()),
            ("array", None, [Some(least), Some(most)]) if least == most => Shape::Repeated(items(), most),
            ("array", None, _) => Shape::List(items()),
            ("object", ..) if schema.contains_key("properties") => {
                Shape::Object(Field::of(&Value::Object(schema.clone())))
            }
            ("object", ..) => {
                Shape::Map(Box::new(schema.get("additionalProperties").map_or(Shape::Null, Shape::of)))
            }
            _ => panic!("a schema of type {name}: {schema:?}"),
        }
    }
}

/// The description on one line.
fn described(schema: &Value) -> String {
    text(schema, "description").split_whitespace().collect::<Vec<_>>().join(" ")
}

fn text<'a>(schema: &'a Value, key: &str) -> &'a str {
    schema.get(key).and_then(Value::as_str).unwrap_or_default()
}
