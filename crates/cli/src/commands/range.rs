//! `boundfit range`.

use boundfit_ask::Range;
use clap::Args;

use super::asked::Job;
use crate::exit::CommandResult;
use crate::options::{
    BAD_DATA, BAD_USAGE, DataArguments, Notes, OutputArguments, ProofArguments, TableFormat, ThreadArguments,
};

pub(super) const NOTES: Notes = Notes {
    examples: &[
        (
            "Where a sensor is linear to half a millimetre: every run of readings, in order of x, that one line fits",
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

/// Find every run of readings that one line fits: the linear range
///
/// A run of consecutive readings, in order of x or of rows, is linear if some parameters meet all its bounds and the
/// conditions. The report lists the runs that cannot be extended, with the readings that prevent it. It names the
/// longest run, the widest in x, and the fewest runs that cover every reading. It has the set of the longest run.
#[derive(Debug, Args)]
#[command(after_help = NOTES.to_string())]
pub(crate) struct RangeArguments {
    #[command(flatten)]
    data: DataArguments,
    /// Take readings in order of x, those at the same x in order of rows (default for a line)
    #[arg(long)]
    by_x: bool,
    /// Take readings in order of rows (default for two regressors)
    #[arg(long, conflicts_with = "by_x")]
    by_row: bool,
    #[command(flatten)]
    proof: ProofArguments,
    #[command(flatten)]
    threads: ThreadArguments,
    #[command(flatten)]
    output: OutputArguments<TableFormat>,
}

impl RangeArguments {
    /// Returns the question.
    fn question(&self) -> Range {
        let by = match (self.by_x, self.by_row) {
            (true, _) => Some("x".to_owned()),
            (_, true) => Some("row".to_owned()),
            _ => None,
        };
        Range { by }
    }
}

/// Reads the data, finds the runs and writes.
pub(super) fn run(arguments: &RangeArguments) -> CommandResult {
    arguments.threads.set()?;
    let job = Job::proving(arguments.data.words(), &arguments.output, &arguments.proof)?;
    let mut guard = job.guard(&arguments.output.file.replace, &[])?;
    job.run(&arguments.question(), &mut guard)
}
