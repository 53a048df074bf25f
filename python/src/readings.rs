//! Readings with what is asked of them, to be read as often as they are asked about.

use std::sync::{Arc, OnceLock};

use boundfit::Reading;
use boundfit::ask::{self, Asked, Fit, Form, NoProof, Refusal, Request, Shows};
use boundfit::files::Source;
use boundfit::report::{Origin, Style};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyTuple};

use crate::cells::{NamedColumn, columns_of, refuse_unwritten, table};
use crate::data::Data;
use crate::fitted::{Answered, Fitted};
use crate::numbers::{Given, refuse};
use crate::questions;
use crate::said::{Keywords, Texts};
use crate::waiting::waiting;
use crate::words::{in_words, refused};

/// Readings, and what is asked of them.
#[pyclass(frozen, module = "boundfit._boundfit")]
pub(crate) struct Readings {
    pub(crate) data: Data,
    /// The names of the columns in the order of their roles.
    pub(crate) names: Vec<String>,
    pub(crate) asked: Asked,
    /// The way in which numbers are read.
    pub(crate) reading: Reading,
    /// The meaning of a float in each question about them.
    pub(crate) floats: Reading,
    pub(crate) is_stored: bool,
    /// The keywords that they were made with, for those who make them again.
    pub(crate) keywords: Arc<Py<PyDict>>,
}

/// Columns in memory, each copied once.
#[pyfunction]
pub(crate) fn readings_of_columns(
    columns: Vec<NamedColumn<'_>>,
    asked: &Bound<'_, PyDict>,
) -> PyResult<Readings> {
    let names: Vec<String> = columns.iter().map(|(name, _)| name.clone()).collect();
    let keywords = Arc::new(asked.clone().unbind());
    let (mut asked, floats) = Keywords(asked).asked_in_memory()?;
    refuse_unwritten(&columns, &names, &asked.question)?;
    let (table, reading) = table(&columns, &names, floats)?;
    asked.options.table.reading = reading;
    let data = Data::Columns(Arc::new(table));
    Ok(Readings { data, names, asked, reading, floats, is_stored: false, keywords })
}

/// Columns of a file of any format; `names` are those of all roles.
#[pyfunction]
pub(crate) fn readings_of_file(
    path: String,
    names: Vec<String>,
    asked: &Bound<'_, PyDict>,
) -> PyResult<Readings> {
    let py = asked.py();
    let data = Data::File(path);
    let is_stored = data.is_stored().map_err(|error| refused(py, &error, true))?;
    let reading = Keywords(asked).reading(is_stored)?;
    let keywords = Arc::new(asked.clone().unbind());
    let asked = Keywords(asked).asked(reading, Texts::AsCells)?;
    Ok(Readings { data, names, asked, reading, floats: reading, is_stored, keywords })
}

#[pymethods]
impl Readings {
    /// Fits them. The interpreter is free meanwhile.
    #[pyo3(signature = (eui, confidence))]
    fn fit(slf: &Bound<'_, Self>, eui: bool, confidence: Option<Given>) -> PyResult<Fitted> {
        let (py, own) = (slf.py(), slf.get());
        let reading = own.floats;
        let confidence = confidence.map(|given| ask::Given::Exact { exact: given.text(reading) });
        let question = Fit { no_eui: !eui, confidence, ..Fit::default() };
        let fitted = if own.data.is_small() {
            py.detach(|| own.fitted(&question, &own.asked))
        } else {
            let held = slf.clone().unbind();
            waiting(py, move |stop| {
                let own = held.get();
                let options = stop.in_options(&own.asked.options);
                own.fitted(&question, &Asked { options, ..own.asked.clone() })
            })?
        };
        fitted.map_err(refuse)
    }

    /// The number of regressors: one of a line, or two.
    #[getter]
    fn regressors(&self) -> usize {
        if self.asked.question.columns.second.is_some() { 2 } else { 1 }
    }

    /// The names of the columns, in the order of their roles.
    #[getter]
    fn names(&self) -> Vec<String> {
        self.names.clone()
    }

