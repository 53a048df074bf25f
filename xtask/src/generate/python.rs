//! Declarations for Python.

use super::model::{Body, Definition, Document, Field, Shape, all};

/// Names that no attribute of a class may have.
const KEYWORDS: [&str; 4] = ["class", "from", "in", "is"];

/// A module with a `TypedDict` for each document and each of its parts.
pub(super) fn declarations(documents: &[Document]) -> String {
    let mut text = "\"\"\"The documents that boundfit writes, as types: what ``to_dict()`` gives. Made by ``cargo xtask generate``.\"\"\"\n\n\
         from __future__ import annotations\n\n\
         from typing import Literal, NotRequired, TypedDict, Union\n"
        .to_owned();
    let mut aliases = String::new();
    for Definition { name, description, body } in all(documents) {
        match body {
            // Aliases are evaluated when the module is loaded, after the classes that they name.
            Body::Alias(shape) => {
                let parts = match shape {
                    Shape::Any(shapes) => shapes.clone(),
                    shape => vec![shape.clone()],
                };
                let parts: Vec<String> = parts.iter().map(typed).collect();
                aliases.push_str(&format!(
                    "\n{name} = Union[{}]\n{}",
                    parts.join(", "),
                    documentation("", description)
                ));
            }
            Body::Object { fields, variants } => {
                let others =
                    variants.iter().flatten().map(|field| Field { is_required: false, ..field.clone() });
                let mut fields = fields.clone();
                for other in others {
                    if fields.iter().all(|field| field.name != other.name) {
                        fields.push(other);
                    }
                }
                text.push_str(&class(name, description, &fields));
            }
        }
    }
    let aliases = if aliases.is_empty() { aliases } else { format!("\n{aliases}") };
    text + &aliases
}

fn class(name: &str, description: &str, fields: &[Field]) -> String {
    let typed = |field: &Field| match field.is_required {
        true => typed(&field.shape),
        false => format!("NotRequired[{}]", typed(&field.shape)),
    };
    if fields.iter().any(|field| KEYWORDS.contains(&field.name.as_str())) {
        let entries: String = fields
            .iter()
            .map(|field| {
                let own = self::typed(&field.shape);
                let own =
                    if field.is_required { format!("{own:?}") } else { format!("NotRequired[{own:?}]") };
                format!("        # {}\n        \"{}\": {own},\n", field.description, field.name)
            })
            .collect();
        let documentation = documentation("", description);
        return format!(
            "\n\n{name} = TypedDict(\n    \"{name}\",\n    {{\n{entries}    }},\n)\n{documentation}"
        );
    }
    let mut text = format!("\n\nclass {name}(TypedDict):\n{}\n", documentation("    ", description));
    for field in fields {
        text.push_str(&format!(
            "    {}: {}\n{}",
            field.name,
            typed(field),
            documentation("    ", &field.description)
        ));
    }
    text
}

fn documentation(indent: &str, description: &str) -> String {
    if description.is_empty() { String::new() } else { format!("{indent}\"\"\"{description}\"\"\"\n") }
}

fn typed(shape: &Shape) -> String {
    let joined = |shapes: &[Shape]| {
        let mut names: Vec<String> = shapes.iter().map(typed).collect();
        names.dedup();
        names.join(" | ")
    };
    match shape {
        Shape::Text => "str".to_owned(),
        Shape::Integer => "int".to_owned(),
        Shape::Number => "float".to_owned(),
        Shape::Boolean => "bool".to_owned(),
        Shape::Null => "None".to_owned(),
        Shape::Words(words) => {
            let words: Vec<String> = words.iter().map(|word| format!("\"{word}\"")).collect();
            format!("Literal[{}]", words.join(", "))
        }
        Shape::List(shape) | Shape::Repeated(shape, _) => format!("list[{}]", typed(shape)),
        Shape::Tuple(shapes) => format!("list[{}]", joined(shapes)),
        Shape::Object(_) => "dict[str, object]".to_owned(),
        Shape::Map(shape) => format!("dict[str, {}]", typed(shape)),
        Shape::Named(name) => name.clone(),
        Shape::Any(shapes) => joined(shapes),
    }
}
