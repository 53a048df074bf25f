//! Columns on their way from Python: buffers of numbers are copied once, all else is read as its text.

use boundfit::engine::exact::Foreign;
use boundfit::files::{EpsilonColumn, Limits, MemoryNumbers, MemoryTable, Question};
use boundfit::{Rational, Reading};
use pyo3::buffer::{Element, PyBuffer};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyBytes, PyFloat, PyInt, PyList, PyString};

use crate::numbers::{Given, kind_of, printed, refuse, shortest_text, stored_text, unwrapped};

/// A column with its name.
pub(crate) type NamedColumn<'py> = (String, Bound<'py, PyAny>);

/// A table of columns, and how its numbers are read. In the columns with these names, floats are read as `reading`
/// says, and everything else is exact. If an exact number is no double, all stored doubles become the decimals that
/// they are, which the decimal reading reads.
pub(crate) fn table(
    columns: &[NamedColumn<'_>],
    names: &[String],
    reading: Reading,
) -> PyResult<(MemoryTable, Reading)> {
    let mut taken = Vec::new();
    for (name, values) in columns {
        let is_number = names.contains(name);
        let own = if is_number { reading } else { Reading::Decimal };
        taken.push((name, numbers(name, values, own)?, is_number));
    }
    let are_numbers = || taken.iter().filter(|(_, _, is_number)| *is_number);
    let are_doubles =
        reading == Reading::Decimal || are_numbers().all(|(_, numbers, _)| are_doubles(numbers));
    if !are_doubles {
        taken
            .iter_mut()
            .filter(|(_, _, is_number)| *is_number)
            .for_each(|(_, numbers, _)| make_exact(numbers));
    }
    let mut table = MemoryTable::default();
    for (name, numbers, _) in taken {
        table.push(name.as_str(), numbers);
    }
    Ok((table, if are_doubles { reading } else { Reading::Decimal }))
}

/// Refuses floats under a bound that is half a unit of the last digit written: a float has no such digit, in whatever column it is.
pub(crate) fn refuse_unwritten(
    columns: &[NamedColumn<'_>],
    names: &[String],
    question: &Question,
) -> PyResult<()> {
    let regressors = if question.columns.second.is_some() { 2 } else { 1 };
    let needs_written = matches!(&question.columns.epsilon, EpsilonColumn::Law(law) if law.needs_written());
    let Some(response) = names.get(regressors).filter(|_| needs_written) else { return Ok(()) };
    let Some((_, values)) = columns.iter().find(|(name, _)| name == response) else { return Ok(()) };
    // A buffer is refused where it is read.
    let Ok(list) = values.cast::<PyList>() else { return Ok(()) };
    for (row, value) in (1..).zip(list.iter()) {
        let value = unwrapped(&value)?;
        let is_float = value.is_instance_of::<PyFloat>() || kind_of(&value)? == Some('f');
        // NaN is a missing number.
        if is_float && value.eq(&value)? {
            return Err(refuse(format_args!(
                "row {row} of {response}: {value} is a float, of which no last digit is written (expected texts, decimals and \
                 integers beside 'written', or eps as a number, such as 0.005)"
            )));
        }
    }
    Ok(())
}

/// Returns whether every number is a double: then the binary64 reading leaves it as it is.
fn are_doubles(numbers: &MemoryNumbers) -> bool {
    match numbers {
        MemoryNumbers::Doubles(_) | MemoryNumbers::Floats(_) => true,
        MemoryNumbers::Integers(integers) => {
            integers.iter().all(|&integer| (integer as f64) as i128 == i128::from(integer))
        }
        MemoryNumbers::Exact(numbers) => numbers.iter().all(is_double),
        // A text that is no number is missing, or refused under either reading.
        MemoryNumbers::Texts(texts) => texts.iter().all(|text| {
            Reading::Decimal.read(text, &Limits::default()).map_or(true, |number| is_double(&number))
        }),
    }
}

fn is_double(number: &Rational) -> bool {
    Rational::from_f64(number.to_f64()).is_some_and(|double| double == *number)
}

/// Stored floats as the decimals that they are; NaN is a number that is missing in either.
fn make_exact(numbers: &mut MemoryNumbers) {
    let texts = match numbers {
        MemoryNumbers::Doubles(doubles) => doubles.iter().map(|&double| stored_text(double)).collect(),
        MemoryNumbers::Floats(floats) => floats.iter().map(|&float| stored_text(float.into())).collect(),
        _ => return,
    };
    *numbers = MemoryNumbers::Texts(texts);
}

/// The cells of a column: of a buffer of one dimension, or of a list.
pub(crate) fn numbers(name: &str, values: &Bound<'_, PyAny>, reading: Reading) -> PyResult<MemoryNumbers> {
    let Ok(list) = values.cast::<PyList>() else { return of_buffer(name, values) };
    let floats: Option<Vec<f64>> =
        list.iter().map(|value| value.cast::<PyFloat>().ok().map(|float| float.value())).collect();
    if let Some(floats) = floats {
        return Ok(MemoryNumbers::Doubles(floats));
    }
    let texts = (1..).zip(list.iter()).map(|(row, value)| {
        text(&value, reading).map_err(|problem| {
            let problem = problem.value(values.py());
            PyValueError::new_err(format!("row {row} of {name}: {problem}"))
        })
    });
    Ok(MemoryNumbers::Texts(texts.collect::<PyResult<_>>()?))
}

/// Types of times, of Python and pandas, and of one that is missing.
const TIMES: [&str; 8] =
    ["datetime", "date", "time", "timedelta", "Timestamp", "Timedelta", "Period", "NaTType"];

/// A number as a text that is exactly it, of a float what `reading` says; nothing where there is none.
fn text(value: &Bound<'_, PyAny>, reading: Reading) -> PyResult<String> {
    if let Ok(text) = value.cast::<PyString>() {
        return Ok(text.to_str()?.to_owned());
    }
    if let Ok(float) = value.cast::<PyFloat>() {
        return Ok(match reading {
            Reading::Decimal => shortest_text(float.value()),
            Reading::Binary64 => stored_text(float.value()),
        });
    }
    if value.cast::<PyBool>().is_ok() {
        return Err(PyValueError::new_err(format!("{value} is a truth value, not a number")));
    }
    let kind = value.get_type();
    let kind = kind.name()?;
    match kind.to_str()? {
        "NoneType" | "NAType" => Ok(String::new()),
        _ if value.cast::<PyInt>().is_ok() => printed(value),
        _ if value.hasattr("as_py")? => text(&unwrapped(value)?, reading),
        other if TIMES.contains(&other) || matches!(kind_of(value)?, Some('m' | 'M')) => {
            Err(PyValueError::new_err(format!(
                "{value} is a time ({other}), not a number (expected numbers, such as those of (t - t0) / one second, from a time t0 on)"
            )))
        }
        _ if kind_of(value)? == Some('b') => {
            Err(PyValueError::new_err(format!("{value} is a truth value, not a number")))
        }
        "Decimal" | "Fraction" => printed(value),
        _ if value.hasattr("__index__")? || value.hasattr("__float__")? => {
            Ok(value.extract::<Given>()?.text(reading))
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

/// An array of Python's module of that name, of elements of a kind, from their bytes.
pub(crate) fn array_of<'py>(py: Python<'py>, kind: &str, bytes: Vec<u8>) -> PyResult<Bound<'py, PyAny>> {
    py.import("array")?.getattr("array")?.call1((kind, PyBytes::new(py, &bytes)))
}

/// Columns as [`table`] takes them.
pub(crate) fn columns_of<'py>(py: Python<'py>, table: &MemoryTable) -> PyResult<Vec<NamedColumn<'py>>> {
    let packed = |kind: &str, bytes: Vec<u8>| array_of(py, kind, bytes);
    let column = |(name, numbers): (&Foreign, &MemoryNumbers)| {
        let values = match numbers {
            MemoryNumbers::Doubles(own) => {
                packed("d", own.iter().flat_map(|own| own.to_ne_bytes()).collect())?
            }
            MemoryNumbers::Floats(own) => {
                packed("f", own.iter().flat_map(|own| own.to_ne_bytes()).collect())?
            }
            MemoryNumbers::Integers(own) => {
                packed("q", own.iter().flat_map(|own| own.to_ne_bytes()).collect())?
            }
            MemoryNumbers::Exact(own) => PyList::new(py, own.iter().map(ToString::to_string))?.into_any(),
            MemoryNumbers::Texts(own) => PyList::new(py, own)?.into_any(),
        };
        Ok((name.raw().to_owned(), values))
    };
    table.columns().map(column).collect()
}
