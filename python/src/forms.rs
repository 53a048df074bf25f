//! The forms of an answer.

pub(crate) use boundfit::ask::Form;
use boundfit::ask::Refusal;
use boundfit::report::Style;
use pyo3::prelude::*;

use crate::numbers::refuse;
use crate::questions::refused;
use crate::readings::Readings;
use crate::waiting::{Stop, waiting};

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
    readings: &Bound<'_, Readings>,
    form: &str,
    digits: Option<usize>,
    ask: impl Fn(&Readings, Form, &Style, &Stop) -> Result<String, Refusal> + Send + 'static,
) -> PyResult<String> {
    let form = named(form)?;
    let style = Style { digits, ..Style::default() };
    let held = readings.clone().unbind();
    let answer = waiting(readings.py(), move |stop| match form {
        Form::Proof => ask(&held.get().written(), form, &style, stop),
        _ => ask(held.get(), form, &style, stop),
    })?;
    answer.map_err(|refusal| refused(readings.py(), &refusal, readings.get().has_limits()))
}
