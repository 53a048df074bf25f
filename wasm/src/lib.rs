//! The engine for JavaScript: a table and a question in, the program's own answer out.

#![forbid(unsafe_code)]

mod answer;
mod columns;
mod options;
mod polytope;
mod refusal;

use wasm_bindgen::prelude::*;

use crate::refusal::Refusal;

#[wasm_bindgen]
extern "C" {
    /// An `Error` of JavaScript.
    #[wasm_bindgen(js_name = Error)]
    pub type Refused;

    #[wasm_bindgen(constructor, js_class = "Error")]
    fn new(message: &str) -> Refused;

    #[wasm_bindgen(method, setter)]
    fn set_refusal(this: &Refused, refusal: &str);
}

impl Refused {
    fn of(refusal: &Refusal) -> Self {
        let error = Refused::new(&refusal.message);
        error.set_refusal(&refusal.json());
        error
    }
}

/// Answers a question about readings as the program does: with the JSON document of its schema, or in the `format` that is asked for.
///
/// `table` has the bytes of a table of any kind that the program reads from text, and `options` is a JSON object whose keys are the
/// program's options, with `_` in the place of `-`; `ask` names the question, which is `fit` when it is left out.
///
/// # Errors
/// Throws an `Error` that says what is wrong with the options or the table, and where; its `refusal` has the same as JSON.
#[wasm_bindgen]
pub fn run(table: Vec<u8>, options: &str) -> Result<String, Refused> {
    answer::run(table, options).map_err(|refusal| Refused::of(&refusal))
}

/// The columns of a table of which nothing is known yet, as JSON: `{"columns": ["x", "y"], "header": true,
/// "numeric": [true, true], "table": {…}}`.
///
/// `options` may have the keys that say how the table is written: `file`, `encoding`, `header`, `delimiter`, `decimal`, `thousands`,
/// `comment`, `skip_lines`, `units_row`, `block`, `missing_as`, `reading` and `limits`.
///
/// # Errors
/// Throws an `Error` that says what is wrong with the options or the table, and where; its `refusal` has the same as JSON.
#[wasm_bindgen]
pub fn columns(table: Vec<u8>, options: &str) -> Result<String, Refused> {
    columns::columns(table, options).map_err(|refusal| Refused::of(&refusal))
}

/// Returns the data of the page of `boundfit lesson`: the document of schema `boundfit/lesson/3`. The exact simplex alone answers its
/// linear programs.
///
/// `table` and `options` are as in [`run`](fn@run).
///
/// # Errors
/// Throws an `Error` that says what is wrong with the options or the table, and where; its `refusal` has the same as JSON.
#[wasm_bindgen]
pub fn lesson(table: Vec<u8>, options: &str) -> Result<String, Refused> {
    answer::lesson(table, options).map_err(|refusal| Refused::of(&refusal))
}

/// Returns the answer about half-planes: the document of schema `boundfit/polytope/1`.
///
/// `text` has one half-plane a line, such as `2x + 3y <= 6`, in UTF-8, and `options` is a JSON object whose keys may be `objective`, two
/// numbers as text, and `start`, the number of a vertex from 0.
///
/// # Errors
/// Throws an `Error` that says what is wrong with the options, or that there are too many half-planes; its `refusal` has the same as
/// JSON. What is wrong with a line is part of the answer.
#[wasm_bindgen]
pub fn polytope(text: Vec<u8>, options: &str) -> Result<String, Refused> {
    polytope::polytope(text, options).map_err(|refusal| Refused::of(&refusal))
}
