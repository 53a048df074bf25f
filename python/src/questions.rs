//! The questions about readings beyond their fit.

use std::sync::Arc;

use boundfit::ask::{Asked, Files, Held, Refusal, Request, Surface, Tables};
use boundfit::files::{Missing, Source, Way};
use pyo3::prelude::*;

use crate::cells::{NamedColumn, refuse_unwritten, table};
use crate::data::IN_MEMORY;
use crate::forms::{Form, asked};
use crate::numbers::{Given, Number, reading_named, refuse};
use crate::readings::Readings;
use crate::words::{ASKED, as_argument};

/// An answer about readings: `request` is what JSON says, such as `{"ask": "range"}`; further `tables` that it names are columns.
#[pyfunction]
#[pyo3(signature = (readings, request, form, digits, tables = None))]
pub(crate) fn ask(
    readings: &Bound<'_, Readings>,
    request: &str,
    form: &str,
    digits: Option<usize>,
    tables: Option<Vec<(String, Vec<NamedColumn<'_>>)>>,
) -> PyResult<String> {
    let own = readings.get();
    let has_limits = own.has_limits();
    let request = Request::parse(request).map_err(|refusal| refuse(in_words(&refusal, has_limits)))?;
    let mut held = Vec::new();
    for (name, columns) in tables.unwrap_or_default() {
        let names: Vec<String> = columns.iter().map(|(name, _)| name.clone()).collect();
        // Columns of readings, not of x that are asked about.
        if names == own.names {
            refuse_unwritten(&columns, &names, &own.asked.question)?;
        }
        let (table, reading) = table(&columns, &names, own.floats)?;
        let again = Source::of_table(name.as_str(), table).again();
        held.extend(again.map(|again| (name, again, reading)));
    }
    asked(readings, form, digits, move |readings, form, style, stop| {
        let is_document = matches!(form, Form::Text | Form::Latex | Form::Markdown);
        let origin = if is_document { readings.shown_origin() } else { readings.origin() };
        let shown = is_document.then_some(IN_MEMORY);
        let mut files = Files(readings.asked.options.clone());
        if held.iter().any(|(name, ..)| ASKED.contains(&name.as_str())) {
            // Answers are in the order of the values that are asked about.
            files.0.table.missing = Missing::Refuse;
        }
        let tables: Arc<dyn Tables> = Arc::new(Held { tables: held.clone(), shown, files });
        let options = stop.in_options(&readings.asked.options);
        let own = Asked { tables: Some(tables), options, ..readings.asked.clone() };
        let answer = request.answer(&own, readings.data.source()?, form, Some(origin), style);
        Ok(answer?.text)
    })
}

/// The text of a number that is exactly what an argument gives.
#[pyfunction]
pub(crate) fn number_text(number: Given, reading: &str) -> PyResult<String> {
    Ok(number.text(reading_named(reading)?))
}

/// Returns the fraction that an argument gives.
#[pyfunction]
pub(crate) fn number<'py>(
    py: Python<'py>,
    number: Given,
    name: &str,
    reading: &str,
) -> PyResult<Bound<'py, PyAny>> {
    Number(&number.number(reading_named(reading)?, name)?).into_pyobject(py)
}

/// The names of settings in the words of arguments.
struct Arguments {
    /// The call has an argument `limits`.
    has_limits: bool,
}

impl Surface for Arguments {
    fn key(&self, key: &str) -> String {
        // A word of the language has a stroke behind it.
        if key == "from" { "from_".to_owned() } else { key.to_owned() }
    }

    fn value(&self, key: &str, text: &str) -> String {
        let key = self.key(key);
        if text.parse::<f64>().is_ok() { format!("{key}={text}") } else { format!("{key}={text:?}") }
    }

    fn way(&self, way: &Way) -> String {
        as_argument(way, self.has_limits).unwrap_or_default()
    }
}

/// The exception about an answer that there is not, to a call that has an argument `limits` or not.
pub(crate) fn refused(py: Python<'_>, refusal: &Refusal, has_limits: bool) -> PyErr {
    match refusal {
        Refusal::Input(error) | Refusal::NoHalfPlanes(error) => crate::words::refused(py, error, has_limits),
        refusal => refuse(in_words(refusal, has_limits)),
    }
}

/// Returns the reason why there is no answer, to a call that has an argument `limits` or not.
pub(crate) fn in_words(refusal: &Refusal, has_limits: bool) -> String {
    match refusal {
        Refusal::Input(error) | Refusal::NoHalfPlanes(error) => crate::words::in_words(error, has_limits),
        // A way that the call does not have leaves the mark before it.
        refusal => {
            let words = refusal.words(&Arguments { has_limits });
            // Python names no columns of files as values.
            words
                .replace(", or FILE:COL)", ", or an array of them)")
                .trim_end_matches([' ', ',', ';'])
                .to_owned()
        }
    }
}
