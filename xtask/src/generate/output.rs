//! The reference of the documents.

use std::collections::BTreeMap;

use super::markdown::{anchor, cell};
use super::model::{Body, Definition, Document, Field, Shape, all};

/// A page with a table for each document and each of its parts.
pub(super) fn reference(documents: &[Document]) -> String {
    let mut text = "# Documents\n\n*Reference.* This page lists every field of every JSON document that boundfit writes. Read it when your program reads an answer.\n\
         `cargo xtask generate` makes this page from the types of the answers, and with it the JSON Schemas in the folder `schema` and the types of the [JavaScript module](../wasm.md) and the [Python package](../python.md).\n\
         [Output and JSON](../output.md) says what all\ndocuments have in common.\n\n\
         A field is in every document of its kind unless the table calls it absent in some. A part that several documents share stands under\n\
         [Shared parts](#shared-parts).\n\n| schema | written by | |\n|---|---|---|\n"
        .to_owned();
    for Document { name, command, definitions, .. } in documents {
        let description = definitions.first().map(|root| root.description.as_str()).unwrap_or_default();
        text.push_str(&format!("| [`{name}`](#{}) | {command} | {} |\n", anchor(name), cell(description)));
    }
    let mut uses: BTreeMap<&str, usize> = BTreeMap::new();
    for definition in documents.iter().flat_map(|document| &document.definitions) {
        *uses.entry(&definition.name).or_default() += 1;
    }
    let is_shared =
        |definition: &Definition| uses.get(definition.name.as_str()).is_some_and(|count| *count > 1);
    for Document { name, definitions, .. } in documents {
        let own: Vec<&Definition> = definitions.iter().filter(|own| !is_shared(own)).collect();
        for (index, definition) in own.iter().enumerate() {
            let heading =
                if index == 0 { format!("\n## {name}\n") } else { format!("\n### {}\n", definition.name) };
            text.push_str(&heading);
            text.push_str(&section(definition));
        }
    }
    text.push_str("\n## Shared parts\n");
    let mut shared: Vec<&Definition> = all(documents).into_iter().filter(|own| is_shared(own)).collect();
    shared.sort_by(|one, other| one.name.cmp(&other.name));
    for definition in shared {
        text.push_str(&format!("\n### {}\n{}", definition.name, section(definition)));
    }
    text
}

pub(super) fn section(Definition { description, body, .. }: &Definition) -> String {
    let about = if description.is_empty() { String::new() } else { format!("\n{description}\n") };
    let table = match body {
        Body::Alias(shape) => format!("\n{}\n", typed(shape)),
        Body::Object { fields, variants } => {
            let own = rows(fields);
            let others = variants.iter().map(|fields| format!("\nwith\n\n{}", rows(fields)));
            format!("\n{own}{}", others.collect::<String>())
        }
    };
    about + &table
}

pub(super) fn rows(fields: &[Field]) -> String {
    let row = |field: &Field| {
        format!("| `{}` | {} | {} |\n", field.name, cell(&typed(&field.shape)), cell(&field.description))
    };
    format!("| field | type | meaning |\n|---|---|---|\n{}", fields.iter().map(row).collect::<String>())
}

fn typed(shape: &Shape) -> String {
    let joined = |shapes: &[Shape], between: &str| shapes.iter().map(typed).collect::<Vec<_>>().join(between);
    match shape {
        Shape::Text => "text".to_owned(),
        Shape::Integer => "integer".to_owned(),
        Shape::Number => "number".to_owned(),
        Shape::Boolean => "boolean".to_owned(),
        Shape::Null => "null".to_owned(),
        Shape::Words(words) => words.iter().map(|word| format!("`{word}`")).collect::<Vec<_>>().join(", "),
        Shape::List(shape) => format!("list of {}", grouped(shape)),
        Shape::Repeated(shape, count) => format!("{count} × {}", grouped(shape)),
        Shape::Tuple(shapes) => format!("[{}]", joined(shapes, ", ")),
        Shape::Object(fields) => {
            let named = fields.iter().map(|field| format!("`{}`: {}", field.name, typed(&field.shape)));
            format!("object with {}", named.collect::<Vec<_>>().join(", "))
        }
        Shape::Map(shape) => format!("object of {}", grouped(shape)),
        Shape::Named(name) => format!("[{name}](#{})", anchor(name)),
        Shape::Any(shapes) => joined(shapes, " or "),
    }
}

fn grouped(shape: &Shape) -> String {
    match shape {
        Shape::Any(_) => format!("({})", typed(shape)),
        shape => typed(shape),
    }
}
