//! The possible problems of a reduction.

use boundfit_exact::{Foreign, ParseNumberError};
use thiserror::Error;

/// The problem with a reduction.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum ReductionError {
    /// A line that begins as it should and goes on otherwise.
    #[error("the line in front of a reduction is not understood: {0}")]
    BadRecord(Foreign),
    /// A line that begins as that of another version of the program.
    #[error("a reduction of format {0:?}, which is not known here (expected 1 to 4)")]
    UnknownFormat(Foreign),
    /// A sum that is not a number, or one beyond a limit.
    #[error("a sum in the line in front of a reduction: {0}")]
    BadSum(#[from] ParseNumberError),
    /// More readings than can be counted.
    #[error("the reductions stand for more than {} readings", usize::MAX)]
    TooManyRows,
    /// Something that cannot be true of any readings beside the rows that follow.
    #[error(
        "the reduction contradicts itself: {what} (was it edited, or made by a former version from grouped digits? make it again from the table)"
    )]
    Contradiction {
        /// The statement of the reduction, and the evidence against it.
        what: &'static str,
    },
    /// More or fewer lines than announced.
    #[error("the reduction from line {line} on announces {announced} lines of readings, but {found} follow")]
    CountMismatch {
        /// The line in front.
        line: u64,
        /// Lines announced.
        announced: usize,
        /// Lines found.
        found: usize,
    },
    /// A line that should begin with a number of readings.
    #[error(
        "line {line} of a reduction does not begin with how many readings it stands for and a blank (expected a whole number \
         from 1 on, or 0 where the row before goes on)"
    )]
    NoCount {
        /// The line.
        line: u64,
    },
    /// Rows that stand for more readings than there were.
    #[error("the reduction from line {line} on has {rows} readings, but its rows stand for {counted}")]
    CountsTooMany {
        /// The line in front.
        line: u64,
        /// The number of readings.
        rows: usize,
        /// The number of readings that the rows stand for.
        counted: u64,
    },
    /// Rows of several lines in reductions of which only some count readings.
    #[error(
        "of reductions with and without counts of readings, those without must have a line for each row: reduce them once more \
         before"
    )]
    RowsOfSeveralLines,
    /// A reduction where a table belongs.
    #[error("this is a reduction, and here every reading is wanted: name the table that it was made from")]
    NotHere,
    /// Bounds that no part of the readings tells.
    #[error(
        "a law with range(y) tells its bounds when all readings are known, so that none of them can be left out before: \
         write the range as a number"
    )]
    LateBounds,
    /// A range of rows of a reduction.
    #[error("no rows of a reduction can be picked: it does not have the numbers that they had")]
    NoRowNumbers,
    /// Rows of a reduction that were passed over while it was read.
    #[error(
        "no row of a reduction can be left out, since each of them decides: say where the table is reduced which lines are skipped or \
         comments, and which words stand for missing values"
    )]
    RowsLeftOut,
    /// A reduction of something else than what is asked for.
    #[error("{what} {has}, not {asked}; reduce the data again for what you ask")]
    NotAsked {
        /// The meaning, as the sentence begins.
        what: &'static str,
        /// The value that the reduction has, ready to be printed.
        has: String,
        /// The request, ready to be printed.
        asked: String,
    },
    /// Reductions of different tables.
    #[error("the reduction from line {line} on differs from the first one in {what}")]
    Different {
        /// The line in front.
        line: u64,
        /// The difference.
        what: &'static str,
    },
}
