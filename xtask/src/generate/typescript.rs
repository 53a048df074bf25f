//! Declarations for TypeScript.

use std::fmt::Write;

use super::model::{Body, Definition, Document, Field, Shape, all};

/// A module with a type for each document and each of its parts, below a comment.
pub(super) fn declarations(about: &str, documents: &[Document]) -> String {
    let mut text = about.to_owned();
    for definition in all(documents) {
        let Definition { name, description, body } = definition;
        text.push('\n');
        comment(&mut text, "", description);
        match body {
            Body::Alias(shape) => writeln!(text, "export type {name} = {};", typed(shape)),
            Body::Object { fields, variants } if variants.is_empty() => {
                writeln!(text, "export interface {name} {}", block(fields, ""))
            }
            Body::Object { fields, variants } => {
                let variants: Vec<String> = variants.iter().map(|fields| block(fields, "")).collect();
                writeln!(text, "export type {name} = {} & ({});", block(fields, ""), variants.join(" | "))
            }
        }
        .unwrap_or_default();
    }
    text
}

fn block(fields: &[Field], indent: &str) -> String {
    let mut text = "{\n".to_owned();
    for field in fields {
        comment(&mut text, &format!("{indent}  "), &field.description);
        text.push_str(&format!("{indent}  {};\n", declared(field)));
    }
    text + indent + "}"
}

fn declared(Field { name, is_required, shape, .. }: &Field) -> String {
    format!("{name}{}: {}", if *is_required { "" } else { "?" }, typed(shape))
}

fn comment(text: &mut String, indent: &str, description: &str) {
    if !description.is_empty() {
        text.push_str(&format!("{indent}/** {} */\n", description.replace("*/", "* /")));
    }
}

fn typed(shape: &Shape) -> String {
    let joined = |shapes: &[Shape], between: &str| shapes.iter().map(typed).collect::<Vec<_>>().join(between);
    match shape {
        Shape::Text => "string".to_owned(),
        Shape::Integer | Shape::Number => "number".to_owned(),
        Shape::Boolean => "boolean".to_owned(),
        Shape::Null => "null".to_owned(),
        Shape::Words(words) => words.iter().map(|word| format!("\"{word}\"")).collect::<Vec<_>>().join(" | "),
        Shape::List(shape) => match shape.as_ref() {
            Shape::Any(_) | Shape::Words(_) => format!("({})[]", typed(shape)),
            _ => format!("{}[]", typed(shape)),
        },
        Shape::Repeated(shape, count) => format!("[{}]", vec![typed(shape); *count as usize].join(", ")),
        Shape::Tuple(shapes) => format!("[{}]", joined(shapes, ", ")),
        Shape::Object(fields) => {
            format!("{{ {} }}", fields.iter().map(declared).collect::<Vec<_>>().join("; "))
        }
        Shape::Map(shape) => format!("Record<string, {}>", typed(shape)),
        Shape::Named(name) => name.clone(),
        Shape::Any(shapes) => joined(shapes, " | "),
    }
}
