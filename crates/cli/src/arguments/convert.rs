//! The arguments of `boundfit convert`.

use boundfit_lp::{ExchangeFormat, PuiEnd};
use clap::Args;
use clap::builder::{NonEmptyStringValueParser, PossibleValue};

use super::notes::{BAD_DATA, BAD_USAGE, Notes};
use super::values::{explained, named};
use super::{DataArguments, ReplaceArguments};

pub(super) const NOTES: Notes = Notes {
    examples: &[
        (
            "The four linear programs of a fit, as free MPS",
            "boundfit convert transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --to mps -o programs",
        ),
        (
            "What GLPK makes of them, judged exactly",
            "for f in programs/*.mps; do glpsol --freemps $f -w ${f%.mps}.sol; done\n\
             boundfit check transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --claim programs",
        ),
        (
            "One of them in LP format, with the numbers that a float solver would receive",
            "boundfit convert steam.csv --x x --y y --eps-column eps --reading binary64 \\\n\
             \x20 --to lp --objective theta1-max",
        ),
    ],
    statuses: &[(0, "the programs are written"), BAD_DATA, BAD_USAGE],
};

/// Write the linear programs behind the parameter uncertainty intervals as files for other solvers
///
/// The four programs are the minimum and the maximum of theta1 and of theta2 over the feasible parameter set; a maximum
/// is written as the minimum of the opposite. Each reading gives two rows, named after its data row (row14_upper,
/// row14_lower); each condition gives one (where_1; an equation with =). No number is rounded: it is a finite decimal,
/// or its row is multiplied to whole numbers, as a comment says.
#[derive(Debug, Args)]
#[command(after_help = NOTES.to_string())]
pub(crate) struct ConvertArguments {
    #[command(flatten)]
    pub(crate) data: DataArguments,
    /// Format of the programs. Default: the ending of the output file's name
    #[arg(long, value_parser = explained(ExchangeFormat::ALL.map(|format| {
        (PossibleValue::new(format.name()).help(format.title()), format)
    })))]
    pub(crate) to: Option<ExchangeFormat>,
    /// Write only this program. Default: all four, into a folder
    #[arg(long, value_parser = named(PuiEnd::ALL.map(|end| (end.name(), end))))]
    pub(crate) objective: Option<PuiEnd>,
    /// Write the four programs into this folder, or the program of '--objective' to this file instead of standard
    /// output; each file whole or not at all
    #[arg(short, long, value_name = "DIR|FILE", value_parser = NonEmptyStringValueParser::new())]
    pub(crate) output: Option<String>,
    #[command(flatten)]
    pub(crate) replace: ReplaceArguments,
}
