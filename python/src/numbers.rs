//! Exact numbers on their way to and from Python.

use boundfit::engine::exact::Shortest;
use boundfit::files::Limits;
use boundfit::num_rational::BigRational;
use boundfit::{Number as _, Rational, Reading};
use pyo3::Borrowed;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyFloat, PyString, PyType};

/// `fractions.Fraction`.
pub(crate) fn fraction_type(py: Python<'_>) -> PyResult<&Bound<'_, PyType>> {
    static FRACTION: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    FRACTION.import(py, "fractions", "Fraction")
}

/// A number on its way to Python.
pub(crate) struct Number<'a>(pub(crate) &'a Rational);

impl<'py> IntoPyObject<'py> for Number<'_> {
    type Target = PyAny;
    type Output = Bound<'py, PyAny>;
    type Error = PyErr;

    fn into_pyobject(self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let fraction = fraction_type(py)?;
        match self.0.to_words() {
            Some(words) => fraction.call1(words),
            None => {
                let wide = BigRational::from(self.0);
                fraction.call1((wide.numer().clone(), wide.denom().clone()))
            }
        }
    }
}

/// Two numbers on their way to Python.
pub(crate) fn pair([first, second]: &[Rational; 2]) -> (Number<'_>, Number<'_>) {
    (Number(first), Number(second))
}

/// An exception about a value.
pub(crate) fn refuse(problem: impl std::fmt::Display) -> PyErr {
    PyValueError::new_err(problem.to_string())
}

/// The exact value of an object: a float is the dyadic number that it is, texts and what prints as a number are read as decimals
/// or fractions.
pub(crate) fn exact(object: &Bound<'_, PyAny>) -> PyResult<Rational> {
    match object.cast::<PyFloat>() {
        Ok(float) => float.value().exact().map_err(refuse),
        Err(_) => object.str()?.to_str()?.exact().map_err(refuse),
    }
}

/// A number that an argument gives, or words such as those of a law. A float means what floats mean in the readings: its shortest
/// text, or what is stored. Everything else is exactly what it prints.
pub(crate) struct Given {
    /// The shortest text of a float, the text of everything else.
    pub(crate) shown: String,
    stored: Option<f64>,
    is_text: bool,
}

impl<'py> FromPyObject<'_, 'py> for Given {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        if let Ok(float) = object.cast::<PyFloat>() {
            let value = float.value();
            return Ok(Given { shown: shortest_text(value), stored: Some(value), is_text: false });
        }
        // A scalar of pyarrow is what it holds.
        if object.hasattr("as_py")? {
            return object.call_method0("as_py")?.extract();
        }
        // Short floats are no `float`.
        let is_float = match object.getattr_opt("dtype")? {
            Some(kind) => kind.getattr("kind")?.extract::<String>()? == "f",
            None => false,
        };
        let stored = if is_float { Some(object.call_method0("__float__")?.extract()?) } else { None };
        let is_text = object.is_instance_of::<PyString>();
        Ok(Given { shown: object.str()?.to_str()?.to_owned(), stored, is_text })
    }
}

impl Given {
    /// Returns the text to read as a decimal: for a float under the binary64 reading, all digits of the stored
    /// double.
    pub(crate) fn text(&self, reading: Reading) -> String {
        match (self.stored, reading) {
            (Some(double), Reading::Binary64) => stored_text(double),
            _ => self.shown.clone(),
        }
    }

    /// Returns the reading of [`Given::text`], where `texts` tells how texts are read: exactly, or beside a file as
    /// its cells.
    pub(crate) fn read_by(&self, texts: Reading) -> Reading {
        if self.is_text { texts } else { Reading::Decimal }
    }

    /// Returns whether it is a text.
    pub(crate) fn is_text(&self) -> bool {
        self.is_text
    }

    /// The number, if it is one.
    pub(crate) fn number(&self, reading: Reading, name: &str) -> PyResult<Rational> {
        self.number_by(reading, Reading::Decimal, name)
    }

    /// The number, if it is one, where `texts` says how texts are read.
    pub(crate) fn number_by(&self, reading: Reading, texts: Reading, name: &str) -> PyResult<Rational> {
        let number = self.read_by(texts).read(&self.text(reading), &Limits::default());
        number.map_err(|error| refuse(format_args!("{name}={:?}: {error}", self.shown)))
    }
}

/// A double as its shortest text, as Python prints it.
pub(crate) fn shortest_text(double: f64) -> String {
    double.in_shortest_digits(format!("{double:?}"))
}

/// A double as a text that is exactly it: its shortest text, if that is, else all of its digits, at most 1,074 behind the point.
pub(crate) fn stored_text(double: f64) -> String {
    const MOST_PLACES: usize = 1074;
    let shortest = double.shortest().map(|(mantissa, exponent)| Rational::scientific(mantissa, exponent));
    if shortest.is_none_or(|shortest| Rational::from_f64(double) == Some(shortest)) {
        return shortest_text(double);
    }
    let text = format!("{double:.MOST_PLACES$}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// A number exactly as it is written.
pub(crate) fn decimal(text: &str, name: &str) -> PyResult<Rational> {
    let number = Reading::Decimal.read(text, &Limits::default());
    number.map_err(|error| refuse(format_args!("{name}={text:?}: {error}")))
}

/// The double on the outer side of an end: at most the number for a lower end, at least for an upper one. Exact but for that.
pub(crate) fn outward(value: &Rational, is_upper: bool) -> f64 {
    let nearest = value.to_f64();
    match Rational::from_f64(nearest) {
        Some(exact) if is_upper && exact < *value => nearest.next_up(),
        Some(exact) if !is_upper && exact > *value => nearest.next_down(),
        // Beyond the largest double.
        None if is_upper && value.is_negative() => f64::MIN,
        None if !is_upper && value.is_positive() => f64::MAX,
        _ => nearest,
    }
}
