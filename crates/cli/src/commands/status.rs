//! `boundfit status`.

use boundfit_ask::Status;
use clap::Args;
use clap::builder::NonEmptyStringValueParser;

use super::asked::Job;
use crate::exit::{CommandResult, Failure};
use crate::options::{
    BAD_DATA, BAD_USAGE, DataArguments, Notes, OutputArguments, ProofArguments, TableFormat, ThreadArguments,
};

pub(super) const NOTES: Notes = Notes {
    examples: &[
        (
            "The readings of rows 14 to 36 that decide the set, and each reading against the others",
            "boundfit status transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3",
        ),
        (
            "Further readings against this set",
            "boundfit status transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --new new.csv",
        ),
        (
            "If no line agrees with all: which error bounds must be wider, and by how much",
            "boundfit status transducer.csv --x Vz --y z --rows 14..36 --eps 0.2e-3 --repair",
        ),
    ],
    statuses: &[
        (0, "every reading is judged"),
        BAD_DATA,
        BAD_USAGE,
        (
            3,
            "the feasible parameter set is empty; the report names each reading whose removal alone makes it non-empty",
        ),
    ],
};

/// Classify each reading against the full set and the leave-one-out set: inner, boundary, outer, outlier
///
/// Over a set the model takes a range of values at a reading. The leverage l is half this range divided by half the
/// reading's width; the residual r is the distance of both middles divided by the same. Against the full set each
/// reading is inner (|r| < 1 - l) or boundary (|r| = 1 - l). Against the set of the others it may also be outer: it
/// cuts that set. It is strictly outer if any reading with this bound would cut it (l > 1), and an outlier if it
/// leaves nothing (|r| > 1 + l).
#[derive(Debug, Args)]
#[command(after_help = NOTES.to_string())]
pub(crate) struct StatusArguments {
    #[command(flatten)]
    data: DataArguments,
    /// Also judge all readings of this table, with the same columns, against the set; they do not change it
    #[arg(long, value_name = "FILE", value_parser = NonEmptyStringValueParser::new())]
    new: Option<String>,
    /// Also find the least total widening: factors w >= 1 of the error bounds with the smallest sum that leaves a
    /// parameter
    #[arg(long)]
    repair: bool,
    /// List every reading in text, latex and markdown, not only the 40 most important ones
    #[arg(long)]
    all: bool,
    #[command(flatten)]
    proof: ProofArguments,
    #[command(flatten)]
    threads: ThreadArguments,
    #[command(flatten)]
    output: OutputArguments<TableFormat>,
}

impl StatusArguments {
    /// The question.
    fn question(&self) -> Status {
        Status { new: self.new.clone(), repair: self.repair, all: self.all }
    }
}

/// Finds the set, judges every reading by it and writes.
pub(super) fn run(arguments: &StatusArguments) -> CommandResult {
    arguments.threads.set()?;
    if arguments.new.as_deref() == Some("-") && arguments.data.path() == "-" {
        let problem = "DATA and '--new' would both be read from standard input: give one of them a file";
        return Err(Failure::Usage(problem.to_owned()));
    }
    let job = Job::proving(arguments.data.words(), &arguments.output, &arguments.proof)?;
    let beside: Vec<&str> = arguments.new.as_deref().into_iter().collect();
    let mut guard = job.guard(&arguments.output.file.replace, &beside)?;
    job.run(&arguments.question(), &mut guard)
}
