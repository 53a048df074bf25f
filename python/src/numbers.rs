//! Exact numbers on their way to and from Python.

use boundfit::engine::exact::{ParseNumberError, Shortest};
use boundfit::files::Limits;
use boundfit::num_rational::BigRational;
use boundfit::{Rational, Reading};
use pyo3::Borrowed;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyBool, PyDict, PyFloat, PyInt, PyString, PyTuple, PyType};

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

/// Returns the exact value of an object that another program computed. A float, long or short, is the stored number; a text is read
/// as a decimal or a fraction.
pub(crate) fn exact(object: &Bound<'_, PyAny>, name: &str) -> PyResult<Rational> {
    object.extract::<Given>()?.number(Reading::Binary64, name)
}

/// Returns the reading with this name.
pub(crate) fn reading_named(name: &str) -> PyResult<Reading> {
    let found = [Reading::Decimal, Reading::Binary64].into_iter().find(|reading| reading.name() == name);
    found.ok_or_else(|| refuse(format_args!("reading={name:?}: expected one of \"decimal\", \"binary64\"")))
}

/// Returns the value in a scalar of pyarrow, a short float as one of numpy, and any other object as it is.
pub(crate) fn unwrapped<'py>(value: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    if !value.hasattr("as_py")? {
        return Ok(value.clone());
    }
    let held = value.call_method0("as_py")?;
    let short = match value.getattr("type")?.str()?.to_str()? {
        "float" => "float32",
        "halffloat" => "float16",
        _ => return Ok(held),
    };
    if held.is_none() { Ok(held) } else { value.py().import("numpy")?.getattr(short)?.call1((held,)) }
}

/// Returns the letter of the kind of a scalar of numpy, such as `f` for its floats.
pub(crate) fn kind_of(value: &Bound<'_, PyAny>) -> PyResult<Option<char>> {
    let Some(dtype) = value.getattr_opt("dtype")? else { return Ok(None) };
    let Some(kind) = dtype.getattr_opt("kind")? else { return Ok(None) };
    Ok(kind.extract::<char>().ok())
}

/// The most bits of a numerator or a denominator: a decimal digit takes less than four.
fn most_bits() -> u64 {
    4 * Limits::default().digits as u64
}

fn too_long() -> PyErr {
    refuse(format_args!("a number of more than {} digits (the limit)", Limits::default().digits))
}

