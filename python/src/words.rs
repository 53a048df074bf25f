//! The faults of a table in the words of this package.

use std::io::ErrorKind;

use boundfit::engine::exact::Limit;
use boundfit::files::{InputError, InputErrorKind, Setting, Way};
use pyo3::prelude::*;

use crate::numbers::refuse;

/// The arguments with values that are asked about, and the names of their tables.
pub(crate) const ASKED: [&str; 2] = ["at", "from_"];

/// Returns the fault of a table, in the words of this package, to a call that has an argument `limits` or not.
pub(crate) fn in_words(error: &InputError, has_limits: bool) -> String {
    // Columns in memory have this name, and no header.
    let text = error
        .to_string()
        .replace("readings: the file has a header but no data rows", "readings: the columns are empty");
    let is_asked = ASKED.contains(&error.file.raw());
    let ways = error.ways().into_iter().filter(|way| !is_asked || way.setting != Setting::Missing);
    let ways: Vec<String> = ways.filter_map(|way| as_argument(&way, has_limits)).collect();
    if ways.is_empty() { text } else { format!("{text}; {}", ways.join(", ")) }
}

/// The exception about a table; of a file that is not there also a `FileNotFoundError`.
pub(crate) fn refused(py: Python<'_>, error: &InputError, has_limits: bool) -> PyErr {
    let words = in_words(error, has_limits);
    match &error.kind {
        InputErrorKind::Io(own) if own.kind() == ErrorKind::NotFound => {
            let raised = py.import("boundfit._missing").and_then(|module| module.getattr("MissingFile"));
            raised
                .and_then(|kind| kind.call1((words, error.file.raw())))
                .map_or_else(|error| error, PyErr::from_value)
        }
        _ => refuse(words),
    }
}

/// A way out as this package has it: `decimal="comma" reads 1,5`; none where the call has no such argument.
pub(crate) fn as_argument(way: &Way, has_limits: bool) -> Option<String> {
    let Way { setting, value, effect } = way;
    Some(match setting {
        // It has an argument of its own.
        Setting::Limit(Limit::Steps) => format!("max_steps=... {effect}"),
        Setting::Limit(_) if !has_limits => return None,
        Setting::Limit(limit) => format!("limits={{\"{}\": ...}} {effect}", limit.name()),
        setting => {
            let value = match *value {
                "" => "True".to_owned(),
                number @ "N" => number.to_owned(),
                quoted if quoted.starts_with('"') => quoted.to_owned(),
                text => format!("\"{}\"", text.trim_matches('\'')),
            };
            format!("{}={value} {effect}", setting.name().replace(' ', "_"))
        }
    })
}
