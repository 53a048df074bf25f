//! The keys that every question has.

use serde::de::Error;
use serde::{Deserialize, Deserializer};
use serde_json::Value;

use super::Readings;
use super::keys::keys;
use super::rows::OfRows;

/// A number of significant digits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Digits(pub(super) u16);

impl Digits {
    /// Returns the number: from 1 to 1000.
    pub fn get(self) -> usize {
        usize::from(self.0)
    }
}

impl<'de> Deserialize<'de> for Digits {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let value = Value::deserialize(deserializer)?;
        let digits = value.as_u64().and_then(|digits| u16::try_from(digits).ok());
        digits
            .filter(|digits| (1..=1000).contains(digits))
            .map(Digits)
            .ok_or_else(|| D::Error::custom(format!("{value}: expected an integer from 1 to 1000")))
    }
}

keys! {
    /// The form of an answer, and the name of the table in it. A surface that writes answers elsewhere has its own ways to say it.
    AnswerWords {
        /// The name of the table in reports and messages.
        "file" file: Option<String>,
        /// The number of each row of the table, ascending, unless they are 1, 2, 3: such as `[3, [7, 8], 20]`. Reports, `rows` and
        /// `without` use these numbers.
        "row_numbers" row_numbers: Vec<OfRows>,
        /// The form of the answer, one of those that the question has: such as `json` or `text`.
        "format" format: Option<String>,
        /// The number of significant digits of decimals.
        #[cfg_attr(feature = "schema", schemars(with = "Option<u16>", range(min = 1, max = 1000)))]
        "digits" digits: Option<Digits>,
        /// The rounding of the ends of intervals in reports: `outward` or `nearest`.
        "rounding" rounding: Option<String>,
        /// `true` shows numbers of reports as fractions.
        "exact" exact: bool,
    }
}

keys! {
    /// The keys that every question has beside its own.
    Common {} with {
        /// The readings that are asked about.
        readings: Readings,
        /// The form of the answer.
        answer: AnswerWords,
    }
}
