//! `boundfit next`.

use super::asked::Job;
use crate::CommandResult;
use crate::arguments::NextArguments;

/// Reads the data, finds where the next reading helps and writes.
pub(crate) fn run(arguments: &NextArguments) -> CommandResult {
    arguments.threads.set()?;
    let job = Job {
        data: &arguments.data,
        form: arguments.output.format()?.into(),
        style: arguments.output.style(),
        output: arguments.output.file.output.as_deref(),
        proof: None,
    };
    let mut guard = job.guard(&arguments.output.file.replace, &[])?;
    job.run(&arguments.question()?, &mut guard)
}
