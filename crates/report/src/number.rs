//! A number of the JSON documents.

use std::fmt;

use boundfit_exact::{Rational, Rounding};
use serde::ser::{Serialize, SerializeStruct, Serializer};

use crate::style::Reader;

/// A number in JSON: `{"exact": "p/q", "decimal": "1.8194e-3", "value": 0.0018194243326268529}`, where the value is the
/// nearest double and null beyond the largest one. A person gets the decimal without powers of ten and no value. It becomes
/// text only where it is written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Number {
    exact: Rational,
    digits: usize,
    rounding: Rounding,
    reader: Reader,
}

impl Number {
    /// A number with a decimal of so many significant digits, rounded in this way.
    pub(crate) fn rounded(value: &Rational, digits: usize, rounding: Rounding, reader: Reader) -> Self {
        Number { exact: value.clone(), digits, rounding, reader }
    }
}

impl Serialize for Number {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let decimal = self.exact.decimal(self.digits, self.rounding);
        let mut fields = serializer.serialize_struct("Number", 3)?;
        fields.serialize_field("exact", &Written(&self.exact))?;
        match self.reader {
            Reader::Person => fields.serialize_field("decimal", &Written(decimal))?,
            Reader::Program => {
                fields.serialize_field("decimal", &Written(decimal.compact()))?;
                fields.serialize_field("value", &self.exact.to_finite_f64())?;
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