    /// The meaning of floats.
    #[getter]
    fn reading(&self) -> &'static str {
        self.floats.name()
    }

    /// Returns the function that makes them again, with its arguments: the columns themselves, or the path of a file.
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let module = py.import("boundfit._boundfit")?;
        let made = |name: &str, arguments: Bound<'py, PyTuple>| Ok((module.getattr(name)?, arguments));
        let asked = &*self.keywords;
        match &self.data {
            Data::Columns(columns) => {
                let columns = columns_of(py, columns)?;
                made("readings_of_columns", (columns, asked).into_pyobject(py)?)
            }
            Data::Text(_, text) => {
                let arguments = (PyBytes::new(py, text), &self.names, asked);
                made("readings_of_reductions", arguments.into_pyobject(py)?)
            }
            Data::File(path) => made("readings_of_file", (path, &self.names, asked).into_pyobject(py)?),
        }
    }

    #[getter]
    fn is_in_memory(&self) -> bool {
        self.data.path().is_none()
    }

    /// The columns in memory as CSV; nothing of a file.
    fn csv<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyBytes>> {
        match &self.data {
            Data::Columns(table) => {
                let text = py.detach(|| table.to_csv(self.reading));
                Some(PyBytes::new(py, &text))
            }
            Data::Text(_, text) => Some(PyBytes::new(py, text)),
            Data::File(_) => None,
        }
    }

    /// The proof of their fit, where they are, or can be written as, delimited text.
    fn proof(slf: &Bound<'_, Self>) -> PyResult<Option<String>> {
        let held = slf.clone().unbind();
        let proof = waiting(slf.py(), move |_| {
            let own = held.get();
            let (written, question) = (own.written(), Request::Fit(Fit { no_eui: true, ..Fit::default() }));
            let origin = Some(written.origin());
            match question.answer(&written.asked, written.source()?, Form::Proof, origin, &Style::default()) {
                Ok(proof) => Ok(Some(proof.text)),
                Err(Refusal::NoProof(why)) if !matches!(why, NoProof::Reduction) => Ok(None),
                Err(refusal) => Err(questions::in_words(&refusal, own.has_limits())),
            }
        })?;
        proof.map_err(|error: String| refuse(error))
    }
}

impl Readings {
    /// Fits them as they are asked about here, and keeps what a proof that is asked for later takes.
    fn fitted(&self, question: &Fit, asked: &Asked) -> Result<Fitted, String> {
        let fittable = question.read_listing(asked, self.source()?, Shows::Rows, false);
        let deciding = fittable.and_then(|fittable| Answered::new(question, fittable));
        Ok(Fitted {
            deciding: deciding.map_err(|refusal| questions::in_words(&refusal, self.has_limits()))?,
            whole: OnceLock::new(),
            reading: self.reading,
            floats: self.floats,
            file: self.data.path().map(str::to_owned),
            is_stored: self.is_stored,
        })
    }

    /// Returns whether the call that made them has an argument `limits`: that of a file.
    pub(crate) fn has_limits(&self) -> bool {
        self.data.path().is_some()
    }

    /// Another look at them.
    pub(crate) fn source(&self) -> Result<Source, String> {
        self.data.source().map_err(|error| in_words(&error, self.has_limits()))
    }

    /// Columns in memory as the text that proofs are about, and files as they are.
    pub(crate) fn written(&self) -> Readings {
        let (data, options) = self.data.written(&self.asked.options, self.reading);
        Readings {
            data,
            names: self.names.clone(),
            asked: Asked { options, ..self.asked.clone() },
            reading: self.reading,
            floats: self.floats,
            is_stored: self.is_stored,
            keywords: Arc::clone(&self.keywords),
        }
    }

    /// Returns the source of the readings, for programs.
    pub(crate) fn origin(&self) -> Origin<'_> {
        self.data.origin(self.reading, self.is_stored)
    }

    /// Returns the source of the readings, for people.
    pub(crate) fn shown_origin(&self) -> Origin<'_> {
        self.data.shown_origin(self.reading, self.is_stored)
    }
}
