//! The limits that an input may pass. Each surface says in its own words how a limit is raised.

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
    /// The depth to which arrays and objects of JSON may be nested.
    Nesting,
    /// Bytes of memory that readings, with what a question makes of them, may take.
    Memory,
    /// Digits of the fraction of a sum over all vertices that is printed.
    Fraction,
    /// Sets of outliers that are listed.
    Sets,
    /// Crossings of two bounds where outliers are looked for.
    Steps,
    /// Readings of a lesson.
    Readings,
}

impl Limit {
    /// Every limit.
    pub const ALL: [Limit; 17] = [
        Limit::Digits,
        Limit::Exponent,
        Limit::Line,
        Limit::Columns,
        Limit::Rows,
        Limit::Elements,
        Limit::Unpacked,
        Limit::Ratio,
        Limit::Workbook,
        Limit::Work,
        Limit::Text,
        Limit::Nesting,
        Limit::Memory,
        Limit::Fraction,
        Limit::Sets,
        Limit::Steps,
        Limit::Readings,
    ];

    /// The limit that a number passes; `None` where something else is wrong with it.
    ///
    /// ```
    /// use boundfit_exact::{Limit, Limits, Reading};
    ///
    /// let refused = Reading::Decimal.read("1e999999999", &Limits::default()).unwrap_err();
    /// assert_eq!(Limit::of_number(&refused.kind), Some(Limit::Exponent));
    /// assert_eq!(Limit::Exponent.name(), "exponent");
    /// ```
    pub fn of_number(kind: &ParseNumberErrorKind) -> Option<Self> {
        match kind {
            ParseNumberErrorKind::TooManyDigits(_) => Some(Limit::Digits),
            ParseNumberErrorKind::ExponentTooLarge(_) => Some(Limit::Exponent),
            _ => None,
        }
    }

    /// The name by which every surface knows it: `digits`.
    pub fn name(self) -> &'static str {
        match self {
            Limit::Digits => "digits",
            Limit::Exponent => "exponent",
            Limit::Line => "line",
            Limit::Columns => "columns",
            Limit::Rows => "rows",
            Limit::Elements => "elements",
            Limit::Unpacked => "unpacked",
            Limit::Ratio => "ratio",
            Limit::Workbook => "workbook",
            Limit::Work => "work",
            Limit::Text => "text",
            Limit::Nesting => "nesting",
            Limit::Memory => "memory",
            Limit::Fraction => "fraction",
            Limit::Sets => "sets",
            Limit::Steps => "steps",
            Limit::Readings => "readings",
        }
    }
}
