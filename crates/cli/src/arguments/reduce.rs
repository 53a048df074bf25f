//! The arguments of `boundfit reduce`.

use boundfit_ask::Regressors;
use clap::Args;

use super::notes::{BAD_DATA, BAD_USAGE, Notes};
use super::shared::EpsilonArguments;
use super::values::parse_regressors;
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
        (
            "Readings between bounds of their own, of which a fit takes the same columns",
            "boundfit reduce clocks.csv --x t --lower earliest --upper latest -o reduced.csv",
        ),
    ],
    statuses: &[(0, "the reduction is written"), BAD_DATA, BAD_USAGE],
};

/// Keep only the rows that decide: for a line under one error bound, those on the convex hull of the readings
///
/// The output has the same columns, each number as it stood, below a line with the number of readings and the sums for
/// least squares. 'boundfit fit' reads it like the whole file: feasible set, PUI and least squares are the same under
/// all conditions, from any --x-origin and through the origin. Only the EUI is missing, since it needs every reading.
/// If no bound or one number is given, the reduction of a line is valid for every uniform bound; with --eps-column it
/// is valid for every multiple of the bounds, so that eps_min is the same as well. With two regressors, a law, or
/// --lower and --upper it is valid for these bounds only. Several reductions joined by 'cat' are a reduction of all
/// their readings, and can be reduced again.
#[derive(Debug, Args)]
#[command(after_help = NOTES.to_string(), mut_group("EpsilonArguments", |group| group.required(false)))]
pub(crate) struct ReduceArguments {
    /// A table of readings (text or a MATLAB .mat file), or reductions, or - for standard input
    pub(crate) data: String,
    /// Column of x by header name or number from 1; two for the model y = theta1*COL + theta2*COL2 + e
    #[arg(long, value_name = "COL[,COL2]", value_parser = parse_regressors, required = true)]
    pub(super) x: Regressors,
    /// Column of y; optional beside --lower or --upper, where only least squares uses it
    #[arg(long, value_name = "COL", required_unless_present_any = ["lower", "upper"])]
    pub(super) y: Option<String>,
    #[command(flatten)]
    pub(super) epsilon: EpsilonArguments,
    #[command(flatten)]
    pub(crate) rows: RowArguments,
    #[command(flatten)]
    pub(crate) table: TableArguments,
    #[command(flatten)]
    pub(crate) threads: ThreadArguments,
    #[command(flatten)]
    pub(crate) file: FileArguments,
}
