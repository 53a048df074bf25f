//! The reference of requests.

use boundfit_ask::Request;

use super::markdown::{anchor, cell};
use super::model::{Body, Document, Field, Shape};
use super::output::{rows, section};

/// A page with the keys of each question, and with those of every question.
pub(super) fn reference(request: &Document) -> String {
    let mut text = format!(
        "# Requests\n\n\
         *Reference.* This page lists every key of a request in JSON, `{}`. Read it when you call `run` of the [JavaScript module](../wasm.md), or in\n\
         Rust `boundfit::ask::Request::with_readings`. `cargo xtask generate` makes this page from the types of the request, and with it\n\
         the JSON Schema in the folder `schema` and the types in `crates/lesson/engine/request.d.mts`.\n\n\
         An unknown key is an error. Leave out every key that you do not need.\n\n\
         | `ask` | the question |\n|---|---|\n",
        request.name
    );
    let Some((root, parts)) = request.definitions.split_first() else { return text };
    let Body::Object { fields: common, variants } = &root.body else { return text };
    let questions = || variants.iter().filter_map(|fields| fields.split_first());
    for (ask, _) in questions() {
        let name = name(ask);
        text.push_str(&format!("| [`\"{name}\"`](#{}) | {} |\n", anchor(name), cell(&ask.description)));
    }
    for (ask, own) in questions() {
        let table = if own.is_empty() { "It has no keys of its own.\n".to_owned() } else { rows(own) };
        let required = own.iter().filter(|field| field.is_required);
        let required: String = required.map(|field| format!(" `{}` is required.", field.name)).collect();
        let forms = Request::FORMS.iter().filter(|(own, _)| *own == name(ask)).flat_map(|(_, forms)| *forms);
        let forms: Vec<String> = forms.map(|form| format!("`{}`", form.name())).collect();
        text.push_str(&format!("\n## {}\n\n{table}\n", name(ask)));
        text.push_str(&format!("Values of `format`: {}.{required}\n", forms.join(", ")));
    }
    text.push_str(&format!("\n## Keys of every question\n\n{}\n## Types\n", rows(common)));
    for part in parts {
        text.push_str(&format!("\n### {}\n{}", part.name, section(part)));
    }
    text
}

/// The name of a question, the one value of its first key.
fn name(ask: &Field) -> &str {
    match &ask.shape {
        Shape::Words(words) => words.first().map_or("", String::as_str),
        _ => "",
    }
}