/// Returns the number in a binary float of mpmath or sympy, which prints fewer digits than it has; `None` of anything else, and of
/// what is not finite.
fn binary(value: &Bound<'_, PyAny>) -> PyResult<Option<BigRational>> {
    let Some(parts) = value.getattr_opt("_mpf_")? else { return Ok(None) };
    let (sign, magnitude, exponent, _) =
        parts.extract::<(u8, Bound<'_, PyAny>, Bound<'_, PyAny>, Bound<'_, PyAny>)>()?;
    if !magnitude.is_truthy()? && exponent.is_truthy()? {
        return Ok(None);
    }
    let places = exponent.extract::<i64>().ok().filter(|places| places.unsigned_abs() <= most_bits());
    let places = places.ok_or_else(too_long)?;
    let one = PyInt::new(value.py(), 1);
    let (numerator, denominator) = (magnitude.lshift(places.max(0))?, one.lshift((-places).max(0))?);
    let numerator = if sign == 0 { numerator } else { numerator.neg()? };
    Ok(Some(BigRational::new_raw(numerator.extract()?, denominator.extract()?).reduced()))
}

/// Returns the text of a number that its type gives exactly: an integer, a fraction, a decimal, a binary float. Of anything else it is
/// what the object prints, which is no number.
pub(crate) fn printed(value: &Bound<'_, PyAny>) -> PyResult<String> {
    if let Ok(text) = value.cast::<PyString>() {
        return Ok(text.to_str()?.to_owned());
    }
    let is_truth = value.is_instance_of::<PyBool>();
    if !is_truth && let Ok(small) = value.extract::<i64>() {
        return Ok(small.to_string());
    }
    if value.is_instance(decimal_type(value.py())?)? {
        return decimal_type(value.py())?.call_method1("__str__", (value,))?.extract();
    }
    if !is_truth && let Some(number) = ratio(value)?.map_or_else(|| binary(value), |ratio| Ok(Some(ratio)))? {
        return Ok(number.to_string());
    }
    let text = value.str()?.to_str()?.to_owned();
    if Reading::Decimal.read(&text, &Limits::default()).is_err() {
        return Ok(text);
    }
    let kind = value.get_type();
    Err(refuse(format_args!(
        "{text:?} is what an object of type {} prints, which may be rounded (expected an int, a float, a Decimal, a Fraction or a text)",
        kind.name()?
    )))
}

/// `decimal.Decimal`.
fn decimal_type(py: Python<'_>) -> PyResult<&Bound<'_, PyType>> {
    static DECIMAL: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    DECIMAL.import(py, "decimal", "Decimal")
}

/// Returns the number in an object with a numerator and a denominator, or which gives its ratio or is an index; `None` of anything else.
fn ratio(value: &Bound<'_, PyAny>) -> PyResult<Option<BigRational>> {
    let parts = (value.getattr_opt("numerator")?, value.getattr_opt("denominator")?);
    let parts = match (parts, value.getattr_opt("as_integer_ratio")?) {
        ((Some(numerator), Some(denominator)), _) => Some((numerator, denominator)),
        (_, Some(ratio)) => ratio.call0().ok().and_then(|ratio| ratio.extract().ok()),
        _ => None,
    };
    let parts = match parts {
        Some((numerator, denominator)) => index(&numerator)?.zip(index(&denominator)?),
        None => index(value)?.map(|own| (own, PyInt::new(value.py(), 1).into_any())),
    };
    let Some((numerator, denominator)) = parts else { return Ok(None) };
    for part in [&numerator, &denominator] {
        if part.call_method0("bit_length")?.extract::<u64>()? > most_bits() {
            return Err(too_long());
        }
    }
    if !denominator.is_truthy()? {
        return Ok(None);
    }
    Ok(Some(BigRational::new_raw(numerator.extract()?, denominator.extract()?).reduced()))
}

/// Returns the integer that an object says it is.
fn index<'py>(object: &Bound<'py, PyAny>) -> PyResult<Option<Bound<'py, PyAny>>> {
    Ok(object.getattr_opt("__index__")?.and_then(|own| own.call0().ok()))
}

/// Returns the magnitude of a quantity of pint without a unit, and any other object as it is. Refuses quantities with a unit.
fn magnitude<'py>(value: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    let module = value.get_type().module()?;
    let (unit, numbers) = match module.to_str()?.split('.').next() {
        Some("pint") => (value.getattr_opt("units")?, "m_as"),
        Some("astropy") => (value.getattr_opt("unit")?, "to_value"),
        _ => return Ok(value.clone()),
    };
    let unit = unit.map_or_else(String::new, |unit| unit.to_string());
    if !["", "dimensionless"].contains(&unit.as_str()) {
        return Err(refuse(format_args!(
            "{value} has the unit {unit}: expected a number without one, such as that of {numbers}({unit:?})"
        )));
    }
    if numbers == "m_as" { value.getattr("magnitude") } else { Ok(value.clone()) }
}

/// A float of numpy, or what an array of one holds, which prints as many digits as somebody chose.
fn float_of_numpy<'py>(float: &Bound<'py, PyAny>) -> PyResult<(String, Bound<'py, PyAny>)> {
    let py = float.py();
    let plain = float
        .call_method0("__float__")
        .map_err(|_| refuse(format_args!("{float}: not a number without a unit")))?;
    let numpy = py.import("numpy")?;
    let scalar = numpy.call_method1("asarray", (float,))?.get_item(PyTuple::empty(py))?;
    let size = plain.extract::<f64>()?.abs();
    let options = PyDict::new(py);
    // As numpy itself prints them by default.
    let name = if size == 0.0 || !size.is_finite() || (1e-4..1e16).contains(&size) {
        options.set_item("trim", "0")?;
        "format_float_positional"
    } else {
        options.set_item("trim", "-")?;
        "format_float_scientific"
    };
    let shown: String = numpy.getattr(name)?.call((&scalar,), Some(&options))?.extract()?;
    Ok((shown, scalar))
}

