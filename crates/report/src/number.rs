//! A number of the JSON documents.

use std::fmt;

use boundfit_exact::{Rational, Rounding};
use serde::ser::{Serialize, SerializeStruct, Serializer};

use crate::style::Reader;

/// A number in JSON: `{"exact": "p/q", "decimal": "1.8194e-3", "value": 0.0018194243326268529}`, where the value is the
/// nearest double and null beyond the largest one; `exact` is null where the fraction is too long to be written, or there is none. A person gets
/// the decimal without powers of ten and no value. It becomes text only where it is written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Number {
    /// The number, or one that rounds like it.
    value: Rational,
    is_exact: bool,
    digits: usize,
    rounding: Rounding,
    reader: Reader,
}

impl Number {
    /// A number with a decimal of so many significant digits, rounded in this way.
    pub(crate) fn rounded(value: &Rational, digits: usize, rounding: Rounding, reader: Reader) -> Self {
        Number { value: value.clone(), is_exact: true, digits, rounding, reader }
    }

    /// A number without its fraction, from one that is rounded like it to so many digits and to binary64.
    pub(crate) fn without_fraction(alike: Rational, digits: usize, reader: Reader) -> Self {
        Number { value: alike, is_exact: false, digits, rounding: Rounding::Nearest, reader }
    }

    /// A number that is no fraction, from one that is rounded like it in this way to so many digits and to binary64.
    pub(crate) fn irrational(alike: Rational, digits: usize, rounding: Rounding, reader: Reader) -> Self {
        Number { value: alike, is_exact: false, digits, rounding, reader }
    }

    /// Whether the fraction is too long to be written.
    pub(crate) fn lacks_fraction(&self) -> bool {
        !self.is_exact
    }
}

impl Serialize for Number {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let decimal = self.value.decimal(self.digits, self.rounding);
        let mut fields = serializer.serialize_struct("Number", 3)?;
        fields.serialize_field("exact", &self.is_exact.then_some(Written(&self.value)))?;
        match self.reader {
            Reader::Person => fields.serialize_field("decimal", &Written(decimal))?,
            Reader::Program => {
                fields.serialize_field("decimal", &Written(decimal.compact()))?;
                fields.serialize_field("value", &self.value.to_finite_f64())?;
            }
        }
        fields.end()
    }
}

/// Something with a text as a string in JSON, without a `String` between.
struct Written<T>(T);

impl<T: fmt::Display> Serialize for Written<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(&self.0)
    }
}
