//! Readings with what is asked of them, to be read as often as they are asked about.

use std::sync::Arc;

use boundfit::ask::Asked;
use boundfit::engine::exact::{TooMuchWork, Work};
use boundfit::files::{ColumnSelector, Keep, Limits, ScanOptions, Source};
use boundfit::questions::Guarantee;
use boundfit::report::{Origin, proof_json};
use boundfit::{ErrorBound, Problem, Reading};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyTuple};

use crate::asked::{self, AskedTable, in_words};
use crate::cells::{NamedColumn, columns_of, table};
use crate::data::Data;
use crate::fitted::Fitted;
use crate::numbers::{Given, refuse};

/// Readings, and what is asked of them.
#[pyclass(frozen, module = "boundfit._boundfit")]
pub(crate) struct Readings {
    pub(crate) data: Data,
    /// The names of the columns in the order of their roles.
    pub(crate) names: Vec<String>,
    pub(crate) asked: Asked,
    /// How numbers are read.
    pub(crate) reading: Reading,
    /// What a float means in whatever is asked of them.
    pub(crate) floats: Reading,
    pub(crate) is_stored: bool,
    /// The arguments that they were made with, for those who make them again.
    pub(crate) made: Arc<Made>,
}

/// How readings were asked for, as Python said it.
pub(crate) struct Made {
    pub(crate) asked: Py<PyAny>,
    pub(crate) table: Option<Py<PyAny>>,
}

/// Columns in memory, each copied once.
#[pyfunction]
pub(crate) fn readings_of_columns(
    columns: Vec<NamedColumn<'_>>,
    asked: Bound<'_, PyAny>,
) -> PyResult<Readings> {
    let made = Arc::new(Made { asked: asked.clone().unbind(), table: None });
    let asked: asked::Asked = asked.extract()?;
    let names: Vec<String> = columns.iter().map(|(name, _)| name.clone()).collect();
    let floats = asked.reading()?;
    let (question, x_errors) =
        asked.question(&names, ColumnSelector::name, [floats, Reading::Decimal], &Limits::default())?;
    let (table, reading) = table(&columns, &names, floats)?;
    let options = asked.options(reading)?;
    let data = Data::Columns(Arc::new(table));
    let asked = Asked { question, x_errors, options };
    Ok(Readings { data, names, asked, reading, floats, is_stored: false, made })
}

/// Columns of a file of any format.
#[pyfunction]
pub(crate) fn readings_of_file(
    path: String,
    names: Vec<String>,
    asked: Bound<'_, PyAny>,
    table: Bound<'_, PyAny>,
) -> PyResult<Readings> {
    let made = Arc::new(Made { asked: asked.clone().unbind(), table: Some(table.clone().unbind()) });
    let (asked, table): (asked::Asked, AskedTable) = (asked.extract()?, table.extract()?);
    let data = Data::File(path);
    let (reading, is_stored) = data.reading(asked.reading()?).map_err(|error| refuse(in_words(&error)))?;
    let (question, x_errors) =
        asked.question(&names, ColumnSelector::name_or_number, [reading; 2], &table.number_limits())?;
    let options = asked.file_options(&table, reading)?;
    let asked = Asked { question, x_errors, options };
    Ok(Readings { data, names, asked, reading, floats: reading, is_stored, made })
}

#[pymethods]
impl Readings {
    /// Fits them. The interpreter is free meanwhile.
    #[pyo3(signature = (eui, confidence))]
    fn fit(&self, py: Python<'_>, eui: bool, confidence: Option<Given>) -> PyResult<Fitted> {
        let confidence = confidence.map(|given| given.number(self.floats, "confidence")).transpose()?;
        py.detach(|| {
            let problem = self.problem(Keep { eui, ..Keep::default() })?;
            let guarantee = match &confidence {
                None => None,
                Some(_) if matches!(problem.measurements.error_bound(), ErrorBound::Interval { .. }) => {
                    return Err(
                        "confidence is about error bounds around y, and lower and upper are none".to_owned()
                    );
                }
                Some(confidence) => Some(
                    Guarantee::new(&problem.measurements, confidence)
                        .ok_or("confidence: expected a number between 0 and 1, such as \"0.99\"")?,
                ),
            };
            let fit = problem.fit();
            Ok(Fitted {
                problem,
                fit,
                guarantee,
                reading: self.reading,
                floats: self.floats,
                file: self.data.path().map(str::to_owned),
                is_stored: self.is_stored,
            })
        })
        .map_err(|error: String| refuse(error))
    }

