//! How far a sensor is from a straight line.

use std::sync::Arc;

use boundfit::engine::exact::Work;
use boundfit::files::{ColumnSelector, ScanOptions};
use boundfit::questions::{
    Calibration, CalibrationColumns, CalibrationError, CalibrationResponse, Linearity, LinearityOptions,
    times,
};
use boundfit::report::{
    Style, linearity_csv, linearity_document, linearity_json, linearity_proof, linearity_question,
};
use boundfit::{Rational, Reading};
use pyo3::prelude::*;

use crate::asked::{Asked, AskedTable, in_words};
use crate::cells::{NamedColumn, table};
use crate::data::Data;
use crate::forms::{self, Form, Written, asked};
use crate::numbers::{Given, refuse};
use crate::readings::check_work;

/// A calibration, and what is asked of it.
#[pyclass(frozen, module = "boundfit._boundfit")]
#[derive(Clone)]
pub(crate) struct Calibrated {
    data: Data,
    columns: CalibrationColumns,
    options: ScanOptions,
    reading: Reading,
    /// What a float means.
    floats: Reading,
    is_stored: bool,
}

impl Written for Calibrated {
    fn as_text(&self) -> Self {
        let (data, options) = self.data.written(&self.options, self.reading);
        Calibrated { data, options, ..self.clone() }
    }
}

/// The columns by name: x, then y, or y and the direction, or up and down.
fn columns(
    names: &[String],
    response: &str,
    selector: impl Fn(&str) -> ColumnSelector,
) -> PyResult<CalibrationColumns> {
    let response = match (response, names) {
        ("one", [_, y]) => CalibrationResponse::One(selector(y)),
        ("directed", [_, y, direction]) => {
            CalibrationResponse::Directed { y: selector(y), direction: selector(direction) }
        }
        ("two", [_, up, down]) => CalibrationResponse::Two { up: selector(up), down: selector(down) },
        _ => return Err(refuse("expected y, y and direction, or up and down")),
    };
    Ok(CalibrationColumns { x: selector(names.first().map_or("", String::as_str)), response })
}

/// Columns in memory.
#[pyfunction]
pub(crate) fn calibration_of_columns(
    given: Vec<NamedColumn<'_>>,
    response: &str,
    how: Asked,
) -> PyResult<Calibrated> {
    let names: Vec<String> = given.iter().map(|(name, _)| name.clone()).collect();
    let columns = columns(&names, response, ColumnSelector::name)?;
    let floats = how.reading()?;
    let (table, reading) = table(&given, &names, floats)?;
    let options = how.options(reading)?;
    Ok(Calibrated {
        data: Data::Columns(Arc::new(table)),
        columns,
        options,
        reading,
        floats,
        is_stored: false,
    })
}

/// Columns of a file.
#[pyfunction]
pub(crate) fn calibration_of_file(
    path: String,
    names: Vec<String>,
    response: &str,
    how: Asked,
    table: AskedTable,
) -> PyResult<Calibrated> {
    let data = Data::File(path);
    let (reading, is_stored) = data.reading(how.reading()?).map_err(|error| refuse(in_words(&error)))?;
    let columns = columns(&names, response, ColumnSelector::name_or_number)?;
    let options = how.file_options(&table, reading)?;
    Ok(Calibrated { data, columns, options, reading, floats: reading, is_stored })
}

/// Independent, terminal, zero-based and least-squares linearity, with hysteresis and repeatability.
#[pyfunction]
#[pyo3(signature = (calibrated, full_scale, through, form, digits))]
pub(crate) fn linearity(
    py: Python<'_>,
    calibrated: &Calibrated,
    full_scale: Option<Given>,
    through: Option<(Given, Given)>,
    form: &str,
    digits: Option<usize>,
) -> PyResult<String> {
    let floats = calibrated.floats;
    let full_scale = full_scale.map(|given| given.number(floats, "full_scale")).transpose()?;
    if full_scale.as_ref().is_some_and(|number| !number.is_positive()) {
        return Err(refuse("full_scale: expected a number above 0, such as 4"));
    }
    let through = match through {
        Some((x, y)) => [x.number(floats, "through")?, y.number(floats, "through")?],
        None => <[Rational; 2]>::default(),
    };
    let options = LinearityOptions { full_scale, through };
    asked(py, calibrated, form, digits, |calibrated, form, style| of(calibrated, &options, form, style))
}

fn of(
    calibrated: &Calibrated,
    options: &LinearityOptions,
    form: Form,
    style: &Style,
) -> Result<String, String> {
    let Calibrated { data, columns, options: how, reading, is_stored, .. } = calibrated;
    let source = data.source().map_err(|error| in_words(&error))?;
    let Calibration { readings, input } =
        Calibration::read(source, columns, how).map_err(|error| match error {
            CalibrationError::Input(error) => in_words(&error),
            of_row => of_row.to_string(),
        })?;
    let mut work = Work::default();
    let given = [options.full_scale.as_ref(), Some(&options.through[0]), Some(&options.through[1])];
    for reading in &readings {
        work.add(reading.row, [&reading.x, &reading.y].into_iter().chain(given.into_iter().flatten()));
    }
    check_work(&work, times::LINEARITY, how)?;
    let linearity = Linearity::new(&readings, options).ok_or("there are no readings")?;
    match form {
        Form::Json => {
            Ok(linearity_json(&linearity, options, &input, &data.origin(*reading, *is_stored), style))
        }
        Form::Csv => Ok(linearity_csv(&linearity)),
        Form::Proof => {
            let question = linearity_question(columns, &how.table, *reading, || data.source());
            let question = question.map_err(|error| in_words(&error))?;
            question.and_then(|question| linearity_proof(&linearity, &question)).ok_or_else(|| {
                "a proof is about the rows of plain delimited text of which each is a point of its own"
                    .to_owned()
            })
        }
        _ => {
            let origin = data.shown_origin(*reading, *is_stored);
            Ok(forms::of(form, &linearity_document(&linearity, options, &input, &origin, style)))
        }
    }
}
