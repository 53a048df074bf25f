//! `boundfit range`.

use super::asked::Job;
use crate::CommandResult;
use crate::arguments::RangeArguments;

/// Reads the data, finds the runs and writes.
pub(crate) fn run(arguments: &RangeArguments) -> CommandResult {
    arguments.threads.set()?;
    let job = Job {
        data: &arguments.data,
        form: arguments.output.format()?.into(),
        style: arguments.output.style(),
        output: arguments.output.file.output.as_deref(),
        proof: arguments.proof.as_deref(),
    };
    let mut guard = job.guard(&arguments.output.file.replace, &[])?;
    job.run(&arguments.question(), &mut guard)
}
