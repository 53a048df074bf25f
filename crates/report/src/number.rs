//! A number of the JSON documents.

use std::fmt;

use boundfit_exact::{Rational, Rounding};
use serde::ser::{Serialize, SerializeStruct, Serializer};

/// A number in JSON: `{"exact": "p/q", "decimal": "1.8194e-3"}`. It becomes text only where it is written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Number {
    exact: Rational,
    digits: usize,
    rounding: Rounding,
}

impl Number {
    /// A number with a decimal of so many significant digits, rounded in this way.
    pub fn rounded(value: &Rational, digits: usize, rounding: Rounding) -> Self {
        Number { exact: value.clone(), digits, rounding }
    }
}

impl Serialize for Number {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut fields = serializer.serialize_struct("Number", 2)?;
        fields.serialize_field("exact", &Written(&self.exact))?;
        fields.serialize_field("decimal", &Written(self.exact.decimal(self.digits, self.rounding)))?;
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
