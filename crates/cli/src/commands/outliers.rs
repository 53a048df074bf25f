//! `boundfit outliers`.

use boundfit_ask::Outliers;
use boundfit_exact::Limit;
use boundfit_questions::OutlierLimits;
use clap::Args;

use super::asked::Job;
use crate::exit::CommandResult;
use crate::options::{
    BAD_DATA, BAD_USAGE, DataArguments, Notes, OutputArguments, ProofArguments, TableFormat, ThreadArguments,
    limits, whole,
};

pub(super) const NOTES: Notes = Notes {
    examples: &[
        (
            "The fewest of all 46 readings to leave out for a line within 0.5 mm of the others",
            "boundfit outliers transducer.csv --x Vz --y z --eps 0.5e-3",
        ),
        (
            "How the set grows if up to 3 readings may be missed, as JSON",
            "boundfit outliers readings.csv --x x --y y --eps 0.1 --most 3 --format json",
        ),
        (
            "A picture of the remaining sets",
            "boundfit plot readings.csv --x x --y y --eps 0.1 --figure outliers -o outliers.svg",
        ),
    ],
    statuses: &[
        (0, "the smallest number is found; it may be 0"),
        BAD_DATA,
        BAD_USAGE,
        (3, "the conditions contradict each other, so that leaving readings out does not help"),
    ],
};

/// Find the fewest readings to leave out so that some parameters agree with all others
///
/// A reading is left out with both of its bounds; conditions (--where) are never left out. The report contains the
/// smallest number q, every set of q readings that leaves something, by how much each of its readings is missed, and
/// the remaining polygons. Each set leaves one convex polygon; no two polygons have a point in common. --most adds the
/// ranges, area, pieces and holes of the parameters that miss at most 0, 1, 2 ... readings.
#[derive(Debug, Args)]
#[command(after_help = NOTES.to_string(), mut_arg("limit", limits::with(&[Limit::Fraction, Limit::Sets, Limit::Steps])))]
pub(crate) struct OutliersArguments {
    #[command(flatten)]
    data: DataArguments,
    /// Also report how the set grows if up to Q readings may be missed: pieces, holes, ranges and area for each number
    /// from 0 to Q
    #[arg(long, value_name = "Q", allow_hyphen_values = true, value_parser = whole::<u32>(0, u64::MAX))]
    most: Option<u32>,
    #[command(flatten)]
    proof: ProofArguments,
    #[command(flatten)]
    threads: ThreadArguments,
    #[command(flatten)]
    output: OutputArguments<TableFormat>,
}

impl OutliersArguments {
    /// Returns the question.
    fn question(&self) -> Outliers {
        let OutlierLimits { sets, steps } = self.data.table.limits.outliers();
        Outliers { most: self.most.map(|most| most as usize), max_sets: Some(sets), max_steps: Some(steps) }
    }
}

/// Reads the data, finds the outliers and writes the report.
pub(super) fn run(arguments: &OutliersArguments) -> CommandResult {
    arguments.threads.set()?;
    let job = Job::proving(arguments.data.words(), &arguments.output, &arguments.proof)?;
    let job = Job { style: arguments.data.table.limits.limited(job.style), ..job };
    let mut guard = job.guard(&arguments.output.file.replace, &[])?;
    job.run(&arguments.question(), &mut guard)
}
