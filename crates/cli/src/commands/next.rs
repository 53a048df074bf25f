//! `boundfit next`.

use boundfit_ask::{Given, Next};
use clap::Args;

use super::asked::Job;
use crate::exit::{CommandResult, Failure};
use crate::options::{
    BAD_DATA, BAD_USAGE, DataArguments, Notes, OutputArguments, TableFormat, ThreadArguments,
};

pub(super) const NOTES: Notes = Notes {
    examples: &[
        (
            "Where the next reading certainly makes the set smaller, and the best voltage of those that can be applied",
            "boundfit next transducer.csv --x Vz --y z --rows 14..36 --eps 0.5e-3 --within -10..10",
        ),
        (
            "The voltage that leaves the shortest interval of the slope, with a better instrument",
            "boundfit next transducer.csv --x Vz --y z --eps 0.5e-3 --goal theta1 --new-eps 1e-4",
        ),
    ],
    statuses: &[
        (0, "an answer was found"),
        BAD_DATA,
        BAD_USAGE,
        (3, "the feasible parameter set is empty, and no reading makes it smaller; the proof is printed"),
    ],
};

/// Find where to take the next reading, so that the feasible set certainly gets smaller
///
/// Where the feasible lines are farther apart than twice the error bound, every further reading cuts some of them
/// off. Elsewhere a reading may agree with all of them. The report lists the x where a reading certainly helps.
/// Within a range it names the x whose worst outcome leaves the shortest interval of theta1, of theta2, and the
/// smallest area. All of it is exact.
#[derive(Debug, Args)]
#[command(after_help = NOTES.to_string())]
pub(crate) struct NextArguments {
    #[command(flatten)]
    data: DataArguments,
    /// The range of x in which the reading can be taken, numbers exactly as written [default: the range of the readings]
    #[arg(long, value_name = "LO..HI", allow_hyphen_values = true)]
    within: Option<String>,
    /// Goal of the reading: make small theta1 or theta2 (the length of its interval) or area [default: all three]
    #[arg(long, value_name = "GOAL")]
    goal: Option<String>,
    /// Error bound of the next reading, if it differs from that of the fitted ones
    #[arg(long, value_name = "NUM", allow_hyphen_values = true)]
    new_eps: Option<String>,
    #[command(flatten)]
    threads: ThreadArguments,
    #[command(flatten)]
    output: OutputArguments<TableFormat>,
}

impl NextArguments {
    /// Returns the question.
    fn question(&self) -> Result<Next, Failure> {
        let exact = |text: &str| Given::Exact { exact: text.trim().to_owned() };
        let within = self.within.as_deref().map(|text| {
            let ends = boundfit_ask::ends(text).map(|(lower, upper)| [exact(lower), exact(upper)]);
            let problem = "expected LO..HI, two numbers such as -10..10";
            ends.ok_or_else(|| Failure::value("--within <LO..HI>", text, problem))
        });
        let new_eps = self.new_eps.as_deref().map(exact);
        Ok(Next { within: within.transpose()?, goal: self.goal.clone(), new_eps })
    }
}

/// Reads the data, finds where the next reading helps and writes.
pub(super) fn run(arguments: &NextArguments) -> CommandResult {
    arguments.threads.set()?;
    let job = Job::of(arguments.data.words(), &arguments.output, None)?;
    let mut guard = job.guard(&arguments.output.file.replace, &[])?;
    job.run(&arguments.question()?, &mut guard)
}
