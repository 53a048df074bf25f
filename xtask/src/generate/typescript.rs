//! Declarations for TypeScript.

use std::fmt::Write;

use super::model::{Body, Definition, Document, Field, Shape, all};

/// A module with a type for each document and each of its parts.
pub(super) fn declarations(documents: &[Document]) -> String {
    let mut text = "// The documents that boundfit writes, of which `run` of boundfit.mjs answers with the first; made by `cargo xtask generate`.\n\
         // `JSON.parse(run(table, options))` is a `FitDocument`.\n"
        .to_owned();
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
    for Field { name, description, is_required, shape } in fields {
        comment(&mut text, &format!("{indent}  "), description);
        let mark = if *is_required { "" } else { "?" };
        text.push_str(&format!("{indent}  {name}{mark}: {};\n", typed(shape)));
    }
    text + indent + "}"
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
        Shape::Map(shape) => format!("Record<string, {}>", typed(shape)),
        Shape::Named(name) => name.clone(),
        Shape::Any(shapes) => joined(shapes, " | "),
    }
}
