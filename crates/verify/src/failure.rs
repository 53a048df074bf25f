//! The reasons why data were not checked to the end.

use std::io;

use boundfit_exact::{Limit, MOST_WORK, ParseNumberError, TooMuchWork};
use thiserror::Error;

use crate::falsehood::Falsehood;

/// The reason why there is no verdict that a proof is true.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum Failure {
    /// The data cannot be read.
    #[error("cannot read: {0}")]
    Unreadable(#[source] io::Error),
    /// The data were others when they were read a second time.
    #[error("changed while it was read")]
    Changed,
    /// Something of the data is beyond a limit of the caller, which says nothing of the proof.
    #[error("{0}")]
    Refused(Refusal),
    /// A statement of the proof is false.
    #[error("{0}")]
    False(Falsehood),
}

impl Failure {
    /// Returns whether the data can be read no further.
    pub(crate) fn ends_reading(&self) -> bool {
        use Refusal::{Comparisons, Number, RowTooLong, TooManyColumns, Work};
        match self {
            Failure::Unreadable(_)
            | Failure::Refused(RowTooLong { .. } | TooManyColumns(_) | Comparisons { .. } | Work(_)) => true,
            Failure::Refused(Number { .. }) | Failure::Changed | Failure::False(_) => false,
        }
    }
}

impl From<Falsehood> for Failure {
    fn from(falsehood: Falsehood) -> Self {
        Failure::False(falsehood)
    }
}

/// The part of the data that is beyond a limit.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum Refusal {
    /// A row of more bytes than this.
    #[error("row {row}, counted with the header: more than {limit} bytes (the limit)")]
    RowTooLong {
        /// The number from 1, among those that are not blank, a header too.
        row: u64,
        /// The most bytes.
        limit: usize,
    },
    /// A row of more cells than this.
    #[error("more than {0} columns (the limit)")]
    TooManyColumns(usize),
    /// A number.
    #[error("row {row}, column {column}: {error}")]
    Number {
        /// The data row, from 1.
        row: u64,
        /// The column, from 1.
        column: usize,
        /// The limit.
        error: ParseNumberError,
    },
    /// More comparisons than are done: points and sets of statements with each row and condition.
    #[error(
        "refused: {parts} points, rays and sets compared with each of {half_planes} rows and conditions take about {products:.1e} \
         products of machine words, more than {limit} (the limit)"
    )]
    Comparisons {
        /// The number of points, rays and sets.
        parts: usize,
        /// The number of rows and conditions.
        half_planes: u64,
        /// The estimate.
        products: u64,
        /// The most that is done.
        limit: u64,
    },
    /// Long numbers, of the data or of the vertices that they are compared with.
    #[error("{0}")]
    Work(#[from] TooMuchWork),
}

impl Refusal {
    /// The limit that is passed.
    pub fn limit(&self) -> Option<Limit> {
        match self {
            Refusal::RowTooLong { .. } => Some(Limit::Line),
            Refusal::TooManyColumns(_) => Some(Limit::Columns),
            Refusal::Number { error, .. } => Limit::of_number(&error.kind),
            Refusal::Work(_) | Refusal::Comparisons { .. } => Some(Limit::Work),
        }
    }
}

/// The limits of the data.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DataLimits {
    /// The limits of one number.
    pub number: boundfit_exact::Limits,
    /// Bytes of one row without its line end.
    pub row: usize,
    /// Cells of one row.
    pub columns: usize,
    /// Products of machine words that long numbers ([`boundfit_exact::Work`]), or comparisons with every row, may take.
    pub work: u64,
}

impl Default for DataLimits {
    /// 10,000 digits, exponents up to 10,000, 16,777,216 bytes, 100,000 cells and [`MOST_WORK`].
    fn default() -> Self {
        DataLimits {
            number: boundfit_exact::Limits::default(),
            row: 1 << 24,
            columns: 100_000,
            work: MOST_WORK,
        }
    }
}
