//! The arguments of `boundfit reduce`.

use boundfit_formats::ColumnSelector;
use clap::Args;

use super::notes::{BAD_DATA, BAD_USAGE, Notes};
use super::values::parse_column;
use super::{FileArguments, RowArguments, TableArguments, ThreadArguments};

pub(super) const NOTES: Notes = Notes {
    examples: &[
        (
            "A million rows become a few dozen that give the same feasible set",
            "boundfit reduce readings.csv --x x --y y -o reduced.csv\n\
             boundfit fit reduced.csv --x x --y y --eps 0.01",
        ),
        (
            "Parts reduced apart, put together, and reduced again",
            "cat monday.csv tuesday.csv | boundfit reduce - --x x --y y -o both.csv",
        ),
    ],
    statuses: &[(0, "the reduction is written"), BAD_DATA, BAD_USAGE],
};

/// Keep only the rows that decide every fit of a line: those that touch the convex hull of the readings
///
/// Written are the same columns, each number as it stood, after a line that says how many readings these stand for and
/// the sums that least squares needs. 'boundfit fit' reads the result like the whole: feasible set, PUI, eps_min and
/// least squares are the same for every error bound; only the EUI needs every reading and is left out. Several
/// reductions one after the other, as 'cat' writes them, are a reduction of all their readings, and can be reduced again.
#[derive(Debug, Args)]
#[command(after_help = NOTES.to_string())]
pub(crate) struct ReduceArguments {
    /// A table of readings (text or a MATLAB .mat file), or reductions of such, or - for standard input
    pub(crate) data: String,
    /// Column of x by header name or number from 1
    #[arg(long, value_name = "COL", value_parser = parse_column)]
    pub(crate) x: ColumnSelector,
    /// Column of y
    #[arg(long, value_name = "COL", value_parser = parse_column)]
    pub(crate) y: ColumnSelector,
    /// Column with the error bound of each reading: keep the rows that touch the hull of those with the same bound
    #[arg(long, value_name = "COL", value_parser = parse_column)]
    pub(crate) eps_column: Option<ColumnSelector>,
    #[command(flatten)]
    pub(crate) rows: RowArguments,
    #[command(flatten)]
    pub(crate) table: TableArguments,
    #[command(flatten)]
    pub(crate) threads: ThreadArguments,
    #[command(flatten)]
    pub(crate) file: FileArguments,
}
