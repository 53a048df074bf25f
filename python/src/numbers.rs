//! Exact numbers on their way to and from Python.

use boundfit::engine::exact::{ParseNumberError, Shortest};
use boundfit::files::Limits;
use boundfit::num_rational::BigRational;
use boundfit::{Rational, Reading};
use pyo3::Borrowed;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyFloat, PyInt, PyString, PyType};

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

/// Returns the exact value of an object that another program computed. A float, long or short, is the stored number; a text, and an
/// object that prints as a number, is read as a decimal or a fraction.
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

/// Returns the text of an object that prints as a number, or is a number of which only some digits are printed.
pub(crate) fn printed(value: &Bound<'_, PyAny>) -> PyResult<String> {
    if let Some(number) = binary(value)? {
        return Ok(number.to_string());
    }
    let error = match value.str() {
        Ok(text) => return Ok(text.to_str()?.to_owned()),
        Err(error) => error,
    };
    // Python does not print integers of more than 4,300 digits.
    let (Ok(numerator), Ok(denominator)) = (value.getattr("numerator"), value.getattr("denominator")) else {
        return Err(error);
    };
    let wide = BigRational::new_raw(numerator.extract()?, denominator.extract()?);
    if wide.numer().bits().max(wide.denom().bits()) > most_bits() {
        return Err(too_long());
    }
    Ok(wide.to_string())
}

/// Returns the stored number of a float of numpy, as a text that is exactly it.
fn stored_float(float: &Bound<'_, PyAny>, shown: &str) -> PyResult<String> {
    const LONGEST_DOUBLE: usize = 8;
    // A quantity of astropy has a unit, and is no number.
    let plain = float
        .call_method0("__float__")
        .map_err(|_| refuse(format_args!("{shown}: not a number without a unit")));
    let double: f64 = plain?.extract()?;
    if float.getattr("dtype")?.getattr("itemsize")?.extract::<usize>()? <= LONGEST_DOUBLE {
        return Ok(stored_text(double));
    }
    // An array without dimensions has no ratio, but the number in it has.
    let ratio = float.call_method0("item")?.call_method0("as_integer_ratio");
    // Neither infinity nor NaN has a ratio.
    let Ok(ratio) = ratio else { return Ok(shown.to_owned()) };
    let (numerator, denominator) = ratio.extract()?;
    Ok(BigRational::new_raw(numerator, denominator).to_string())
}

/// A number that an argument gives, or words such as those of a law. A float means what floats mean in the readings: its shortest
/// text, or what is stored. Everything else is exactly what it prints.
pub(crate) struct Given {
    /// The shortest text of a float, the text of everything else.
    pub(crate) shown: String,
    /// The text of the stored number, of a float.
    stored: Option<String>,
    is_text: bool,
}

impl<'py> FromPyObject<'_, 'py> for Given {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        if let Ok(float) = object.cast::<PyFloat>() {
            let value = float.value();
            return Ok(Given {
                shown: shortest_text(value),
                stored: Some(stored_text(value)),
                is_text: false,
            });
        }
        let object = unwrapped(&object)?;
        if object.is_instance_of::<PyFloat>() {
            return object.extract();
        }
        let shown = printed(&object)?;
        // Neither short nor long floats of numpy are a `float`.
        let stored = match kind_of(&object)? {
            Some('f') => Some(stored_float(&object, &shown)?),
            Some('m' | 'M') => return Err(refuse(format_args!("{shown} is a time, not a number"))),
            _ => None,
        };
        Ok(Given { shown, stored, is_text: object.is_instance_of::<PyString>() })
    }
}

impl Given {
    /// Returns the text to read as a decimal: for a float under the binary64 reading, all digits of the stored
    /// double.
    pub(crate) fn text(&self, reading: Reading) -> String {
        match (&self.stored, reading) {
            (Some(stored), Reading::Binary64) => stored.clone(),
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
