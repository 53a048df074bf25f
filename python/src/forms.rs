//! In which words an answer is given.

pub(crate) use boundfit::ask::Form;
use boundfit::report::{Document, Style};
use pyo3::prelude::*;

use crate::numbers::refuse;
use crate::readings::Readings;

/// What proofs may be about.
pub(crate) const NO_TEXT: &str = "a proof is about the rows of plain delimited text, and the file is none that the checkers read: \
                                  save the table as CSV, or hand over its columns";

/// The form with this name.
fn named(name: &str) -> PyResult<Form> {
    let found = Form::ALL.into_iter().find(|form| form.name() == name);
    found.ok_or_else(|| {
        refuse(format_args!(
            "format={name:?}: expected \"text\", \"markdown\", \"latex\", \"csv\" or \"json\""
        ))
    })
}

/// A document in one of its own forms.
pub(crate) fn of(form: Form, document: &Document) -> String {
    match form {
        Form::Latex => document.to_latex(),
        Form::Markdown => document.to_markdown(),
        _ => document.to_text(),
    }
}

/// What can be asked, and as the text that a proof is about.
pub(crate) trait Written: Sync + Sized {
    fn as_text(&self) -> Self;
}

impl Written for Readings {
    fn as_text(&self) -> Self {
        self.written()
    }
}

/// Asks readings while the interpreter is free; for a proof they are the text that it is about.
pub(crate) fn asked<R: Written>(
    py: Python<'_>,
    readings: &R,
    form: &str,
    digits: Option<usize>,
    ask: impl Fn(&R, Form, &Style) -> Result<String, String> + Send + Sync,
) -> PyResult<String> {
    let form = named(form)?;
    let style = Style { digits, ..Style::default() };
    let answer = py.detach(|| match form {
        Form::Proof => ask(&readings.as_text(), form, &style),
        _ => ask(readings, form, &style),
    });
    answer.map_err(refuse)
}
