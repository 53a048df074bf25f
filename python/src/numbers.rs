//! Exact numbers on their way to and from Python.

use boundfit::files::Limits;
use boundfit::num_rational::BigRational;
use boundfit::{Number as _, Rational, Reading};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyFloat, PyType};

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
