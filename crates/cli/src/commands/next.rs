//! `boundfit next`.

use super::asked::Job;
use crate::CommandResult;
use crate::arguments::NextArguments;

/// Reads the data, finds where the next reading helps and writes.
pub(crate) fn run(arguments: &NextArguments) -> CommandResult {
    arguments.threads.set()?;
    let job = Job::of(arguments.data.words(), &arguments.output, None)?;
    let mut guard = job.guard(&arguments.output.file.replace, &[])?;
    job.run(&arguments.question()?, &mut guard)
}
