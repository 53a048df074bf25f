//! Columns on their way from Python: buffers of numbers are copied once, all else is read as its text.

use boundfit::files::{MemoryNumbers, MemoryTable};
use pyo3::buffer::{Element, PyBuffer};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyFloat, PyInt, PyList, PyString};

/// A column with its name.
pub(crate) type NamedColumn<'py> = (String, Bound<'py, PyAny>);

/// A table of columns.
pub(crate) fn table(columns: &[NamedColumn<'_>]) -> PyResult<MemoryTable> {
    let mut table = MemoryTable::default();
    for (name, values) in columns {
        table.push(name.as_str(), numbers(name, values)?);
    }
    Ok(table)
}

/// The cells of a column: of a buffer of one dimension, or of a list.
pub(crate) fn numbers(name: &str, values: &Bound<'_, PyAny>) -> PyResult<MemoryNumbers> {
    let Ok(list) = values.cast::<PyList>() else { return of_buffer(name, values) };
    let floats: Option<Vec<f64>> =
        list.iter().map(|value| value.cast::<PyFloat>().ok().map(|float| float.value())).collect();
    if let Some(floats) = floats {
        return Ok(MemoryNumbers::Doubles(floats));
    }
    let texts = (1..).zip(list.iter()).map(|(row, value)| {
        text(&value).map_err(|problem| {
            let problem = problem.value(values.py());
            PyValueError::new_err(format!("row {row} of {name}: {problem}"))
        })
    });
    Ok(MemoryNumbers::Texts(texts.collect::<PyResult<_>>()?))
}

/// A number as its shortest text; nothing where there is none.
fn text(value: &Bound<'_, PyAny>) -> PyResult<String> {
    if let Ok(text) = value.cast::<PyString>() {
        return Ok(text.to_str()?.to_owned());
    }
    if let Ok(float) = value.cast::<PyFloat>() {
        return Ok(format!("{:?}", float.value()));
    }
    if value.cast::<PyBool>().is_ok() {
        return Err(PyValueError::new_err(format!("{value} is a truth value, not a number")));
    }
    let kind = value.get_type();
    let kind = kind.name()?;
    match kind.to_str()? {
        "NoneType" | "NAType" => Ok(String::new()),
        "Decimal" | "Fraction" => Ok(value.str()?.to_str()?.to_owned()),
        _ if value.cast::<PyInt>().is_ok()
            || value.hasattr("__index__")?
            || value.hasattr("__float__")? =>
        {
            Ok(value.str()?.to_str()?.to_owned())
        }
        other => Err(PyValueError::new_err(format!(
            "{other} is not a number (expected an int, a float, a Decimal, a Fraction or a text)"
        ))),
    }
}

fn of_buffer(name: &str, values: &Bound<'_, PyAny>) -> PyResult<MemoryNumbers> {
    if let Some(doubles) = copied::<f64>(name, values)? {
        return Ok(MemoryNumbers::Doubles(doubles));
    }
    if let Some(floats) = copied::<f32>(name, values)? {
        return Ok(MemoryNumbers::Floats(floats));
    }
    if let Some(integers) = copied::<i64>(name, values)? {
        return Ok(MemoryNumbers::Integers(integers));
    }
    let shorter = [
        widened::<i32>(name, values)?,
        widened::<i16>(name, values)?,
        widened::<i8>(name, values)?,
        widened::<u32>(name, values)?,
        widened::<u16>(name, values)?,
        widened::<u8>(name, values)?,
    ];
    if let Some(integers) = shorter.into_iter().flatten().next() {
        return Ok(MemoryNumbers::Integers(integers));
    }
    if let Some(integers) = copied::<u64>(name, values)? {
        return Ok(MemoryNumbers::Texts(integers.iter().map(ToString::to_string).collect()));
    }
    let kind = values.get_type();
    Err(PyValueError::new_err(format!(
        "{name} is of type {}: expected an array or a list of numbers",
        kind.name()?
    )))
}

fn widened<T: Element + Into<i64>>(name: &str, values: &Bound<'_, PyAny>) -> PyResult<Option<Vec<i64>>> {
    Ok(copied::<T>(name, values)?.map(|own| own.into_iter().map(Into::into).collect()))
}

/// The elements of a buffer of this type; `None` where it is of another one, or there is none.
fn copied<T: Element>(name: &str, values: &Bound<'_, PyAny>) -> PyResult<Option<Vec<T>>> {
    let Ok(buffer) = PyBuffer::<T>::get(values) else { return Ok(None) };
    if buffer.dimensions() != 1 {
        return Err(PyValueError::new_err(format!(
            "{name} has {} dimensions: expected a column, which has one",
            buffer.dimensions()
        )));
    }
    buffer.to_vec(values.py()).map(Some)
}
