//! The forms of an answer.

pub(crate) use boundfit::ask::Form;
use boundfit::report::Style;
use pyo3::prelude::*;

use crate::numbers::refuse;
use crate::readings::Readings;

/// The form with this name.
pub(crate) fn named(name: &str) -> PyResult<Form> {
    let found = Form::ALL.into_iter().find(|form| form.name() == name);
    found.ok_or_else(|| {
        let names = Form::ALL.map(|form| format!("{:?}", form.name()));
        refuse(format_args!("format={name:?}: expected {}", names.join(", ")))
    })
}

/// Asks readings while the interpreter is free; for a proof they are the text that it is about.
pub(crate) fn asked(
    py: Python<'_>,
    readings: &Readings,
    form: &str,
    digits: Option<usize>,
    ask: impl Fn(&Readings, Form, &Style) -> Result<String, String> + Send + Sync,
) -> PyResult<String> {
    let form = named(form)?;
    let style = Style { digits, ..Style::default() };
    let answer = py.detach(|| match form {
        Form::Proof => ask(&readings.written(), form, &style),
        _ => ask(readings, form, &style),
    });
    answer.map_err(refuse)
}
