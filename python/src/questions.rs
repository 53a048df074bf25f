//! What is asked of readings beyond their fit.

use boundfit::Reading;
use boundfit::ask::{Refusal, Request, Surface};
use boundfit::files::Way;
use pyo3::prelude::*;

use crate::asked::as_argument;
use crate::forms::{Form, asked};
use crate::numbers::{Given, refuse};
use crate::readings::Readings;

/// An answer about readings: `request` is what JSON says, such as `{"ask": "range"}`.
#[pyfunction]
#[pyo3(signature = (readings, request, form, digits))]
pub(crate) fn ask(
    py: Python<'_>,
    readings: &Readings,
    request: &str,
    form: &str,
    digits: Option<usize>,
) -> PyResult<String> {
    let request = Request::parse(request).map_err(|refusal| refuse(in_words(&refusal)))?;
    asked(py, readings, form, digits, |readings, form, style| {
        let origin = match form {
            Form::Text | Form::Latex | Form::Markdown => readings.shown_origin(),
            _ => readings.origin(),
        };
        let answer = request.answer(&readings.asked, readings.source()?, form, Some(origin), style);
        Ok(answer.map_err(|refusal| in_words(&refusal))?.text)
    })
}

/// The text of a number that is exactly what an argument gives.
#[pyfunction]
pub(crate) fn number_text(number: Given, reading: &str) -> String {
    number.text(if reading == Reading::Binary64.name() { Reading::Binary64 } else { Reading::Decimal })
}

/// What is asked in the words of arguments.
struct Arguments;

impl Surface for Arguments {
    fn key(&self, key: &str) -> String {
        key.to_owned()
    }

    fn value(&self, key: &str, text: &str) -> String {
        if text.parse::<f64>().is_ok() { format!("{key}={text}") } else { format!("{key}={text:?}") }
    }

    fn way(&self, way: &Way) -> String {
        as_argument(way)
    }
}

/// Why there is no answer.
pub(crate) fn in_words(refusal: &Refusal) -> String {
    match refusal {
        Refusal::Input(error) => crate::asked::in_words(error),
        refusal => refusal.words(&Arguments),
    }
}
