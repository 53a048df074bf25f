//! Parts of a table that no machine has whole: their reductions, and fits of these.

use std::sync::Arc;

use boundfit::files::{ColumnSelector, Limits, Question, ReducedTable, ScanOptions, Source};
use boundfit::{Reading, ask};
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::asked::{Asked, in_words};
use crate::cells::{NamedColumn, table};
use crate::data::Data;
use crate::numbers::refuse;
use crate::readings::{Made, Readings};

/// What reductions are called in messages.
const NAME: &str = "reductions";

/// Reduces columns in memory, of which those with `names` have the roles that are asked about, to the rows that decide, each with its
/// cell of the column `identity`. No rows become a reduction of none.
#[pyfunction]
pub(crate) fn reduce_part<'py>(
    py: Python<'py>,
    columns: Vec<NamedColumn<'py>>,
    names: Vec<String>,
    identity: Option<String>,
    asked: Asked,
) -> PyResult<Bound<'py, PyBytes>> {
    let question = reducible(&asked, &names)?;
    let (table, reading) = table(&columns, &names, asked.reading()?)?;
    let options = ScanOptions {
        identity: identity.map(|name| ColumnSelector::name(&name)),
        allow_nothing: true,
        ..asked.options(reading)?
    };
    let text = py.detach(|| written(question.reduce(Source::of_table("readings", table), &options)));
    Ok(PyBytes::new(py, &text.map_err(refuse)?))
}

/// Reduces reductions, one after the other in a text, to one.
#[pyfunction]
pub(crate) fn merge_reductions<'py>(
    py: Python<'py>,
    text: Vec<u8>,
    names: Vec<String>,
    identity: Option<String>,
    asked: Asked,
) -> PyResult<Bound<'py, PyBytes>> {
    let question = reducible(&asked, &names)?;
    let identity = identity.map(|name| ColumnSelector::name(&name));
    let options = ScanOptions { identity, ..of_reductions(&asked, reading_of(&text))? };
    let text = py.detach(|| written(question.reduce(source(text), &options)));
    Ok(PyBytes::new(py, &text.map_err(refuse)?))
}

/// Reductions, one after the other in a text, to be fitted.
#[pyfunction]
pub(crate) fn readings_of_reductions(
    text: Vec<u8>,
    names: Vec<String>,
    asked: Bound<'_, PyAny>,
) -> PyResult<Readings> {
    let made = Arc::new(Made { asked: asked.clone().unbind(), table: None });
    let asked: Asked = asked.extract()?;
    let (reading, floats) = (reading_of(&text), asked.reading()?);
    let (question, options) = (reducible(&asked, &names)?, of_reductions(&asked, reading)?);
    let data = Data::Text(NAME, text.into());
    let asked = ask::Asked { options, ..ask::Asked::new(question) };
    Ok(Readings { data, names, asked, reading, floats, is_stored: false, made })
}

/// How a reduction says that its numbers are read: not as was asked, where that was binary64 and some numbers are no doubles.
fn reading_of(text: &[u8]) -> Reading {
    let line = text.split(|byte| *byte == b'\n').next().unwrap_or_default();
    let stored = br#""reading":"binary64""#;
    let is_stored = line.windows(stored.len()).any(|part| part == stored);
    if is_stored { Reading::Binary64 } else { Reading::Decimal }
}

/// The question, if a reduction can answer it.
fn reducible(asked: &Asked, names: &[String]) -> PyResult<Question> {
    let (question, _) = asked.question(
        names,
        ColumnSelector::name,
        [asked.reading()?, Reading::Decimal],
        &Limits::default(),
    )?;
    if question.multiple_of_least.is_some() && question.columns.second.is_some() {
        return Err(refuse(
            "eps: which readings decide under a multiple of the least bound is not known before all of them are, unless the model \
             is a line (expected a number or a law)",
        ));
    }
    Ok(question)
}

fn source(text: Vec<u8>) -> Source {
    Source::new(NAME, std::io::Cursor::new(text))
}

/// Reductions of columns in memory have commas between their cells, whatever is in these.
fn of_reductions(asked: &Asked, reading: Reading) -> PyResult<ScanOptions> {
    let mut options = asked.options(reading)?;
    options.table.dialect.delimiter = Some(b',');
    Ok(options)
}

fn written(reduced: Result<ReducedTable, boundfit::files::InputError>) -> Result<Vec<u8>, String> {
    let mut text = Vec::new();
    let reduced = reduced.map_err(|error| in_words(&error))?;
    reduced.write(&mut text).map_err(|error| error.to_string())?;
    Ok(text)
}