/// Returns the stored number of a float of numpy, as a text that is exactly it.
fn stored_float(scalar: &Bound<'_, PyAny>, shown: &str) -> PyResult<String> {
    const LONGEST_DOUBLE: usize = 8;
    if scalar.getattr("dtype")?.getattr("itemsize")?.extract::<usize>()? <= LONGEST_DOUBLE {
        return Ok(stored_text(scalar.call_method0("__float__")?.extract()?));
    }
    // Neither infinity nor NaN has a ratio.
    let Ok(ratio) = scalar.call_method0("as_integer_ratio") else { return Ok(shown.to_owned()) };
    let (numerator, denominator) = ratio.extract()?;
    Ok(BigRational::new_raw(numerator, denominator).to_string())
}

/// A number that an argument gives, or words such as those of a law. A float means what floats mean in the readings: its shortest
/// text, or what is stored. Everything else is exactly the number that it is.
pub(crate) struct Given {
    /// The shortest text of a float, the text of everything else.
    pub(crate) shown: String,
    /// The stored number, of a float.
    stored: Option<Stored>,
    is_text: bool,
}

/// The stored number of a float. Few questions ask for its digits.
enum Stored {
    Double(f64),
    /// A text that is exactly it.
    Text(String),
}

impl<'py> FromPyObject<'_, 'py> for Given {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        if let Ok(float) = object.cast::<PyFloat>() {
            let value = float.value();
            return Ok(Given {
                shown: shortest_text(value),
                stored: Some(Stored::Double(value)),
                is_text: false,
            });
        }
        let object = magnitude(&unwrapped(&object)?)?;
        if object.is_instance_of::<PyFloat>() {
            return object.extract();
        }
        // Neither short nor long floats of numpy are a `float`.
        let (shown, stored) = match kind_of(&object)? {
            Some('f') => {
                let (shown, scalar) = float_of_numpy(&object)?;
                let stored = stored_float(&scalar, &shown)?;
                (shown, Some(Stored::Text(stored)))
            }
            Some('m' | 'M') => return Err(refuse(format_args!("{object} is a time, not a number"))),
            _ => (printed(&object)?, None),
        };
        Ok(Given { shown, stored, is_text: object.is_instance_of::<PyString>() })
    }
}

impl Given {
    /// Returns the text to read as a decimal: for a float under the binary64 reading, all digits of the stored
    /// double.
    pub(crate) fn text(&self, reading: Reading) -> String {
        match (&self.stored, reading) {
            (Some(Stored::Double(double)), Reading::Binary64) => stored_text(*double),
            (Some(Stored::Text(stored)), Reading::Binary64) => stored.clone(),
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

    fn refused(&self, error: &ParseNumberError, name: &str) -> PyErr {
        const MOST_SHOWN: usize = 40;
        let cut = self.shown.char_indices().nth(MOST_SHOWN).map(|(end, _)| &self.shown[..end]);
        let shown = cut.map_or_else(|| format!("{:?}", self.shown), |cut| format!("{cut:?}..."));
        match error.kind.is_limit() {
            true => refuse(format_args!("{name}={shown}: {error}")),
            false => refuse(format_args!(
                "{name}={shown}: {error} (expected a number, such as 0.5, \"1.30e-2\" or \"7/19\")"
            )),
        }
    }

    /// The number, if it is one, where `texts` says how texts are read.
    pub(crate) fn number_by(&self, reading: Reading, texts: Reading, name: &str) -> PyResult<Rational> {
        let number = self.read_by(texts).read(&self.text(reading), &Limits::default());
        number.map_err(|error| self.refused(&error, name))
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
