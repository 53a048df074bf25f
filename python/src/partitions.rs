//! Parts of a table that no machine has whole: their reductions, and fits of these.

use std::sync::Arc;

use boundfit::Reading;
use boundfit::ask::Asked;
use boundfit::files::{ColumnSelector, ReducedTable, ScanOptions, Source};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};

use crate::cells::{NamedColumn, refuse_unwritten, table};
use crate::data::Data;
use crate::numbers::refuse;
use crate::readings::Readings;
use crate::said::Keywords;
use crate::words::in_words;

/// The name of reductions in messages.
const NAME: &str = "reductions";

/// Reduces columns in memory, of which those with `names` have the roles that are asked about, to the rows that decide, each with its
/// cell of the column `identity`. No rows become a reduction of none.
#[pyfunction]
pub(crate) fn reduce_part<'py>(
    py: Python<'py>,
    columns: Vec<NamedColumn<'py>>,
    names: Vec<String>,
    identity: Option<String>,
    asked: &Bound<'py, PyDict>,
) -> PyResult<Bound<'py, PyBytes>> {
    let (Asked { question, options, .. }, floats) = reducible(asked)?;
    refuse_unwritten(&columns, &names, &question)?;
    let (table, reading) = table(&columns, &names, floats)?;
    let identity = identity.map(|name| ColumnSelector::name(&name));
    let mut options = ScanOptions { identity, allow_nothing: true, ..options };
    options.table.reading = reading;
    let text = py.detach(|| written(question.reduce(Source::of_table("readings", table), &options)));
    Ok(PyBytes::new(py, &text.map_err(refuse)?))
}

/// Reduces reductions, one after the other in a text, to one.
#[pyfunction]
pub(crate) fn merge_reductions<'py>(
    py: Python<'py>,
    text: Vec<u8>,
    identity: Option<String>,
    asked: &Bound<'py, PyDict>,
) -> PyResult<Bound<'py, PyBytes>> {
    let (Asked { question, options, .. }, _) = of_reductions(asked, reading_of(&text))?;
    let identity = identity.map(|name| ColumnSelector::name(&name));
    let options = ScanOptions { identity, ..options };
    let text = py.detach(|| written(question.reduce(source(text), &options)));
    Ok(PyBytes::new(py, &text.map_err(refuse)?))
}

/// Reductions, one after the other in a text, to be fitted.
#[pyfunction]
pub(crate) fn readings_of_reductions(
    text: Vec<u8>,
    names: Vec<String>,
    asked: &Bound<'_, PyDict>,
) -> PyResult<Readings> {
    let reading = reading_of(&text);
    let keywords = Arc::new(asked.clone().unbind());
    let (asked, floats) = of_reductions(asked, reading)?;
    let data = Data::Text(NAME, text.into());
    Ok(Readings { data, names, asked, reading, floats, is_stored: false, keywords })
}

/// Returns the reading that a reduction states for its numbers: another than asked for, if that was binary64 and some
/// numbers are no doubles.
fn reading_of(text: &[u8]) -> Reading {
    let line = text.split(|byte| *byte == b'\n').next().unwrap_or_default();
    let stored = br#""reading":"binary64""#;
    let is_stored = line.windows(stored.len()).any(|part| part == stored);
    if is_stored { Reading::Binary64 } else { Reading::Decimal }
}

/// Returns the question, if a reduction can answer it, and the meaning of floats.
fn reducible(asked: &Bound<'_, PyDict>) -> PyResult<(Asked, Reading)> {
    let (asked, floats) = Keywords(asked).asked_in_memory()?;
    if asked.question.multiple_of_least.is_some() && asked.question.columns.second.is_some() {
        return Err(refuse(
            "eps: which readings decide under a multiple of the least bound is not known before all of them are, unless the model \
             is a line (expected a number or a law)",
        ));
    }
    Ok((asked, floats))
}

fn source(text: Vec<u8>) -> Source {
    Source::new(NAME, std::io::Cursor::new(text))
}

/// Returns the question about reductions of columns in memory, which have commas between their cells, whatever the
/// cells hold.
fn of_reductions(asked: &Bound<'_, PyDict>, reading: Reading) -> PyResult<(Asked, Reading)> {
    let (mut asked, floats) = reducible(asked)?;
    asked.options.table.reading = reading;
    asked.options.table.dialect.delimiter = Some(b',');
    Ok((asked, floats))
}

fn written(reduced: Result<ReducedTable, boundfit::files::InputError>) -> Result<Vec<u8>, String> {
    let mut text = Vec::new();
    let reduced = reduced.map_err(|error| in_words(&error, false))?;
    reduced.write(&mut text).map_err(|error| error.to_string())?;
    Ok(text)
}
