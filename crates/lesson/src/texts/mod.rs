//! The words of the page in every language: one table, from which the page's script and the static parts take theirs.
//!
//! The table is the files of `page/texts`: key, then one text per language. Tags of HTML are mark-up, and braces in a
//! text stand for values:
//! - `{name}`: a value;
//! - `{name:words}`: a count in words up to ten;
//! - `{name:capital}`: a value as a sentence begins;
//! - `{count|one|several}` or `{count|none|one|several}`: the form that a count asks for.
//!
//! `page/js/texts.js` reads them by the same rules.

mod language;
mod message;
mod say;
mod value;

use std::collections::BTreeMap;
use std::sync::LazyLock;

pub use language::Language;
pub use say::said;
pub(crate) use say::{escaped, html, say};
pub(crate) use value::{Message, Value, text};

/// A part of the table: its name in the folder `page/texts`, and the text of the file.
macro_rules! part {
    ($name:literal) => {
        ($name, include_str!(concat!("../../page/texts/", $name, ".json")))
    };
}

/// The parts of the table, one for each part of the page.
const PARTS: &[(&str, &str)] = &[
    part!("edit"),
    part!("interface"),
    part!("page"),
    part!("polytope"),
    part!("questions"),
    part!("start"),
    part!("table"),
    part!("teacher"),
    part!("worst-line"),
];

/// A key and its text in every language.
type Table = BTreeMap<String, BTreeMap<String, String>>;

/// The whole table. A file that cannot be read would leave its keys to be shown instead of texts; tests read all of them.
static TABLE: LazyLock<Table> =
    LazyLock::new(|| PARTS.iter().flat_map(|(_, part)| read(part).unwrap_or_default()).collect());

fn read(part: &str) -> Result<Table, serde_json::Error> {
    serde_json::from_str(part)
}

/// The text with a key; the key itself where there is none.
fn text_of(key: &str, language: Language) -> &str {
    TABLE.get(key).and_then(|texts| texts.get(language.code())).map_or(key, String::as_str)
}

/// The table as JSON, for the script.
pub(crate) fn table() -> Result<String, serde_json::Error> {
    serde_json::to_string(&*TABLE)
}

#[cfg(test)]
mod tests;
