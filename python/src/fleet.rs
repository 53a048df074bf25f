//! Fleets and reductions of columns in memory.

use std::collections::HashMap;

use boundfit::ask::{Groups, Shows};
use boundfit::files::{ColumnSelector, GroupFit, MemoryNumbers, Source};
use boundfit::{Rational, Reading};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyInt, PyList, PyString};

use crate::cells::{NamedColumn, array_of, numbers, refuse_unwritten, table};
use crate::numbers::refuse;
use crate::questions;
use crate::readings::Readings;
use crate::said::Keywords;
use crate::waiting::waiting;
use crate::words::in_words;

/// A number of every group: what it is called, and which way its double is rounded.
const NUMBERS: [(&str, Rounded); 11] = [
    ("theta1_lower", Rounded::Down),
    ("theta1_upper", Rounded::Up),
    ("theta2_lower", Rounded::Down),
    ("theta2_upper", Rounded::Up),
    ("theta1_central", Rounded::Nearest),
    ("theta1_error", Rounded::Around),
    ("theta2_central", Rounded::Nearest),
    ("theta2_error", Rounded::Around),
    ("theta1_least_squares", Rounded::Nearest),
    ("theta2_least_squares", Rounded::Nearest),
    ("epsilon_min", Rounded::Up),
];

#[derive(Clone, Copy)]
enum Rounded {
    Down,
    Nearest,
    Up,
    /// A number that is rounded up after the error of the nearest double of the number before is added: both doubles
    /// together state what the two numbers do.
    Around,
}

impl Rounded {
    fn double(self, value: &Rational) -> f64 {
        match self {
            Rounded::Down => value.floor_to_f64(),
            Rounded::Nearest => value.to_f64(),
            Rounded::Up | Rounded::Around => value.ceil_to_f64(),
        }
    }
}

/// An error that holds around the nearest double of a centre too: rounded up. Infinite where the centre is beyond the largest double.
fn error_around(centre: &Rational, error: &Rational) -> f64 {
    if centre.to_finite_f64().is_none() { f64::INFINITY } else { error.ceil_to_f64_beside(centre) }
}

/// A column of numbers on its way to a frame: doubles, NaN where there is none, and exact texts.
#[derive(Default)]
struct Numbers {
    doubles: Vec<u8>,
    texts: Texts,
}

/// Texts in one buffer, so that a million of them take no memory each. An empty one stands for none.
#[derive(Default)]
struct Texts {
    buffer: String,
    lengths: Vec<usize>,
}

impl Texts {
    fn push(&mut self, value: Option<&Rational>) {
        let start = self.buffer.len();
        if let Some(value) = value {
            // A String takes whatever is written.
            let _ = value.write_to(&mut self.buffer);
        }
        self.lengths.push(self.buffer.len() - start);
    }

    fn append(&mut self, later: Texts) {
        self.buffer.push_str(&later.buffer);
        self.lengths.extend(later.lengths);
    }

    fn list<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        let mut rest = self.buffer.as_str();
        let text = |&length: &usize| {
            let (text, later) = rest.split_at(length);
            rest = later;
            (length > 0).then_some(text)
        };
        PyList::new(py, self.lengths.iter().map(text))
    }
}

impl Numbers {
    fn push(
        &mut self,
        value: Option<&Rational>,
        before: Option<&Rational>,
        unbounded: Option<f64>,
        rounded: Rounded,
    ) {
        let double = match (value, before, rounded) {
            (Some(error), Some(centre), Rounded::Around) => error_around(centre, error),
            (Some(value), ..) => rounded.double(value),
            (None, ..) => unbounded.unwrap_or(f64::NAN),
        };
        self.doubles.extend_from_slice(&double.to_ne_bytes());
        self.texts.push(value);
    }
}

/// The lines about some groups.
#[derive(Default)]
struct Lines {
    keys: Vec<String>,
    rows: Vec<usize>,
    kinds: Vec<&'static str>,
    numbers: [Numbers; NUMBERS.len()],
}

impl Lines {
    fn push(&mut self, key: &str, group: &GroupFit) {
        self.keys.push(key.to_owned());
        self.rows.push(group.rows);
        self.kinds.push(group.kind.name());
        let [pui1, pui2] =
            group.pui.as_ref().map_or([None, None], |[first, second]| [Some(first), Some(second)]);
        let central = group.central.as_ref();
        let estimate = group.least_squares.as_ref();
        let values: [Option<&Rational>; NUMBERS.len()] = [
            pui1.and_then(|own| own.lower().value()),
            pui1.and_then(|own| own.upper().value()),
            pui2.and_then(|own| own.lower().value()),
            pui2.and_then(|own| own.upper().value()),
            central.map(|own| &own.theta[0]),
            central.map(|own| &own.guaranteed_error[0]),
            central.map(|own| &own.theta[1]),
            central.map(|own| &own.guaranteed_error[1]),
            estimate.map(|own| &own[0]),
            estimate.map(|own| &own[1]),
            group.least.as_ref(),
        ];
        let unbounded = |index: usize| {
            let infinity = if index.is_multiple_of(2) { f64::NEG_INFINITY } else { f64::INFINITY };
            (index < 4 && group.pui.is_some()).then_some(infinity)
        };
        let columns = self.numbers.iter_mut().zip(&NUMBERS).zip(values);
        let mut before = None;
        for (index, ((own, (_, rounded)), value)) in columns.enumerate() {
            own.push(value, before, unbounded(index), *rounded);
            before = value;
        }
    }

    fn append(&mut self, later: Lines) {
        self.keys.extend(later.keys);
        self.rows.extend(later.rows);
        self.kinds.extend(later.kinds);
        for (own, later) in self.numbers.iter_mut().zip(later.numbers) {
            own.doubles.extend(later.doubles);
            own.texts.append(later.texts);
        }
    }
}

