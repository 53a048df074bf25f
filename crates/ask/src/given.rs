//! Numbers as a request gives them.

use boundfit_exact::{Limits, ParseNumberError, Rational, Reading};
use serde::de::Error;
use serde::{Deserialize, Deserializer};
use serde_json::Value;

use crate::refusal::{Refusal, ValueProblem};

/// A number of a request. A text such as `"0.1"` is read as the table's texts are; `{"exact": "1/3"}` and an integer are exactly what
/// they say.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(deny_unknown_fields, untagged))]
pub enum Given {
    /// `"0.1"`: the nearest double of it where the table is read as doubles.
    Read(String),
    /// `{"exact": "1/3"}`: one third, whatever the table is read as.
    Exact {
        /// The text.
        exact: String,
    },
    /// An integer, which is the same either way.
    Integer(i64),
}

// A derived reader of an untagged enumeration tries one variant after the other, and writes an error for each that fails.
impl<'de> Deserialize<'de> for Given {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let given = match Value::deserialize(deserializer)? {
            Value::String(text) => Some(Given::Read(text)),
            Value::Number(number) => number.as_i64().map(Given::Integer),
            Value::Object(mut object) => match (object.remove("exact"), object.is_empty()) {
                (Some(Value::String(exact)), true) => Some(Given::Exact { exact }),
                _ => None,
            },
            _ => None,
        };
        given.ok_or_else(|| D::Error::custom("a number as text, or {\"exact\": \"1/3\"}"))
    }
}

/// The texts of both ends of a range such as `-10..10`. A third point could belong to either end, as in `0...10`; there is no range
/// then.
pub fn ends(text: &str) -> Option<(&str, &str)> {
    text.split_once("..").filter(|(_, upper)| !upper.starts_with('.'))
}

impl Given {
    /// Returns the reading of the number, where those of the table are read like that.
    pub(crate) fn reading(&self, reading: Reading) -> Reading {
        match self {
            Given::Read(_) => reading,
            Given::Exact { .. } | Given::Integer(_) => Reading::Decimal,
        }
    }

    /// The number.
    pub(crate) fn number(&self, reading: Reading, limits: &Limits) -> Result<Rational, ParseNumberError> {
        match self {
            Given::Read(text) | Given::Exact { exact: text } => self.reading(reading).read(text, limits),
            Given::Integer(number) => Ok(Rational::from(*number)),
        }
    }

    /// The number of a key, exactly as it is written.
    pub(crate) fn exact(
        &self,
        key: &'static str,
        expected: &'static str,
        limits: &Limits,
    ) -> Result<Rational, Refusal> {
        let number = self.number(Reading::Decimal, limits);
        number.map_err(|error| self.refused(key, ValueProblem::Number { error, expected }))
    }

    /// Returns the refusal of the number as the value of a key.
    pub(crate) fn refused(&self, key: &'static str, problem: ValueProblem) -> Refusal {
        Refusal::Value { key, text: self.text(), problem }
    }

    /// Returns the text as it was given.
    pub(crate) fn text(&self) -> String {
        match self {
            Given::Read(text) | Given::Exact { exact: text } => text.clone(),
            Given::Integer(number) => number.to_string(),
        }
    }
}
