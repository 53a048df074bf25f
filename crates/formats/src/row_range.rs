//! Data rows from one to another.

use std::fmt;
use std::ops::Range;

/// Data rows from a first to a last one, counted from 1, both included; without a last one, to the end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct RowRange {
    first: usize,
    last: Option<usize>,
}

impl RowRange {
    /// The range, or `None` unless `1 ≤ first ≤ last`.
    pub fn new(first: usize, last: usize) -> Option<Self> {
        (1 <= first && first <= last).then_some(RowRange { first, last: Some(last) })
    }

    /// All rows from this one on, or `None` for row 0, which no table has.
    pub fn from_row(first: usize) -> Option<Self> {
        (1 <= first).then_some(RowRange { first, last: None })
    }

    /// The first and the last row; `None` where it reaches to the end.
    pub fn ends(&self) -> (usize, Option<usize>) {
        (self.first, self.last)
    }

    /// Returns whether it names a row beyond the last of so many.
    pub(crate) fn is_beyond(&self, total: usize) -> bool {
        self.last.unwrap_or(self.first) > total
    }

    /// The rows, without the end.
    pub(crate) fn rows(&self) -> Range<usize> {
        self.first..self.last.map_or(usize::MAX, |last| last.saturating_add(1))
    }
}

/// Writes the range as on the command line: `5`, `14..36`, `10..`.
impl fmt::Display for RowRange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.last {
            Some(last) if last == self.first => write!(f, "{last}"),
            Some(last) => write!(f, "{}..{last}", self.first),
            None => write!(f, "{}..", self.first),
        }
    }
}