/// Fits each group of rows with one key, as a dictionary of columns: of each number its doubles as bytes, and its exact texts.
#[pyfunction]
pub(crate) fn fit_groups<'py>(
    py: Python<'py>,
    columns: Vec<NamedColumn<'py>>,
    key: NamedColumn<'py>,
    asked: &Bound<'py, PyDict>,
) -> PyResult<Bound<'py, PyDict>> {
    let names: Vec<String> = columns.iter().map(|(name, _)| name.clone()).collect();
    let (mut asked, floats) = Keywords(asked).asked_in_memory()?;
    refuse_unwritten(&columns, &names, &asked.question)?;
    let by = ColumnSelector::name(&key.0);
    let (table, reading) = table(&columns.into_iter().chain([key]).collect::<Vec<_>>(), &names, floats)?;
    asked.options.table.reading = reading;
    let read = waiting(py, move |stop| {
        asked.options = stop.in_options(&asked.options);
        let source = Source::of_table("readings", table);
        Groups::read(&asked, source, &by, Shows::Nothing).map(|own| lines(&own))
    })?;
    let (lines, per_row) = read.map_err(|refusal| refuse(questions::in_words(&refusal, false)))?;
    let dict = PyDict::new(py);
    dict.set_item("group", lines.keys)?;
    dict.set_item("rows", lines.rows)?;
    dict.set_item("kind", lines.kinds)?;
    for ((name, _), numbers) in NUMBERS.iter().zip(lines.numbers) {
        let name = if per_row && *name == "epsilon_min" { "epsilon_factor" } else { name };
        dict.set_item(name, PyBytes::new(py, &numbers.doubles))?;
        dict.set_item(format!("{name}_exact"), numbers.texts.list(py)?)?;
    }
    Ok(dict)
}

/// A key that Python and Rust find equal for the same reasons.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Key<'a> {
    Text(&'a str),
    Integer(i64),
}

impl<'a> Key<'a> {
    fn of(value: &'a Bound<'_, PyAny>) -> Option<Self> {
        // `True` is equal to 1.
        if value.is_exact_instance_of::<PyInt>() {
            return value.extract().ok().map(Key::Integer);
        }
        let text = value.cast_exact::<PyString>().ok()?;
        text.to_str().ok().map(Key::Text)
    }
}

/// Numbers the groups of rows with equal keys in the order in which they first occur. Returns the number of each row's group as an array,
/// and the first row of each group; `None` if only Python itself knows which keys are equal.
#[pyfunction]
pub(crate) fn codes<'py>(keys: &Bound<'py, PyAny>) -> PyResult<Option<(Bound<'py, PyAny>, Vec<usize>)>> {
    let py = keys.py();
    if let Ok(keys) = keys.cast::<PyList>() {
        let keys: Vec<_> = keys.iter().collect();
        return numbered(py, keys.iter().map(Key::of));
    }
    match numbers("by", keys, Reading::Decimal)? {
        MemoryNumbers::Integers(integers) => {
            numbered(py, integers.into_iter().map(|own| Some(Key::Integer(own))))
        }
        _ => Ok(None),
    }
}

/// Numbers keys as [`codes`] says; `None` if one of them is none.
fn numbered<'py, 'a>(
    py: Python<'py>,
    keys: impl ExactSizeIterator<Item = Option<Key<'a>>>,
) -> PyResult<Option<(Bound<'py, PyAny>, Vec<usize>)>> {
    let (mut codes, mut first, mut numbers) = (Vec::with_capacity(keys.len()), Vec::new(), HashMap::new());
    let mut before = None;
    for (row, key) in keys.enumerate() {
        let Some(key) = key else { return Ok(None) };
        let next = first.len() as i64;
        // Rows of one group are often neighbours.
        let code = match before {
            Some((known, code)) if known == key => code,
            _ => *numbers.entry(key).or_insert(next),
        };
        if code == next {
            first.push(row);
        }
        before = Some((key, code));
        codes.push(code);
    }
    Ok(Some((array_of(py, "q", codes.iter().flat_map(|own| own.to_ne_bytes()).collect())?, first)))
}

/// Returns the lines about every group, and whether each reading has its own bound.
fn lines(groups: &Groups) -> (Lines, bool) {
    let (question, fleet) = (groups.question(), groups.fleet());
    let mut all = Lines::default();
    let piece = |groups: std::ops::Range<usize>| {
        let mut lines = Lines::default();
        groups.for_each(|group| lines.push(fleet.key(group).raw(), &question.of_group(fleet, group)));
        lines
    };
    let taken = fleet.in_order(piece, |lines| {
        all.append(lines);
        Ok::<(), std::convert::Infallible>(())
    });
    match taken {
        Ok(()) => (all, fleet.is_bounded_per_row()),
        Err(never) => match never {},
    }
}

/// Reduces readings to those that decide, or the union of reductions.
#[pyfunction]
pub(crate) fn reduce<'py>(readings: &Bound<'py, Readings>) -> PyResult<Bound<'py, PyBytes>> {
    let (py, held) = (readings.py(), readings.clone().unbind());
    let text = waiting(py, move |stop| {
        let readings = held.get();
        let options = stop.in_options(&readings.asked.options);
        let table = readings.asked.question.reduce(readings.source()?, &options);
        let mut text = Vec::new();
        table
            .map_err(|error| in_words(&error, readings.has_limits()))?
            .write(&mut text)
            .map_err(|error| error.to_string())?;
        Ok(text)
    })?;
    Ok(PyBytes::new(py, &text.map_err(|error: String| refuse(error))?))
}
