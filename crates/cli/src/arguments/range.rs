//! The arguments of `boundfit range`.

use boundfit_estimation::Model;
use boundfit_questions::Order;
use clap::builder::NonEmptyStringValueParser;
use clap::{Args, ValueEnum};

use super::endings::NamedFormat;
use super::notes::{BAD_DATA, BAD_USAGE, Notes};
use super::{DataArguments, OutputArguments, ThreadArguments};
use crate::exit::Failure;

pub(super) const NOTES: Notes = Notes {
    examples: &[
        (
            "Where a sensor is linear to half a millimetre: every run of readings, in order of x, that a line agrees with",
            "boundfit range transducer.csv --x Vz --y z --eps 0.5e-3",
        ),
        (
            "The same as a table; the longest run has 'true' in column longest",
            "boundfit range transducer.csv --x Vz --y z --eps 0.5e-3 --format csv",
        ),
        (
            "How long a clock keeps its pace: runs in the order in which readings were taken",
            "boundfit range clock.csv --x t --lower early --upper late --by-row",
        ),
    ],
    statuses: &[
        (0, "there is a run"),
        BAD_DATA,
        BAD_USAGE,
        (3, "no reading fits, not even alone; the bounds that contradict each other are printed"),
    ],
};

/// Find every run of readings that a line agrees with: the linear range
///
/// A run of readings that follow each other, in order of x or of rows, is linear when some parameters meet all of its bounds,
/// and the conditions. Reported are the runs that cannot be made longer, with the readings that forbid it; the longest, the
/// widest in x, the fewest that have every reading; and the set of the longest run.
#[derive(Debug, Args)]
#[command(after_help = NOTES.to_string())]
pub(crate) struct RangeArguments {
    #[command(flatten)]
    pub(crate) data: DataArguments,
    /// Take readings in order of x, those at the same x in order of rows (what is done for a line)
    #[arg(long)]
    by_x: bool,
    /// Take readings in order of rows (what is done for two regressors)
    #[arg(long, conflicts_with = "by_x")]
    by_row: bool,
    /// Also write a proof of the answer to this file, which 'boundfit verify' checks against the data; - for standard output
    /// when the report goes to a file
    #[arg(long, value_name = "FILE", value_parser = NonEmptyStringValueParser::new())]
    pub(crate) proof: Option<String>,
    #[command(flatten)]
    pub(crate) threads: ThreadArguments,
    #[command(flatten)]
    pub(crate) output: OutputArguments<RangeFormat>,
}

impl RangeArguments {
    /// In which order readings of this model are taken.
    pub(crate) fn order(&self, model: &Model) -> Order {
        match (self.by_x, self.by_row) {
            (true, _) => Order::X,
            (_, true) => Order::Row,
            _ => Order::natural(model),
        }
    }

    /// Refuses an order of x where there is no x.
    pub(crate) fn check_order(&self) -> Result<(), Failure> {
        match self.by_x && self.data.has_two_regressors() {
            true => Err(Failure::Usage(
                "'--by-x' is about a line: two regressors have no order of x; '--by-row' takes them as they stand".to_owned(),
            )),
            false => Ok(()),
        }
    }
}

/// Formats of a linear range, and of windows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub(crate) enum RangeFormat {
    /// A report for people
    #[default]
    Text,
    /// Everything, for programs
    Json,
    /// A table with a row for each run
    Csv,
}

impl NamedFormat for RangeFormat {
    const ENDINGS: &'static [(&'static str, Self)] =
        &[("json", RangeFormat::Json), ("csv", RangeFormat::Csv), ("txt", RangeFormat::Text)];
}
