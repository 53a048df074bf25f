//! The keys that every question has.

use super::Readings;
use super::keys::keys;
use super::rows::OfRows;

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
        "digits" digits: Option<u16>,
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
