//! Half-planes without readings.

use boundfit::lesson::{PolytopeOptions, polytope as answer};
use wasm_bindgen::prelude::*;

/// What there is to say about half-planes: the document of schema `boundfit/polytope/1`.
///
/// `text` has one half-plane a line, such as `2x + 3y <= 6`, in UTF-8, and `options` is a JSON object whose keys may be `objective`, two numbers as
/// text, and `start`, the number of a vertex from 0.
///
/// # Errors
/// Throws an `Error` that says what is wrong with the options, or that there are too many half-planes. What is wrong with a line is
/// part of the answer.
#[wasm_bindgen]
pub fn polytope(text: Vec<u8>, options: &str) -> Result<String, JsError> {
    let text = String::from_utf8(text).map_err(|_| JsError::new("the half-planes are no text in UTF-8"))?;
    let options: PolytopeOptions =
        serde_json::from_str(options).map_err(|error| JsError::new(&format!("options: {error}")))?;
    answer(&text, &options).map_err(|problem| JsError::new(&problem.to_string()))
}