    /// How many regressors there are: one of a line, or two.
    #[getter]
    fn regressors(&self) -> usize {
        if self.asked.question.columns.second.is_some() { 2 } else { 1 }
    }

    /// What floats mean.
    #[getter]
    fn reading(&self) -> &'static str {
        self.floats.name()
    }

    /// What makes them again, with its arguments: the columns themselves, and of a file its path.
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let module = py.import("boundfit._boundfit")?;
        let made = |name: &str, arguments: Bound<'py, PyTuple>| Ok((module.getattr(name)?, arguments));
        let Made { asked, table } = &*self.made;
        match &self.data {
            Data::Columns(columns) => {
                let columns = columns_of(py, columns)?;
                made("readings_of_columns", (columns, asked).into_pyobject(py)?)
            }
            Data::Text(_, text) => {
                let arguments = (PyBytes::new(py, text), &self.names, asked);
                made("readings_of_reductions", arguments.into_pyobject(py)?)
            }
            Data::File(path) => {
                made("readings_of_file", (path, &self.names, asked, table).into_pyobject(py)?)
            }
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
    fn proof(&self, py: Python<'_>) -> PyResult<Option<String>> {
        py.detach(|| {
            let written = self.written();
            let problem = written.problem(Keep { eui: false, ..Keep::default() })?;
            Ok(proof_json(&problem, &problem.fit(), self.reading))
        })
        .map_err(|error: String| refuse(error))
    }
}

impl Readings {
    /// Another look at them.
    pub(crate) fn source(&self) -> Result<Source, String> {
        self.data.source().map_err(|error| in_words(&error))
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
            made: Arc::clone(&self.made),
        }
    }

    /// The problem; its numbers are not too long for a fit.
    pub(crate) fn problem(&self, keep: Keep) -> Result<Problem, String> {
        let Asked { question, options, .. } = &self.asked;
        let read = question.measurements(self.source()?, options, keep).map_err(|error| in_words(&error))?;
        checked(question.problem_within(read, self.most_work()))
    }

    /// The problem with every reading in memory.
    pub(crate) fn every_reading(&self, what_is: &str) -> Result<Problem, String> {
        let problem = self.problem(Keep { eui: false, ..Keep::EVERY })?;
        match problem.measurements.is_of_reductions() {
            true => Err(format!(
                "{what_is} about every reading, and the file is a reduction: ask about the table that it was made from"
            )),
            false => Ok(problem),
        }
    }

    /// Refuses a problem that takes so many times what its fit takes.
    pub(crate) fn check_problem(&self, problem: &Problem, times: u64) -> Result<(), String> {
        checked(problem.check_work(times, self.most_work()))
    }

    /// How much work is done at most.
    pub(crate) fn most_work(&self) -> u64 {
        self.asked.most_work()
    }

    /// Where they come from, for programs.
    pub(crate) fn origin(&self) -> Origin<'_> {
        self.data.origin(self.reading, self.is_stored)
    }

    /// Where they come from, for people.
    pub(crate) fn shown_origin(&self) -> Origin<'_> {
        self.data.shown_origin(self.reading, self.is_stored)
    }
}

/// Refuses so many times this work.
pub(crate) fn check_work(work: &Work, times: u64, options: &ScanOptions) -> Result<(), String> {
    checked(work.check(times, options.table.sizes.work))
}

/// What would be too much work, in words.
pub(crate) fn checked<T>(work: Result<T, TooMuchWork>) -> Result<T, String> {
    work.map_err(|error| format!("{error}; limits={{\"work\": ...}} raises it"))
}
