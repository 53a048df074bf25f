//! What an input may pass, and who raises it.

use crate::ParseNumberErrorKind;

/// A limit that an input can pass.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Limit {
    /// [`Limits::digits`](crate::Limits::digits).
    Digits,
    /// [`Limits::exponent`](crate::Limits::exponent).
    Exponent,
    /// Bytes of one line.
    Line,
    /// Columns of a table of text.
    Columns,
    /// Rows that a size line may announce, and that are held in memory.
    Rows,
    /// Elements of one array of a `.mat` file.
    Elements,
    /// Bytes that a compressed file unpacks to.
    Unpacked,
    /// Bytes that a packed file unpacks to for each of its own.
    Ratio,
    /// Bytes of a workbook, packed or unpacked.
    Workbook,
    /// Products of machine words that exact arithmetic on long numbers may take ([`Work`](crate::Work)).
    Work,
    /// Bytes of a text that is held in memory whole.
    Text,
    /// How deep arrays and objects of JSON may be nested.
    Nesting,
    /// Digits of the fraction of a sum over all vertices that is printed.
    Fraction,
    /// Bytes of memory that readings, with what a question makes of them, may take.
    Memory,
}

impl Limit {
    /// The limit that a number passes; `None` where something else is wrong with it.
    ///
    /// ```
    /// use boundfit_exact::{Limit, Limits, Reading};
    ///
    /// let refused = Reading::Decimal.read("1e999999999", &Limits::default()).unwrap_err();
    /// assert_eq!(Limit::of_number(&refused.kind), Some(Limit::Exponent));
    /// assert_eq!(Limit::Exponent.flag(), "--max-exponent");
    /// ```
    pub fn of_number(kind: &ParseNumberErrorKind) -> Option<Self> {
        match kind {
            ParseNumberErrorKind::TooManyDigits(_) => Some(Limit::Digits),
            ParseNumberErrorKind::ExponentTooLarge(_) => Some(Limit::Exponent),
            _ => None,
        }
    }

    /// The program's option that raises it.
    pub fn flag(self) -> &'static str {
        match self {
            Limit::Digits => "--max-digits",
            Limit::Exponent => "--max-exponent",
            Limit::Line => "--max-line",
            Limit::Columns => "--max-columns",
            Limit::Rows => "--max-rows",
            Limit::Elements => "--max-elements",
            Limit::Unpacked => "--max-unpacked",
            Limit::Ratio => "--max-ratio",
            Limit::Workbook => "--max-workbook",
            Limit::Work => "--max-work",
            Limit::Text => "--max-text",
            Limit::Nesting => "--max-nesting",
            Limit::Fraction => "--max-fraction",
            Limit::Memory => "--limit memory=SIZE",
        }
    }
}
