//! The arguments of `boundfit status`.

use boundfit_ask::Status;
use clap::Args;
use clap::builder::NonEmptyStringValueParser;

use super::notes::{BAD_DATA, BAD_USAGE, Notes};
use super::{DataArguments, OutputArguments, TableFormat, ThreadArguments};

pub(super) const NOTES: Notes = Notes {
    examples: &[
        (
            "Which of rows 14 to 36 decide the set, and what it would be to each without it",
            "boundfit status transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3",
        ),
        (
            "Further readings against this set",
            "boundfit status transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --new new.csv",
        ),
        (
            "Which error bounds must be wider, and by how much, where no line meets all",
            "boundfit status transducer.csv --x Vz --y z --rows 14..36 --eps 0.2e-3 --repair",
        ),
    ],
    statuses: &[
        (0, "every reading is judged"),
        BAD_DATA,
        BAD_USAGE,
        (
            3,
            "the feasible parameter set is empty; told is which readings alone can be left out so that it is not",
        ),
    ],
};

/// Judge every reading by what the set of all, and that of the others, say of it: inner, boundary, outer, outlier
///
/// With the values that the model takes over a set at a reading, its leverage l is half their range over half the reading's
/// width, its residual r the distance of both middles over the same. Against the set of all readings each is inner
/// (|r| < 1 - l) or boundary (|r| = 1 - l); against that of the others also outer (it cuts that set), strictly outer (it would
/// wherever it fell: l > 1) or an outlier (|r| > 1 + l: nothing is left).
#[derive(Debug, Args)]
#[command(after_help = NOTES.to_string())]
pub(crate) struct StatusArguments {
    #[command(flatten)]
    pub(crate) data: DataArguments,
    /// Also judge the readings of this table, of the same columns, by the set as it is: all of its rows, which change nothing
    #[arg(long, value_name = "FILE", value_parser = NonEmptyStringValueParser::new())]
    pub(crate) new: Option<String>,
    /// Also find the least total widening: factors w >= 1 of the error bounds, of the smallest sum, under which something
    /// meets all of them
    #[arg(long)]
    pub(crate) repair: bool,
    /// List every reading in text, latex and markdown, not only the 40 that matter most
    #[arg(long)]
    pub(crate) all: bool,
    /// Write the proof of the statuses to this file; 'boundfit verify' checks it
    #[arg(long, value_name = "FILE", value_parser = NonEmptyStringValueParser::new())]
    pub(crate) proof: Option<String>,
    #[command(flatten)]
    pub(crate) threads: ThreadArguments,
    #[command(flatten)]
    pub(crate) output: OutputArguments<TableFormat>,
}

impl StatusArguments {
    /// The question.
    pub(crate) fn question(&self) -> Status {
        Status { new: self.new.clone(), repair: self.repair, all: self.all }
    }
}
