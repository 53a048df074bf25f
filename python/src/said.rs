//! The keywords of a call as the words of a request.

use boundfit::Reading;
use boundfit::ask::{Asked, Readings, Request, TableWords};
use boundfit::files::ScanOptions;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyList, PyString, PyTuple};
use serde_json::{Map, Value, json};

use crate::numbers::{Given, refuse};
use crate::questions::in_words;

/// Keywords whose values are numbers, or texts in which numbers are.
const NUMBERS: [&str; 5] = ["eps", "x_eps", "x_origin", "where", "where_row"];

/// Keywords whose value is one number.
const SINGLE: [&str; 3] = ["eps", "x_eps", "x_origin"];

/// The keywords of a call, as Python hands them over.
#[derive(Clone, Copy)]
pub(crate) struct Keywords<'a, 'py>(pub(crate) &'a Bound<'py, PyDict>);

/// The meaning of texts among the numbers of a call.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Texts {
    /// Exactly what they say: beside columns in memory.
    Exact,
    /// The meaning that they would have in the file.
    AsCells,
}

impl Keywords<'_, '_> {
    /// Returns the meaning of floats: the reading of numbers, which is that of doubles where the data store these.
    pub(crate) fn reading(self, is_stored: bool) -> PyResult<Reading> {
        let words = TableWords { reading: self.named("reading")?, ..TableWords::default() };
        words.reading(is_stored).map_err(|refusal| refuse(in_words(&refusal, true)))
    }

    /// The words of the request. Among the numbers a float means what `reading` says, a text what `texts` says, and everything else is
    /// exact.
    pub(crate) fn words(self, reading: Reading, texts: Texts) -> PyResult<Readings> {
        let mut words = Map::new();
        for (key, value) in self.0 {
            let key: String = key.extract()?;
            if key == "ask" {
                continue;
            }
            let is_list = value.is_instance_of::<PyList>() || value.is_instance_of::<PyTuple>();
            if is_list && SINGLE.contains(&key.as_str()) {
                return Err(refuse(format_args!(
                    "{key}={value}: expected one number, such as 0.5 or \"1/3\""
                )));
            }
            let own = match NUMBERS.contains(&key.as_str()) {
                true => number(&value, reading, texts)?,
                false => plain(&value)?,
            };
            words.insert(key, own);
        }
        let has_limits = texts == Texts::AsCells;
        let readings =
            Readings::take(&mut words).map_err(|refusal| refuse(in_words(&refusal, has_limits)))?;
        match words.keys().next() {
            Some(key) => Err(refuse(format_args!("{key}: there is no such argument"))),
            None => Ok(readings),
        }
    }

    /// Returns the question in these words. Where they name a question, it tells whether bounds on the errors have a
    /// say.
    pub(crate) fn asked(self, reading: Reading, texts: Texts) -> PyResult<Asked> {
        let words = self.words(reading, texts)?;
        let asked = match self.named("ask")? {
            Some(name) => Request::of_keys(Map::from_iter([("ask".to_owned(), Value::String(name))]))
                .and_then(|request| request.resolve(&words, reading)),
            None => words.resolve(reading),
        };
        asked.map_err(|refusal| refuse(in_words(&refusal, texts == Texts::AsCells)))
    }

    /// Returns the question about columns in memory, and the meaning of floats. All that is said of them is exact,
    /// whatever the columns are read as.
    pub(crate) fn asked_in_memory(self) -> PyResult<(Asked, Reading)> {
        let floats = self.reading(false)?;
        let asked = self.asked(floats, Texts::Exact)?;
        Ok((Asked { options: in_memory(asked.options), ..asked }, floats))
    }

    fn named(self, key: &str) -> PyResult<Option<String>> {
        Ok(self.0.get_item(key)?.map(|own| own.extract()).transpose()?.flatten())
    }
}

/// Columns in memory have no bytes of their own, and nobody is shown their rows.
fn in_memory(options: ScanOptions) -> ScanOptions {
    ScanOptions { hash: false, list_rows: false, ..options }
}

/// A number, or several, or texts with numbers in them.
fn number(value: &Bound<'_, PyAny>, reading: Reading, texts: Texts) -> PyResult<Value> {
    if value.is_none() {
        return Ok(Value::Null);
    }
    if value.is_instance_of::<PyList>() || value.is_instance_of::<PyTuple>() {
        return value.try_iter()?.map(|own| number(&own?, reading, texts)).collect();
    }
    let given: Given = value.extract()?;
    Ok(match given.is_text() && texts == Texts::AsCells {
        true => Value::String(given.shown),
        false => json!({"exact": given.text(reading)}),
    })
}

/// A value as JSON has it; what JSON does not have is the text that it prints.
fn plain(value: &Bound<'_, PyAny>) -> PyResult<Value> {
    if value.is_none() {
        return Ok(Value::Null);
    }
    if let Ok(own) = value.cast::<PyBool>() {
        return Ok(Value::Bool(own.is_true()));
    }
    if let Ok(own) = value.cast::<PyString>() {
        return Ok(Value::String(own.to_str()?.to_owned()));
    }
    if let Ok(own) = value.extract::<u64>() {
        return Ok(own.into());
    }
    if let Ok(own) = value.cast::<PyDict>() {
        return own
            .iter()
            .map(|(key, value)| Ok((key.str()?.to_str()?.to_owned(), plain(&value)?)))
            .collect();
    }
    if value.is_instance_of::<PyList>() || value.is_instance_of::<PyTuple>() {
        return value.try_iter()?.map(|own| plain(&own?)).collect();
    }
    Ok(Value::String(value.str()?.to_str()?.to_owned()))
}
