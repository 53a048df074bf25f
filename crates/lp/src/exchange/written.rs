//! A linear program as it stands in a file: every number is a decimal, every name one that readers take.

use std::fmt;

use super::rows::{WrittenRow, WrittenRows};
use crate::model::ObjectiveSense;

/// A program ready to be written.
#[derive(Debug)]
pub(super) struct Written<'a> {
    pub(super) name: &'a str,
    pub(super) sense: ObjectiveSense,
    /// The objective, whose bounds say nothing.
    pub(super) objective: WrittenRow<'a>,
    /// The constant of the objective, and its opposite.
    pub(super) constant: [String; 2],
    pub(super) columns: &'a [WrittenColumn],
    pub(super) rows: &'a WrittenRows,
    /// The remarks at the top.
    pub(super) remarks: Vec<&'a str>,
}

/// A column with its bounds, of which a missing one is infinite.
#[derive(Debug, Clone)]
pub(super) struct WrittenColumn {
    pub(super) name: String,
    pub(super) lower: Option<String>,
    pub(super) upper: Option<String>,
}

/// Writes pieces of a line. Formatting macros take several times as long, which counts where there are 10⁶ lines.
pub(super) fn put(text: &mut impl fmt::Write, pieces: &[&str]) -> fmt::Result {
    pieces.iter().try_for_each(|piece| text.write_str(piece))
}
